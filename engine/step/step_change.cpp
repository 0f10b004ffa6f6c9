#include "step/step_change.h"

#include <algorithm>
#include <array>
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

bool same_motion(const Frame& a, const Frame& b) {
  return a.velocity == b.velocity && a.spin == b.spin && (a.spin == 0 || a.at == b.at);
}
Frame frame_of(const Body& body) {
  return {body.velocity, body.spin, body.centroid};
}

Vec2 linear(const BlockState& state) {
  return {state.velocity[0], state.velocity[1]};
}

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

// Of a block's length; the smaller one where a contact slides, which would fall behind. What is pressed and moves no
// farther than that against what carries it as the step changes, as all do that it presses on, is as good as at rest:
// what its contacts hold counts more than where it flies.
constexpr double as_at_rest = 1e-4, as_at_rest_sliding = 1e-6;
// Of the shorter length, by which a contact slides in what the step gets longer or shorter by. What has come to stand
// at y goes to and fro about it at X, and contacts of it at the limit of friction give way by no more than their
// springs do.
constexpr double as_stuck = 1e-8;
// of a block's length: corners of bonded blocks that a fixity holds at one point come no farther apart
constexpr double one_point = 1e-3;

// What holds parts of a set of blocks, in each direction: the ground, or what moves.
class Holder {
 public:
  void add(const Frame& frame, const std::array<bool, 2>& held = {true, true}) {
    for (size_t d = 0; d < 2; ++d) {
      if (!held[d]) continue;
      Along& along = along_[d];
      along.several = along.several || (along.any && !same_motion(frame, along.frame));
      along.ground = along.ground || same_motion(frame, {});
      along.any = true;
      along.frame = frame;
    }
  }
  bool any() const { return along_[0].any || along_[1].any; }
  // that there is to know, without how the set moves by itself
  bool all() const { return along_[0].one() && along_[1].one(); }
  // Of the set, which by itself moves as `own`.
  Frame frame(const Frame& own) const {
    const Frame x = along_[0].chosen(own), y = along_[1].chosen(own);
    if (same_motion(x, y)) return x;
    return {{x.velocity.x(), y.velocity.y()}};  // a roller, which keeps it from turning
  }

 private:
  struct Along {
    bool any = false, several = false, ground = false;
    Frame frame;
    bool one() const { return any && (!several || ground); }
    Frame chosen(const Frame& own) const { return !one() ? own : several ? Frame{} : frame; }
  };
  std::array<Along, 2> along_;
};

// What carries each body, blocks that hang together by bonds: what it lies on, what holds it, or else itself.
class Carried {
 public:
  Carried(const Model& model, double before, double after)
      : model_(model),
        before_(before),
        after_(after),
        body_of_(model.fragment),
        count_(body_count(body_of_)),
        way_(count_, Way::flies),
        frame_(count_) {
    lie();
    const std::vector<Holder> holders = fixed(body_of_);
    bodies_ = moving(body_of_, [this](int k) { return way_[size_t(k)] != Way::lies; });
    const std::vector<Pins> pins = pinned();
    for (size_t k = 0; k < count_; ++k) {
      if (way_[k] == Way::lies) continue;
      frame_[k] = frame_of(bodies_[k]);
      if (holders[k].any() || pins[k].several) {
        frame_[k] = (holders[k].any() ? holders[k] : pins[k].holder).frame(frame_[k]);
        way_[k] = Way::is_held;
      } else if (pins[k].both) {
        frame_[k] = {pins[k].speed, bodies_[k].spin, pins[k].at};
      }
    }
  }

  bool moves(int block) const { return model_.shapes[size_t(block)].dofs > 0 && !model_.sleeps(block); }
  bool flies(int block) const { return moves(block) && way_[body(block)] == Way::flies; }
  const Frame& by(int block) const { return frame_[body(block)]; }
  // Those that do not lie, before their blocks move; those that fly, as they are in `blocks`. Others are nought.
  const std::vector<Body>& bodies() const { return bodies_; }
  std::vector<Body> flying(const std::vector<BlockState>& blocks) const {
    std::vector<int> of = body_of_;
    for (size_t b = 0; b < of.size(); ++b)
      if (!flies(int(b))) of[b] = -1;
    return bodies_of(model_, blocks, of, count_);
  }
  size_t body(int block) const { return size_t(body_of_[size_t(block)]); }

 private:
  enum class Way : char { flies, is_held, lies };

  // In all of what presses on each other: what keeps y beside what does not would have their contact pressed by what
  // the one moves.
  void lie() {
    DisjointSets heaps(count_);
    std::vector<char> pressed(count_), slides(count_), fast(count_);
    for (const Contact& c : model_.awake_contacts()) {
      if (c.normal_force <= 0) continue;
      for (const int b : {c.i, c.j}) {
        pressed[body(b)] = 1;
        if (slips(c)) slides[body(b)] = 1;
      }
      if (moves(c.i) && moves(c.j)) heaps.join(int(body(c.i)), int(body(c.j)));
    }
    std::vector<int> heap_of = body_of_;
    for (int& k : heap_of) k = pressed[size_t(k)] ? heaps.root(k) : k;
    const std::vector<Frame> frames = frames_of_heaps(heap_of, pressed);
    for (size_t b = 0; b < heap_of.size(); ++b) {
      const size_t heap = size_t(heap_of[b]), own = body(int(b));
      if (pressed[own] && moves(int(b)) && !slow(int(b), frames[heap], slides[own] ? as_at_rest_sliding : as_at_rest))
        fast[heap] = 1;
    }
    for (size_t k = 0; k < count_; ++k) {
      const size_t heap = size_t(heaps.root(int(k)));
      if (!pressed[k] || fast[heap]) continue;
      way_[k] = Way::lies;
      frame_[k] = frames[heap];
    }
  }

