#pragma once
// Inertia, elasticity, gravity and body force of each block.
#include "equations/system.h"

namespace talus {

// ∫ρ TᵀT dA in the block's own axes (kg/m); constant. The first six unknowns, and all twelve of a second-order block.
DofMatrix mass_matrix(const Model& model, int block);
MatrixOf<second_order_dofs> second_order_mass_matrix(const Model& model, int block);
template <int n>
MatrixOf<n> mass_matrix_of(const Model& model, int block) {
  if constexpr (n == first_order_dofs)
    return mass_matrix(model, block);
  else
    return second_order_mass_matrix(model, block);
}

// ∫ SᵀDS dA of the strain S of the six unknowns of model/bend.h, N/m3.
MatrixOf<6> bend_stiffness(const BlockShape& shape, const Mat3& elasticity);
// The rest of ½∫ε·(2σ₀ + Dε) dA beside that of the constant strain, J/m; ∫ Sᵀσ₀ dA of the varying part of σ₀, N.
double bend_energy(const Model& model, int block, const Vec6& bend);
Vec6 initial_bend_force(const Model& model, int block);

// ρ/l² ∫ |x|² over the block strained by e, and bent (kg/m): its moment of inertia in units of the rotation unknown.
double moment_of_inertia(const Model& model, int block, const Vec3& e);
double moment_of_inertia(const Model& model, int block, const Vec3& e, const Apart<BendArray>& bend);

// m/s, l times the spin that a block's mass has in the mean: its angular momentum over its moment of inertia, which
// unlike the rate of its rotation shear does not change. docs/theory.md, "Rotation".
double mean_spin(const Model& model, int block, const BlockState& state);

// External force per area on a block, N/m2: gravity and its region's body force at time `t`.
Vec2 body_force(const Model& model, int region, double density, double t);

// Inertia that keeps what nothing holds from running away in equilibrium; per block, in units of its own (wave speed /
// size of the scene)²: it goes with a block's stiffness, not its mass, so that a heavy block on a light one settles as
// fast as the other way round. It draws towards where displacements (m, rad by lengths; empty: 0) are minus `lead`.
void add_hold(const Model& model, const std::vector<double>& hold, const Vector& lead, System& system);

void add_block_terms(const Model& model, const Poses& poses, const Scheme& scheme, System& system);

}  // namespace talus
