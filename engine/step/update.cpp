#include "step/update.h"

#include <algorithm>
#include <cmath>

#include "equations/block_terms.h"
#include "model/tensor_norms.h"

namespace talus {

std::vector<BlockState> moved_blocks(const Model& model, const Scheme& scheme, const Vector& d) {
  std::vector<BlockState> moved = model.blocks;
  for (const int b : model.awake_blocks()) move_block(model, scheme, d, b, moved[b]);
  return moved;
}

void move_block(const Model& model, const Scheme& scheme, const Vector& d, int block, BlockState& moved) {
  const BlockShape& shape = model.shapes[block];
  const BlockState& from = model.blocks[block];
  moved = from;
  const auto& v0 = from.velocity;
  const size_t size = v0.size();
  std::array<double, max_dofs> move;
  for (size_t k = 0; k < size; ++k) {
    const double dk = k < size_t(shape.dofs) ? d[shape.dof_begin + Eigen::Index(k)] : 0;
    move[k] = scheme.step_v * v0[k] + scheme.move_d * dk;
    moved.velocity[k] = scheme.step_v > 0 ? v0[k] + scheme.velocity_d * dk : v0[k];
  }
  moved.shift += Vec2(move[0], move[1]);
  moved.centroid = shape.reference_centroid + moved.shift;
  moved.angle += shape.turn(move[2] / shape.length);
  moved.strain += Vec3(move[3], move[4], move[5]) / shape.length;
  for (size_t k = first_order_dofs; k < size; ++k) (*moved.bend)[k - first_order_dofs] += move[k];
  if (shape.dofs > rigid_dofs && scheme.step_v > 0) {
    // Solved with the reference moment I; the angular momentum I(e) ω of the mean spin is what is kept.
    const double i = moment_of_inertia(model, block, Vec3::Zero()),
                 before = moment_of_inertia(model, block, from.strain, from.bend),
                 after = moment_of_inertia(model, block, moved.strain, moved.bend),
                 spin = mean_spin(model, block, from), to = mean_spin(model, block, moved);
    moved.velocity[2] += (before * spin + i * (to - spin)) / after - to;
  }
}

namespace {

double bending(const BlockShape& shape, const BlockState& from, const BlockState& to) {
  const Vec6 bend = Eigen::Map<const Vec6>(to.bend->data()) - Eigen::Map<const Vec6>(from.bend->data());
  return shape.radius * shape.radius / shape.area * bend_norm(bend);
}

}  // namespace

double displacement(const Model& model, int block, const BlockState& to, const Vec2& with) {
  // A bound that is sharp for translation and for rotation about the centroid.
  const BlockState& from = model.blocks[block];
  const double turn = 2 * std::abs(std::sin((to.angle - from.angle) / 2));
  const BlockShape& shape = model.shapes[block];
  const double linear =
      (to.shift - from.shift - with).norm() + shape.radius * (turn + tensor_norm(to.strain - from.strain));
  return shape.second_order() ? linear + bending(shape, from, to) : linear;
}

bool crushed(const Model& model, int block, const BlockState& to) {
  constexpr double least = 0.1;  // of the area
  const auto left = [](const Vec3& e) { return (1 + e[0]) * (1 + e[1]) - e[2] * e[2] / 4; };
  const double now = left(to.strain);
  return now < least && now < left(model.blocks[block].strain);
}

namespace {

bool is_supported(const Model& model, int block) {
  const auto here = [block](const auto& fixity) { return fixity.block == block; };
  return model.held_by[size_t(block)] >= 0 || std::ranges::any_of(model.point_fixities, here) ||
         std::ranges::any_of(model.edge_fixities, here);
}

}  // namespace

const Contact* driven_in(const Model& model) {
  constexpr double most = 0.1;  // of √area
  const auto contacts = model.awake_contacts();
  const auto found = std::ranges::find_if(contacts, [&](const Contact& c) {
    return c.normal_force > most * c.normal_stiffness * std::min(model.shapes[c.i].length, model.shapes[c.j].length) &&
           (is_supported(model, c.i) || is_supported(model, c.j));
  });
  return found == contacts.end() ? nullptr : &*found;
}

}  // namespace talus
