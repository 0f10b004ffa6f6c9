#include "step/step_change.h"

#include <cmath>

#include "equations/block_terms.h"
#include "model/disjoint_sets.h"
#include "step/bodies.h"

namespace talus {

namespace {

// Where something is carried to: velocity at a point, and spin.
struct Frame {
  Vec2 velocity = Vec2::Zero();
  double spin = 0;
  Vec2 at = Vec2::Zero();  // about which it turns
  Vec2 velocity_at(const Vec2& point) const { return velocity + spin * perp(Vec2(point - at)); }
};

bool operator==(const Frame& a, const Frame& b) { return a.velocity == b.velocity && a.spin == b.spin && (a.spin == 0 || a.at == b.at); }
Frame frame_of(const Body& body) { return {body.velocity, body.spin, body.centroid}; }

Vec2 linear(const BlockState& state) { return {state.velocity[0], state.velocity[1]}; }

void deform(const BlockShape& shape, double seconds, BlockState& state) {
  if (shape.dofs <= rigid_dofs) return;
  const auto& v = state.velocity;
  state.strain += seconds / shape.length * Vec3(v[3], v[4], v[5]);
  for (size_t k = 0; state.bend && k < state.bend->size(); ++k) (*state.bend)[k] += seconds * v[first_order_dofs + k];
}

// By how it moves against `carried`.
void move(const BlockShape& shape, double seconds, const Frame& carried, BlockState& state) {
  const Vec2 way = seconds * (linear(state) - carried.velocity_at(state.centroid));
  state.shift += way;
  state.centroid = shape.reference_centroid + state.shift;
  state.angle += seconds * (state.velocity[2] / shape.length - carried.spin);
}

// As a whole: it stays at y of what carries it, and likewise where it is weighed.
void move_whole(const BlockShape& shape, double seconds, const Frame& carried, const Vec2& gravity, BlockState& state) {
  const double falls = gravity.dot(linear(state)), against = falls - gravity.dot(carried.velocity_at(state.centroid));
  move(shape, seconds, carried, state);
  state.weighed_ahead -= seconds * (std::abs(against) < std::abs(falls) ? against / falls : 1);
}

// Of a block's length; the smaller one where a contact slides, which would fall behind. What is pressed and moves no farther than that against what carries it
// as the step changes, as all do that it presses on, is as good as at rest: what its contacts hold counts more than where it flies.
constexpr double as_at_rest = 1e-4, as_at_rest_sliding = 1e-6;

bool slow(const BlockShape& shape, const BlockState& state, const Frame& carried, double seconds, double part) {
  const double speed = (linear(state) - carried.velocity_at(state.centroid)).norm(), spin = state.velocity[2] / shape.length - carried.spin;
  return std::abs(seconds) * (speed + std::abs(spin) * shape.radius) <= part * shape.length;
}

// What holds parts of a set of blocks: the ground, or what moves.
class Holder {
 public:
  void add(const Frame& frame) {
    several_ = several_ || (any_ && frame != frame_);
    ground_ = ground_ || frame == Frame{};
    any_ = true;
    frame_ = frame;
  }
  bool any() const { return any_; }
  // Of the set, that moves by itself as `own`: by the ground, where that is among several.
  Frame frame(const Frame& own) const { return !any_ ? own : !several_ ? frame_ : ground_ ? Frame{} : own; }

 private:
  bool any_ = false, several_ = false, ground_ = false;
  Frame frame_;
};

class Carried {
 public:
  Carried(const Model& model, double before, double after)
      : model_(model), before_(before), after_(after), body_of_(bodies_in(model)), bodies_(bodies_of(model, model.blocks, body_of_)), body_holder_(bodies_.size()) {
    find_holders();
    find_lying();
  }
  const std::vector<int>& body_of() const { return body_of_; }
  const std::vector<Body>& bodies() const { return bodies_; }
  bool held(int block) const { return body_holder_[body(block)].any(); }
  bool lies(int block) const { return lying_[body(block)]; }
  // Of what lies on something the motion of that; of what is held that of its holder; of what flies its own.
  const Frame& of(int block) const { return carried_[body(block)]; }

 private:
  size_t body(int block) const { return size_t(body_of_[size_t(block)]); }
  Frame held_frame(int block) const {  // as the last step ended: so do contacts find its y
    const BlockState& state = model_.blocks[size_t(block)];
    return {linear(state) + model_.rising(block), state.velocity[2] / model_.shapes[size_t(block)].length, state.centroid};
  }
  Frame edge_frame(const EdgeFixity& edge) const {  // from the one y to the other: supports go by where their fixity is then
    const Fixity& of = model_.scene.fixities[size_t(edge.fixity)];
    return {(of.moved(model_.time + before_) - of.moved(model_.time + after_)) / (before_ - after_)};
  }

