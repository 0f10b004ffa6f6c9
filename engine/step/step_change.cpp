#include "step/step_change.h"

#include <algorithm>
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
  bool one() const { return any_ && (!several_ || ground_); }  // the ground, where that is among several
  Frame frame(const Frame& own) const { return !one() ? own : several_ ? Frame{} : frame_; }  // own: as the set moves by itself

 private:
  bool any_ = false, several_ = false, ground_ = false;
  Frame frame_;
};

// What carries each body, blocks that hang together by bonds: what it lies on, what holds it, or else itself.
class Carried {
 public:
  Carried(const Model& model, double before, double after) : model_(model), before_(before), after_(after), body_of_(bodies_in(model)) {
    const size_t count = size_t(*std::ranges::max_element(body_of_)) + 1;
    holder_.resize(count);
    if (!model_.joints.empty()) {  // a block by itself flies
      for (const int b : model_.held_blocks) holder_[body(b)].add(held_frame(b));
      for (const EdgeFixity& edge : model_.edge_fixities) holder_[body(edge.block)].add(edge_frame(edge));
    }
    find_lying(count);
    for (size_t b = 0; b < body_of_.size(); ++b) alone_.push_back(lying_[body(int(b))] || !moves(int(b)) ? -1 : body_of_[b]);
    bodies_ = bodies_of(model_, model_.blocks, alone_);
    for (size_t k = 0; k < bodies_.size(); ++k)
      if (!lying_[k]) frame_[k] = holder_[k].frame(frame_of(bodies_[k]));
    // What does not yet move with its edge would be thrown by as much as it lags: it keeps its own y.
    for (size_t b = 0; b < alone_.size(); ++b) {
      Frame& frame = frame_[body(int(b))];
      if (alone_[b] >= 0 && holder_[body(int(b))].any() && !slow(model_.shapes[b], model_.blocks[b], frame, before_ - after_, as_at_rest)) frame = {};
    }
  }
  bool moves(int block) const { return model_.shapes[size_t(block)].dofs > 0 && !model_.sleeps(block); }
  const Frame& by(int block) const { return frame_[body(block)]; }
  bool flies(int block) const { return alone_[size_t(block)] >= 0 && !holder_[body(block)].any(); }
  // Per block its body, or -1 where that lies on something; these bodies, before their blocks move.
  const std::vector<int>& alone() const { return alone_; }
  const std::vector<Body>& bodies() const { return bodies_; }

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

  // Which bodies lie on something, slow as above in all their blocks and in all that press on each other with them: one that keeps y beside
  // one that does not would have their contact pressed by what the one moves. With frames of those.
  void find_lying(size_t count) {
    std::vector<char> pressed(count), slides(count), fast(count);
    DisjointSets heaps(count);
    for (const Contact& c : model_.awake_contacts()) {
      if (c.normal_force <= 0) continue;
      for (const int b : {c.i, c.j}) {
        pressed[body(b)] = 1;
        if (c.state == ContactState::slip) slides[body(b)] = 1;
      }
      if (moves(c.i) && moves(c.j)) heaps.join(int(body(c.i)), int(body(c.j)));
    }
    frame_ = frames_of_heaps(heaps, pressed);
    for (size_t b = 0; b < model_.blocks.size(); ++b) {
      const size_t own = body(int(b)), heap = size_t(heaps.root(int(own)));
      if (!pressed[own] || !moves(int(b))) continue;
      if (!slow(model_.shapes[b], model_.blocks[b], frame_[heap], before_ - after_, slides[own] ? as_at_rest_sliding : as_at_rest)) fast[heap] = 1;
    }
    for (size_t k = 0; k < count; ++k) {
      const size_t heap = size_t(heaps.root(int(k)));  // the least of its bodies: its frame stands there, and stays
      lying_.push_back(pressed[k] && !fast[heap]);
      if (lying_[k]) frame_[k] = frame_[heap];
    }
  }

  // By the first body of each heap: of what holds it, or where nothing does, its own.
  std::vector<Frame> frames_of_heaps(DisjointSets& heaps, const std::vector<char>& pressed) const {
    std::vector<Holder> holder(pressed.size());
    const auto heap = [&](int block) { return size_t(heaps.root(int(body(block)))); };
    for (const EdgeFixity& edge : model_.edge_fixities) holder[heap(edge.block)].add(edge_frame(edge));
    if (!model_.joints.empty())
      for (const int b : model_.held_blocks) holder[heap(b)].add(held_frame(b));
    for (const Contact& c : model_.awake_contacts()) {
      if (c.normal_force <= 0) continue;
      for (const auto& [held, other] : {std::pair(c.i, c.j), std::pair(c.j, c.i)})
        if (model_.shapes[size_t(held)].dofs == 0) holder[heap(other)].add(held_frame(held));
    }
    std::vector<int> free(body_of_.size(), -1);
    for (size_t b = 0; b < free.size(); ++b)
      if (pressed[body(int(b))] && moves(int(b)) && !holder[heap(int(b))].one()) free[b] = int(heap(int(b)));
    const std::vector<Body> own = bodies_of(model_, model_.blocks, free);
    std::vector<Frame> frames(pressed.size());
    for (size_t k = 0; k < frames.size(); ++k) frames[k] = holder[k].frame(k < own.size() ? frame_of(own[k]) : Frame{});
    return frames;
  }

  const Model& model_;
  const double before_, after_;  // s, y ahead of X
  std::vector<int> body_of_, alone_;
  std::vector<Holder> holder_;  // per body
  std::vector<char> lying_;
  std::vector<Frame> frame_;
  std::vector<Body> bodies_;
};

}  // namespace

std::vector<BlockState> keep_stored(const Model& model, double before, double after) {
  const double seconds = before - after;
  std::vector<BlockState> blocks = model.blocks;
  const Carried carried(model, before, after);
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (!carried.moves(int(b))) continue;
    deform(model.shapes[b], seconds, blocks[b]);
    if (carried.flies(int(b)))
      move(model.shapes[b], seconds, carried.by(int(b)), blocks[b]);
    else
      move_whole(model.shapes[b], seconds, carried.by(int(b)), model.scene.gravity, blocks[b]);
  }
  // What has moved outwards turns more slowly.
  const std::vector<Body> moved = bodies_of(model, blocks, carried.alone());
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (!carried.flies(int(b))) continue;
    const size_t body = size_t(carried.alone()[b]);
    const Body &was = carried.bodies()[body], &is = moved[body];
    const double faster = was.spin * was.inertia / is.inertia - is.spin;
    const Vec2 turn = faster * perp(Vec2(blocks[b].centroid - is.centroid));
    blocks[b].velocity[0] += turn.x();
    blocks[b].velocity[1] += turn.y();
    blocks[b].velocity[2] += faster * model.shapes[b].length;
  }
  return blocks;
}

}  // namespace talus
