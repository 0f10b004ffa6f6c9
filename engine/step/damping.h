#pragma once
// What takes velocity from blocks after a step: DDA's dynamic parameter (Newmark), and a law of the scene, k(|v|, Δt).
#include "model/model.h"

namespace talus {

// The part of its velocity that each block keeps after a step of `dt` that takes the blocks to `moved`; empty: all of
// it. May throw LawError: to be asked before the step is accepted.
std::vector<double> kept_velocities(const Model& model, const std::vector<BlockState>& moved, double dt);

// Leaves each block its part. Returns the kinetic energy taken, J/m.
double damp(Model& model, const std::vector<double>& kept);

}  // namespace talus