  void find_holders() {
    for (const int b : model_.held_blocks) body_holder_[body(b)].add(held_frame(b));
    for (const EdgeFixity& edge : model_.edge_fixities) body_holder_[body(edge.block)].add(edge_frame(edge));
  }

  // Which bodies lie on something, slow as above in all their blocks and in all that press on each other with them: one that keeps y beside
  // one that does not would have their contact pressed by what the one moves.
  void find_lying() {
    const auto free = [this](int block) { return model_.shapes[size_t(block)].dofs > 0; };
    std::vector<char> pressed(bodies_.size()), slides(bodies_.size()), fast(bodies_.size());
    DisjointSets heaps(bodies_.size());
    for (const Contact& c : model_.awake_contacts()) {
      if (c.normal_force <= 0) continue;
      for (const int b : {c.i, c.j}) {
        pressed[body(b)] = 1;
        if (c.state == ContactState::slip) slides[body(b)] = 1;
      }
      if (free(c.i) && free(c.j)) heaps.join(int(body(c.i)), int(body(c.j)));
    }
    const std::vector<Frame> heap_frame = frames_of_heaps(heaps);
    for (size_t b = 0; b < model_.blocks.size(); ++b) {
      if (!free(int(b))) continue;
      const int heap = heaps.root(int(body(int(b))));
      if (!slow(model_.shapes[b], model_.blocks[b], heap_frame[size_t(heap)], before_ - after_, slides[body(int(b))] ? as_at_rest_sliding : as_at_rest)) fast[size_t(heap)] = 1;
    }
    for (size_t k = 0; k < bodies_.size(); ++k) {
      const size_t heap = size_t(heaps.root(int(k)));
      lying_.push_back(pressed[k] && !fast[heap]);
      carried_.push_back(lying_[k] ? heap_frame[heap] : body_holder_[k].frame(frame_of(bodies_[k])));
    }
  }

  // Of what holds each heap, or where nothing does, its own.
  std::vector<Frame> frames_of_heaps(DisjointSets& heaps) const {
    std::vector<Holder> holder(bodies_.size());
    for (const int b : model_.held_blocks) holder[body(b)] = body_holder_[body(b)];
    for (const EdgeFixity& edge : model_.edge_fixities) holder[size_t(heaps.root(int(body(edge.block))))].add(edge_frame(edge));
    for (const Contact& c : model_.awake_contacts()) {
      if (c.normal_force <= 0) continue;
      for (const auto& [held, other] : {std::pair(c.i, c.j), std::pair(c.j, c.i)})
        if (model_.shapes[size_t(held)].dofs == 0) holder[size_t(heaps.root(int(body(other))))].add(held_frame(held));
    }
    std::vector<int> heap_of;
    for (const int b : body_of_) heap_of.push_back(heaps.root(b));
    const std::vector<Body> own = bodies_of(model_, model_.blocks, heap_of);
    std::vector<Frame> frames(bodies_.size());
    for (size_t k = 0; k < frames.size(); ++k)
      if (heaps.root(int(k)) == int(k)) frames[k] = holder[k].frame(frame_of(own[k]));
    return frames;
  }

  const Model& model_;
  const double before_, after_;  // s, y ahead of X
  std::vector<int> body_of_;
  std::vector<Body> bodies_;
  std::vector<Holder> body_holder_;  // per body
  std::vector<Frame> carried_;
  std::vector<char> lying_;
};

}  // namespace

std::vector<BlockState> keep_stored(const Model& model, double before, double after) {
  const double seconds = before - after;
  std::vector<BlockState> blocks = model.blocks;
  const Carried carried(model, before, after);
  const auto moves = [&model](size_t b) { return model.shapes[b].dofs > 0 && !model.sleeps(int(b)); };
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (!moves(b)) continue;
    deform(model.shapes[b], seconds, blocks[b]);
    if (carried.lies(int(b)) || carried.held(int(b)))
      move_whole(model.shapes[b], seconds, carried.of(int(b)), model.scene.gravity, blocks[b]);
    else
      move(model.shapes[b], seconds, carried.of(int(b)), blocks[b]);
  }
  // What has moved outwards turns more slowly.
  const std::vector<Body> moved = bodies_of(model, blocks, carried.body_of());
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Body &was = carried.bodies()[size_t(carried.body_of()[b])], &is = moved[size_t(carried.body_of()[b])];
    if (!moves(b) || carried.lies(int(b)) || carried.held(int(b))) continue;
    const double faster = was.spin * was.inertia / is.inertia - is.spin;
    const Vec2 turn = faster * perp(Vec2(blocks[b].centroid - is.centroid));
    blocks[b].velocity[0] += turn.x();
    blocks[b].velocity[1] += turn.y();
    blocks[b].velocity[2] += faster * model.shapes[b].length;
  }
  return blocks;
}

}  // namespace talus
