#pragma once
// What an interface carries, and the laws that decide when a bond fails and what is left of it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "geometry/vec2.h"

namespace talus {

// Mohr and Coulomb with a tension cut-off.
struct Strength {
  double friction = 0;  // angle, rad
  double cohesion = 0;  // Pa
  double tension = 0;   // Pa
  bool operator==(const Strength&) const = default;
};

// Mean traction of a bond over its edge, Pa, tension positive.
struct BondTraction {
  double normal = 0, shear = 0;
};

// What closed faces of strength `left` go on to carry of a bond's traction: pressing, and friction up to its limit.
inline BondTraction taken_over(const BondTraction& bond, const Strength& left) {
  if (bond.normal >= 0) return {};
  const double limit = left.cohesion - bond.normal * std::tan(left.friction);
  return {bond.normal, std::clamp(bond.shear, -limit, limit)};
}

// A bond that is judged. `used`: its utilisation, the answer; it fails at 1.
struct JudgedBond {
  int joint = 0;
  BondTraction traction;
  Strength intact;
  double used = 0;
};

// Where a bond lies now.
struct BondPlace {
  double length = 0;  // m, at the start
  Vec2 middle;        // m
  double dip = 0;     // rad, of its edge against +x, in (-π/2, π/2]
};
using BondPlaces = std::function<BondPlace(int joint)>;

// Utilisations of bonds, finite and >= 0; of many at once, as the way into a script costs as much as what it computes.
// Their places are looked up only where they are asked for. Proportional to the traction, or the load increments that
// are found from it are merely more.
using FailureCriterion = std::function<void(std::span<JudgedBond> bonds, const BondPlaces& places)>;

// What a failed joint has been through: the largest slip and opening since it failed (m, >= 0) and the normal traction
// (Pa).
struct JointWear {
  double slip = 0, opening = 0, normal = 0;
};

// What it still carries.
using ReductionLaw = std::function<Strength(const Strength& intact, const JointWear& wear)>;

}  // namespace talus
