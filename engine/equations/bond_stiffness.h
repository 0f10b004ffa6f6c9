#pragma once
// How stiff exact bonds have to be, by proof (docs/theory.md, § 4).
#include <vector>

#include "model/model.h"

namespace talus {

// Pa/m, per block: the largest eigenvalue κ of Σ_e w_e² ∫_e |σ(ε) n|² ds against the block's energy ∫ ε·D ε dA, over
// the strains ε that it can take: constant ones (3) and, of second order, their gradients (9). Edges are those of its
// exact bonds, also of those that have failed: a crack does not change how others are held; and those that are held by
// the ground.
std::vector<double> least_stiffness(const Model& model);

}  // namespace talus
