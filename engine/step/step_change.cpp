#include "step/step_change.h"

#include <cmath>

#include "equations/block_terms.h"
#include "model/disjoint_sets.h"
#include "step/bodies.h"

namespace talus {

namespace {

double own_inertia(const Model& model, int b, const BlockState& state) {
  return moment_of_inertia(model, b, state.strain, state.bend);
}

void deform(const BlockShape& shape, double seconds, BlockState& state) {
  if (shape.dofs <= rigid_dofs) return;
  const auto& v = state.velocity;
  state.strain += seconds / shape.length * Vec3(v[3], v[4], v[5]);
  for (size_t k = 0; state.bend && k < state.bend->size(); ++k) (*state.bend)[k] += seconds * v[first_order_dofs + k];
}

void move(const BlockShape& shape, double seconds, const Vec2& velocity, double spin, BlockState& state) {
  state.shift += seconds * velocity;
  state.centroid = shape.reference_centroid + state.shift;
  state.angle += seconds * spin;
}

// As a whole: y stays, also the y at which it is weighed.
void move_whole(const BlockShape& shape, double seconds, BlockState& state) {
  move(shape, seconds, Vec2(state.velocity[0], state.velocity[1]), state.velocity[2] / shape.length, state);
  state.weighed_ahead -= seconds;
}

// Of a block's length; the smaller one where a contact slides, which would fall behind. What is pressed and moves no farther than that as the step changes, as all do that it presses on, is as good as at rest:
// what its contacts hold counts more than where it flies.
constexpr double as_at_rest = 1e-4, as_at_rest_sliding = 1e-6;

bool slow(const BlockShape& shape, const BlockState& state, double seconds, double part) {
  const auto& v = state.velocity;
  return std::abs(seconds) * (std::hypot(v[0], v[1]) + std::abs(v[2]) * shape.radius / shape.length) <= part * shape.length;
}

// Per body, whether it lies on something, slow as above in all its blocks and in all that press on each other with it: one that keeps y beside
// one that does not would have their contact pressed by what the one moves.
std::vector<bool> find_lying(const Model& model, double seconds, const std::vector<int>& body_of) {
  std::vector<bool> pressed(model.blocks.size()), slides(model.blocks.size()), fast(model.blocks.size());
  DisjointSets heaps(model.blocks.size());
  for (const Contact& c : model.awake_contacts()) {
    if (c.normal_force <= 0) continue;
    const int a = body_of[size_t(c.i)], b = body_of[size_t(c.j)];
    pressed[size_t(a)] = pressed[size_t(b)] = true;
    if (c.state == ContactState::slip) slides[size_t(a)] = slides[size_t(b)] = true;
    if (model.shapes[size_t(c.i)].dofs > 0 && model.shapes[size_t(c.j)].dofs > 0) heaps.join(a, b);
  }
  for (size_t b = 0; b < model.blocks.size(); ++b)
    if (!slow(model.shapes[b], model.blocks[b], seconds, slides[size_t(body_of[b])] ? as_at_rest_sliding : as_at_rest)) fast[size_t(heaps.root(body_of[b]))] = true;
  std::vector<bool> lying(model.blocks.size());
  for (size_t body = 0; body < lying.size(); ++body) lying[body] = pressed[body] && !fast[size_t(heaps.root(int(body)))];
  return lying;
}

// Per body, whether it does not fly: by a held block or along an edge, or as it lies on something.
std::vector<bool> find_held(const Model& model, const std::vector<int>& body_of, std::vector<bool> lying) {
  for (size_t b = 0; b < body_of.size(); ++b)
    if (model.shapes[b].dofs == 0) lying[size_t(body_of[b])] = true;
  for (const EdgeFixity& edge : model.edge_fixities) lying[size_t(body_of[size_t(edge.block)])] = true;
  return lying;
}

// Blocks of bodies against each other. What has moved outwards turns more slowly.
void move_apart(const Model& model, double seconds, const std::vector<int>& body_of, const std::vector<bool>& lying,
                std::vector<BlockState>& blocks) {
  const std::vector<Body> before = bodies_of(model, model.blocks, body_of);
  const std::vector<bool> held = find_held(model, body_of, lying);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const BlockShape& shape = model.shapes[b];
    const Body& body = before[size_t(body_of[b])];
    if (shape.dofs == 0 || model.sleeps(int(b))) continue;
    BlockState& state = blocks[b];
    if (held[size_t(body_of[b])]) {
      move_whole(shape, seconds, state);
      continue;
    }
    const Vec2 velocity(state.velocity[0], state.velocity[1]);
    move(shape, seconds, velocity - body.velocity - body.spin * perp(Vec2(state.centroid - body.centroid)),
         state.velocity[2] / shape.length - body.spin, state);
  }
  const std::vector<Body> after = bodies_of(model, blocks, body_of);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Body &was = before[size_t(body_of[b])], &is = after[size_t(body_of[b])];
    if (model.shapes[b].dofs == 0 || model.sleeps(int(b)) || held[size_t(body_of[b])]) continue;
    const double faster = was.spin * was.inertia / is.inertia - is.spin;
    const Vec2 turn = faster * perp(Vec2(blocks[b].centroid - is.centroid));
    blocks[b].velocity[0] += turn.x();
    blocks[b].velocity[1] += turn.y();
    blocks[b].velocity[2] += faster * model.shapes[b].length;
  }
}

}  // namespace

std::vector<BlockState> keep_stored(const Model& model, double seconds) {
  std::vector<BlockState> blocks = model.blocks;
  const std::vector<int> body_of = bodies_in(model);
  const std::vector<bool> lying = find_lying(model, seconds, body_of);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const BlockShape& shape = model.shapes[b];
    BlockState& state = blocks[b];
    if (shape.dofs == 0 || model.sleeps(int(b))) continue;
    deform(shape, seconds, state);
    if (!model.joints.empty()) continue;
    if (lying[b])
      move_whole(shape, seconds, state);
    else if (state.velocity[2] != 0)
      state.velocity[2] *= own_inertia(model, int(b), model.blocks[b]) / own_inertia(model, int(b), state);
  }
  if (!model.joints.empty()) move_apart(model, seconds, body_of, lying, blocks);
  return blocks;
}

}  // namespace talus
