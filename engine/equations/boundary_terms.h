#pragma once
// Point loads, edge tractions and pressures; the motion of held blocks.
#include <functional>

#include "equations/supports.h"

namespace talus {

// Gives wholly held blocks the velocity that takes them to where their fixity wants them at the step's end.
void move_held_blocks(Model& model, double dt);
std::array<double, rigid_dofs> held_velocity(const Model& model, int block, double dt);

// Equilibrium: held blocks where their fixity wants them at Model::time. What touches them slides by as much.
void place_held_blocks(Model& model);

// Where a force acts on a block: the material point, from the reference centroid, and where that is.
struct LoadPoint {
  Vec2 in_block, at;
};
// Force on the unknowns of a block, of one fixed size or the other (model.h).
template <int n>
ColumnOf<n> force_on(const Pose& pose, const LoadPoint& point, const Vec2& force) {
  return pose.rows<n>(point.in_block, point.at).transpose() * force;
}

// Each force (N/m) of the loads at `time` on a block that is awake, and the place where it acts. A pressure follows its
// edge: it pushes along the inward normal of the edge as it lies now.
using LoadVisitor = std::function<void(int block, const LoadPoint& point, const Vec2& force)>;
void each_load(const Model& model, const Poses& poses, double time, const LoadVisitor& visit);
// Explosion gas on the faces it has reached: the derivative of its volume, on a second-order block's face at both ends
// and in the middle.
void each_gas_load(const Model& model, const Poses& poses, const LoadVisitor& visit);

void add_force(const Model& model, const Poses& poses, int block, const LoadPoint& point, const Vec2& force,
               System& system);
void add_loads(const Model& model, const Poses& poses, const Scheme& scheme, System& system);

}  // namespace talus
