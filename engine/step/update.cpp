#include "step/update.h"

#include <algorithm>
#include <cmath>

#include "equations/block_terms.h"

namespace talus {

std::vector<BlockState> moved_blocks(const Model& model, const Scheme& scheme, const Vector& d) {
  std::vector<BlockState> moved = model.blocks;
  move_awake(model, scheme, d, moved);
  return moved;
}

void move_awake(const Model& model, const Scheme& scheme, const Vector& d, std::vector<BlockState>& moved) {
  for (const int b : model.awake_blocks()) {
    const BlockShape& shape = model.shapes[b];
    BlockState& state = moved[b] = model.blocks[b];
    const auto v0 = state.velocity;
    const int size = shape.rate_count();
    std::array<double, max_dofs> move;
    for (int k = 0; k < size; ++k) {
      const double dk = k < shape.dofs ? d[shape.dof_begin + k] : 0;
      move[k] = scheme.step_v * v0[k] + scheme.move_d * dk;
      state.velocity[k] = scheme.step_v > 0 ? v0[k] + scheme.velocity_d * dk : v0[k];
    }
    const Vec3 strain0 = state.strain;
    state.shift += Vec2(move[0], move[1]);
    state.centroid = shape.reference_centroid + state.shift;
    state.angle += move[2] / shape.length;
    state.strain += Vec3(move[3], move[4], move[5]) / shape.length;
    for (int k = first_order_dofs; k < size; ++k) state.bend[k - first_order_dofs] += move[k];
    if (shape.dofs > rigid_dofs && scheme.step_v > 0) {
      // Solved with the reference moment I; the spin momentum I(e) ω is what is kept.
      const double i = moment_of_inertia(model, b, Vec3::Zero()), before = moment_of_inertia(model, b, strain0, model.blocks[b].bend),
                   after = moment_of_inertia(model, b, state.strain, state.bend);
      state.velocity[2] = (before * v0[2] + i * (state.velocity[2] - v0[2])) / after;
    }
  }
}

namespace {

double bending(const BlockShape& shape, const BlockState& from, const BlockState& to) {
  const Vec6 bend = Eigen::Map<const Vec6>(to.bend.data()) - Eigen::Map<const Vec6>(from.bend.data());
  return shape.radius * shape.radius / shape.area * bend.norm();  // |(X², XY, Y²)| <= |X|²
}

}  // namespace

double displacement(const Model& model, int block, const BlockState& to) {
  // A bound that is sharp for translation and for rotation about the centroid.
  const BlockState& from = model.blocks[block];
  const double turn = 2 * std::abs(std::sin((to.angle - from.angle) / 2));
  const double strain = (to.strain - from.strain).norm();
  const BlockShape& shape = model.shapes[block];
  const double linear = (to.shift - from.shift).norm() + shape.radius * (turn + strain);
  return shape.second_order() ? linear + bending(shape, from, to) : linear;
}

double largest_displacement(const Model& model, const std::vector<BlockState>& moved) {
  double largest = 0;
  for (const int b : model.awake_blocks()) largest = std::max(largest, displacement(model, b, moved[b]));
  return largest;
}

int crushed_block(const Model& model, const std::vector<BlockState>& moved) {
  constexpr double least = 0.1;  // of the area
  const auto left = [](const Vec3& e) { return (1 + e[0]) * (1 + e[1]) - e[2] * e[2] / 4; };
  for (const int b : model.awake_blocks())
    if (const double now = left(moved[b].strain); now < least && now < left(model.blocks[b].strain)) return b;
  return -1;
}

}  // namespace talus
