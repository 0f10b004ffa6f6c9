#include "step/bodies.h"

#include "equations/block_terms.h"

namespace talus {

std::vector<Body> bodies_of(const Model& model, const std::vector<BlockState>& blocks, const std::vector<int>& body_of,
                            size_t count) {
  std::vector<Body> bodies(count);
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (body_of[b] < 0) continue;
    Body& body = bodies[size_t(body_of[b])];
    const double mass = model.mass(int(b));
    body.mass += mass;
    body.centroid += mass * blocks[b].centroid;
    body.velocity += mass * Vec2(blocks[b].velocity[0], blocks[b].velocity[1]);
  }
  for (Body& body : bodies) {
    if (body.mass == 0) continue;
    body.centroid /= body.mass;
    body.velocity /= body.mass;
  }
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (body_of[b] < 0) continue;
    Body& body = bodies[size_t(body_of[b])];
    const BlockState& state = blocks[b];
    const Vec2 arm = state.centroid - body.centroid, v(state.velocity[0], state.velocity[1]);
    const double length = model.shapes[b].length, mass = model.mass(int(b)),
                 own = length * length * moment_of_inertia(model, int(b), state.strain, state.bend);
    body.spin += mass * cross(arm, Vec2(v - body.velocity)) + own * mean_spin(model, int(b), state) / length;
    body.inertia += own + mass * arm.squaredNorm();
  }
  for (Body& body : bodies)
    if (body.mass > 0) body.spin /= body.inertia;
  return bodies;
}

}  // namespace talus
