#include "step/step_change.h"

#include "equations/block_terms.h"
#include "fracture/cracks.h"

namespace talus {

namespace {

struct Body {
  double mass = 0, inertia = 0;        // kg/m, kg m
  Vec2 centroid = Vec2::Zero(), velocity = Vec2::Zero();
  double spin = 0;                     // rad/s
  bool held = false;                   // by a held block or along an edge: it does not fly
};

double own_inertia(const Model& model, int b, const BlockState& state) {
  return moment_of_inertia(model, b, state.strain, state.bend);
}

// What hangs together by bonds. `body_of`: per block.
std::vector<Body> bodies_of(const Model& model, const std::vector<BlockState>& blocks, const std::vector<int>& body_of) {
  std::vector<Body> bodies;
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (body_of[b] >= int(bodies.size())) bodies.resize(size_t(body_of[b]) + 1);
    Body& body = bodies[size_t(body_of[b])];
    const double mass = model.mass(int(b));
    body.held = body.held || model.shapes[b].dofs == 0;
    body.mass += mass;
    body.centroid += mass * blocks[b].centroid;
    body.velocity += mass * Vec2(blocks[b].velocity[0], blocks[b].velocity[1]);
  }
  for (Body& body : bodies) {
    body.centroid /= body.mass;
    body.velocity /= body.mass;
  }
  for (size_t b = 0; b < blocks.size(); ++b) {
    Body& body = bodies[size_t(body_of[b])];
    const BlockState& state = blocks[b];
    const Vec2 arm = state.centroid - body.centroid, v(state.velocity[0], state.velocity[1]);
    const double mass = model.mass(int(b)), own = own_inertia(model, int(b), state);
    body.spin += mass * cross(arm, Vec2(v - body.velocity)) + own * state.velocity[2] / model.shapes[b].length;
    body.inertia += own + mass * arm.squaredNorm();
  }
  for (Body& body : bodies) body.spin /= body.inertia;
  for (const EdgeFixity& edge : model.edge_fixities) bodies[size_t(body_of[size_t(edge.block)])].held = true;
  for (Body& body : bodies)
    if (body.held) body.velocity = Vec2::Zero(), body.spin = 0;
  return bodies;
}

void deform(const BlockShape& shape, double seconds, BlockState& state) {
  if (shape.dofs <= rigid_dofs) return;
  const auto& v = state.velocity;
  state.strain += seconds / shape.length * Vec3(v[3], v[4], v[5]);
  for (size_t k = first_order_dofs; k < size_t(shape.rate_count()); ++k) state.bend[k - first_order_dofs] += seconds * v[k];
}

// Blocks of bodies against each other. What has moved outwards turns more slowly.
void move_apart(const Model& model, double seconds, std::vector<BlockState>& blocks) {
  const std::vector<int> body_of = model.fragment.empty() ? find_fragments(model) : model.fragment;
  const std::vector<Body> before = bodies_of(model, model.blocks, body_of);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const BlockShape& shape = model.shapes[b];
    const Body& body = before[size_t(body_of[b])];
    if (shape.dofs == 0 || model.sleeps(int(b))) continue;
    BlockState& state = blocks[b];
    state.shift += seconds * (Vec2(state.velocity[0], state.velocity[1]) - body.velocity - body.spin * perp(Vec2(state.centroid - body.centroid)));
    state.centroid = shape.reference_centroid + state.shift;
    state.angle += seconds * (state.velocity[2] / shape.length - body.spin);
  }
  const std::vector<Body> after = bodies_of(model, blocks, body_of);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Body &was = before[size_t(body_of[b])], &is = after[size_t(body_of[b])];
    if (model.shapes[b].dofs == 0 || model.sleeps(int(b)) || was.held) continue;
    const double faster = was.spin * was.inertia / is.inertia - is.spin;
    const Vec2 turn = faster * perp(Vec2(blocks[b].centroid - is.centroid));
    blocks[b].velocity[0] += turn.x();
    blocks[b].velocity[1] += turn.y();
    blocks[b].velocity[2] += faster * model.shapes[b].length;
  }
}

}  // namespace

std::vector<BlockState> keep_deformation(const Model& model, double seconds) {
  std::vector<BlockState> blocks = model.blocks;
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (model.shapes[b].dofs == 0 || model.sleeps(int(b))) continue;
    deform(model.shapes[b], seconds, blocks[b]);
    if (model.joints.empty() && blocks[b].velocity[2] != 0)
      blocks[b].velocity[2] *= own_inertia(model, int(b), model.blocks[b]) / own_inertia(model, int(b), blocks[b]);
  }
  if (!model.joints.empty()) move_apart(model, seconds, blocks);
  return blocks;
}

}  // namespace talus
