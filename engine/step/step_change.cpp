#include "step/step_change.h"

#include <numeric>

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

// Angular momentum about the body's centroid, N m s per metre.
double turning(const Model& model, int b, const BlockState& state, const Body& body) {
  const Vec2 v(state.velocity[0], state.velocity[1]);
  return model.mass(b) * cross(Vec2(state.centroid - body.centroid), Vec2(v - body.velocity)) +
         own_inertia(model, b, state) * state.velocity[2] / model.shapes[b].length;
}

std::vector<Body> bodies_of(const Model& model, const std::vector<BlockState>& blocks, const std::vector<int>& body_of) {
  std::vector<Body> bodies;
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (body_of[b] >= int(bodies.size())) bodies.resize(size_t(body_of[b]) + 1);
    Body& body = bodies[size_t(body_of[b])];
    const double mass = model.mass(int(b));
    body.held = body.held || model.shapes[b].dofs == 0;  // alone, or bonded to others
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
    body.spin += turning(model, int(b), blocks[b], body);
    body.inertia += own_inertia(model, int(b), blocks[b]) + model.mass(int(b)) * (blocks[b].centroid - body.centroid).squaredNorm();
  }
  for (Body& body : bodies) body.spin /= body.inertia;
  for (const EdgeFixity& edge : model.edge_fixities) bodies[size_t(body_of[size_t(edge.block)])].held = true;
  for (Body& body : bodies)
    if (body.held) body.velocity = Vec2::Zero(), body.spin = 0;
  return bodies;
}

// Per block: of what hangs together by bonds, which where nothing can break is not known yet.
std::vector<int> bodies(const Model& model) {
  if (!model.fragment.empty()) return model.fragment;
  if (!model.joints.empty()) return find_fragments(model);
  std::vector<int> own(model.blocks.size());
  std::iota(own.begin(), own.end(), 0);
  return own;
}

}  // namespace

std::vector<BlockState> keep_deformation(const Model& model, double seconds) {
  std::vector<BlockState> blocks = model.blocks;
  const std::vector<int> body_of = bodies(model);
  const std::vector<Body> before = bodies_of(model, blocks, body_of);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const BlockShape& shape = model.shapes[b];
    const Body& body = before[size_t(body_of[b])];
    if (shape.dofs == 0 || model.sleeps(int(b))) continue;
    BlockState& state = blocks[b];
    const auto& v = state.velocity;
    state.shift += seconds * (Vec2(v[0], v[1]) - body.velocity - body.spin * perp(Vec2(state.centroid - body.centroid)));
    state.angle += seconds * (v[2] / shape.length - body.spin);
    state.centroid = shape.reference_centroid + state.shift;
    if (shape.dofs <= rigid_dofs) continue;
    state.strain += seconds / shape.length * Vec3(v[3], v[4], v[5]);
    for (size_t k = first_order_dofs; k < size_t(shape.rate_count()); ++k) state.bend[k - first_order_dofs] += seconds * v[k];
  }
  // What has moved outwards turns more slowly.
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
  return blocks;
}

}  // namespace talus
