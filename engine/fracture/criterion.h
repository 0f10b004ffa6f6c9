#pragma once
// When a bond fails: maximum tension and Mohr–Coulomb on the traction of its edge (Ning et al. 2011, equations 1 and
// 2).
#include <span>

#include "model/model.h"

namespace talus {

struct Utilisation {
  double tension = 0, shear = 0;  // it fails where one of them reaches 1
  double most() const { return tension > shear ? tension : shear; }
};

// σ/σt, and (|τ| + σ tan φ)/c: both grow in proportion to the load. Infinite where a strength of zero is passed.
Utilisation utilisation(const BondTraction& traction, const Strength& strength);

// Of a bond by the criterion of its property; with its stored traction, or with another.
double utilisation(const Model& model, const Joint& joint);
double utilisation(const Model& model, const Joint& joint, const BondTraction& traction);

// Sets the utilisations of the intact ones of these joints, from their stored tractions.
void judge(Model& model, std::span<const int> joints);

// In tension or in shear, whichever is used more. A criterion of the script's own says how far, not in what: it is
// tension where the traction pulls at least as hard as it shears.
FailureMode failure_mode(const Model& model, const Joint& joint, const BondTraction& traction);

}  // namespace talus
