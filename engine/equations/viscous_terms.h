#pragma once
// Viscous boundaries (Lysmer & Kuhlemeyer 1969): edges with the tractions that a medium which goes on would put on
// waves that leave straight, -ρ c_p v_n n - ρ c_s v_s s.
//
// In motion they act on the mean velocity of the step, v_mid = v0 + ½ velocity_d d = ΔX/Δt for the θ-scheme and Newmark
// alike, so that their work -C v_mid·ΔX is never positive and the matrix gets ½ velocity_d C. Beside them stay the
// tractions that the edges carried in equilibrium: dashpots bear no weight. In equilibrium the edges are held by stiff
// springs, whose forces are those tractions to the last bit.
#include <functional>
#include <utility>

#include "equations/boundary_terms.h"

namespace talus {

// Dashpots and kept tractions; in equilibrium the springs.
void add_viscous_edges(const Model& model, const Poses& poses, const Scheme& scheme, System& system);

// The springs' forces at the present places become the tractions that stay.
void keep_viscous_tractions(Model& model);
double viscous_hold_energy(const Model& model);  // J/m, of the springs

// Each force (N/m) of the tractions that stay on a block that is awake, and where it acts.
void each_viscous_traction(const Model& model, const Poses& poses, const LoadVisitor& visit);

// Of what is awake, with a and b block by block.
struct ViscousForms {
  double own = 0, mixed = 0;  // Σ aᵀ C a, Σ aᵀ C b
};
using TwoOfBlock = std::function<std::pair<ColumnOf<max_dofs>, ColumnOf<max_dofs>>(int block)>;
ViscousForms viscous_forms(const Model& model, const Poses& poses, const TwoOfBlock& of);

}  // namespace talus