  // Of what holds them, also by lying under them; where nothing does, their own.
  std::vector<Frame> frames_of_heaps(const std::vector<int>& heap_of, const std::vector<char>& pressed) const {
    std::vector<Holder> holders = fixed(heap_of);
    for (const Contact& c : model_.awake_contacts()) {
      if (c.normal_force <= 0) continue;
      for (const auto& [held, other] : {std::pair(c.i, c.j), std::pair(c.j, c.i)})
        if (model_.shapes[size_t(held)].dofs == 0) holders[size_t(heap_of[size_t(other)])].add(frame_of_held(held));
    }
    const std::vector<Body> own =
        moving(heap_of, [&](int k) { return pressed[size_t(k)] && !holders[size_t(k)].all(); });
    std::vector<Frame> frames(count_);
    for (size_t k = 0; k < count_; ++k) frames[k] = holders[k].frame(frame_of(own[k]));
    return frames;
  }

  // What fixities hold of each set of blocks.
  std::vector<Holder> fixed(const std::vector<int>& set_of) const {
    std::vector<Holder> holders(count_);
    if (!model_.joints.empty())
      for (const int b : model_.held_blocks) holders[size_t(set_of[size_t(b)])].add(frame_of_held(b));
    // before the first step supports are unstrained at X, which stays
    if (model_.support_speeds.empty()) return holders;
    for (const EdgeFixity& edge : model_.edge_fixities) {
      const Fixity& fixity = model_.scene.fixities[size_t(edge.fixity)];
      holders[size_t(set_of[size_t(edge.block)])].add(frame_of_support(edge.fixity), fixity.held);
    }
    return holders;
  }
  Frame frame_of_held(int block) const {  // as the last step ended: so do contacts find its y
    const BlockState& state = model_.blocks[size_t(block)];
    return {linear(state) + model_.rising(block), state.velocity[2] / model_.shapes[size_t(block)].length,
            state.centroid};
  }
  Frame frame_of_support(int fixity) const {  // likewise
    return {model_.support_speeds[size_t(fixity)]};
  }

  // The points at which a body is held.
  struct Pins {
    Holder holder;
    bool several = false;
    bool both = false;  // directions, at the first, about which a body turns that is held at no other
    Vec2 at = Vec2::Zero(), speed = Vec2::Zero();
  };
  std::vector<Pins> pinned() const {
    std::vector<Pins> pins(count_);
    if (model_.support_speeds.empty()) return pins;
    for (const PointFixity& point : model_.point_fixities) {
      Pins& of = pins[body(point.block)];
      const Frame frame = frame_of_support(point.fixity);
      const Vec2 at = model_.place(point.block, point.in_block);
      const auto& held = model_.scene.fixities[size_t(point.fixity)].held;
      if (!of.holder.any()) of = {{}, false, held[0] && held[1], at, frame.velocity};
      of.holder.add(frame, held);
      of.several = of.several || (at - of.at).norm() > one_point * model_.shapes[size_t(point.block)].length;
    }
    return pins;
  }

  // Those sets of blocks that are asked for, as they move by themselves.
  template <class Asked>
  std::vector<Body> moving(std::vector<int> set_of, Asked&& asked) const {
    for (size_t b = 0; b < set_of.size(); ++b)
      if (!moves(int(b)) || !asked(set_of[b])) set_of[b] = -1;
    return bodies_of(model_, model_.blocks, set_of, count_);
  }

  bool slips(const Contact& c) const {
    const double length = std::min(model_.shapes[size_t(c.i)].length, model_.shapes[size_t(c.j)].length);
    return c.state == ContactState::slip && std::abs(c.slid * (after_ - before_)) > as_stuck * length * before_;
  }

  bool slow(int block, const Frame& carried, double part) const {
    const BlockShape& shape = model_.shapes[size_t(block)];
    const BlockState& state = model_.blocks[size_t(block)];
    const double speed = (linear(state) - carried.velocity_at(state.centroid)).norm(),
                 spin = state.velocity[2] / shape.length - carried.spin;
    return std::abs(before_ - after_) * (speed + std::abs(spin) * shape.radius) <= part * shape.length;
  }

  const Model& model_;
  const double before_, after_;  // s, y ahead of X
  const std::vector<int>& body_of_;
  const size_t count_;
  std::vector<Way> way_;
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
    move(model.shapes[b], seconds, carried.by(int(b)), blocks[b]);
  }
  // What has moved outwards turns more slowly.
  const std::vector<Body> moved = carried.flying(blocks);
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (!carried.flies(int(b))) continue;
    const Body &was = carried.bodies()[carried.body(int(b))], &is = moved[carried.body(int(b))];
    const double faster = was.spin * was.inertia / is.inertia - is.spin;
    const Vec2 turn = faster * perp(Vec2(blocks[b].centroid - is.centroid));
    blocks[b].velocity[0] += turn.x();
    blocks[b].velocity[1] += turn.y();
    blocks[b].velocity[2] += faster * model.shapes[b].length;
  }
  return blocks;
}

}  // namespace talus
