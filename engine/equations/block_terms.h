#pragma once
// Inertia, elasticity, gravity and body force of each block.
#include "equations/system.h"

namespace talus {

// ∫ρ TᵀT dA in the block's own axes (kg/m); constant.
DofMatrix mass_matrix(const Model& model, int block);

// ρ/l² ∫ |x|² over the block strained by e (kg/m): its moment of inertia in units of the rotation unknown.
double moment_of_inertia(const Model& model, int block, const Vec3& e);

// External force per area on a block, N/m2: gravity and its region's body force at time `t`.
Vec2 body_force(const Model& model, int region, double density, double t);

// Inertia that keeps what nothing holds from running away in equilibrium; per block, in units of its own (wave speed /
// size of the scene)²: it goes with a block's stiffness, not its mass, so that a heavy block on a light one settles as
// fast as the other way round.
void add_hold(const Model& model, const std::vector<double>& hold, System& system);

void add_block_terms(const Model& model, const Poses& poses, const Scheme& scheme, System& system);

}  // namespace talus
