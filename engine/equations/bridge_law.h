#pragma once
// What a bridge pulls with: see equations/bridge_terms.h.
#include <algorithm>
#include <cmath>

#include "model/crack_path.h"

namespace talus {

// From the axes of a joint, normal and shear, into those of its bridge, across and along the path of its crack, and
// back.
inline BondTraction to_path(const Joint& joint, const BondTraction& in_joint) {
  const Vec2 turned = Rotation::of(joint.path_turn).back({in_joint.normal, in_joint.shear});
  return {turned.x(), turned.y()};
}
inline BondTraction from_path(const Joint& joint, const BondTraction& on_path) {
  const Vec2 turned = Rotation::of(joint.path_turn).turn({on_path.normal, on_path.shear});
  return {turned.x(), turned.y()};
}

// Strengths of a joint above what its contact carries in the end, Pa of its own length, after a slip and an opening, m.
class BridgeLaws {
 public:
  BridgeLaws(const Model& model, const Joint& joint)
      : property_(model.scene.properties[joint.property]),
        intact_(model.strength(joint)),
        aslant_(std::cos(joint.path_turn)) {
    if (joint.mode != FailureMode::tension || !is_tracked(model, joint)) return;
    const double whole = left(0, 0).cohesion - property_.residual.cohesion;
    if (whole > 0) held_ = std::min(1.0, std::hypot(joint.left_with.normal, joint.left_with.shear) / whole);
  }

  double tension(double slip, double opening) const {
    return aslant_ * left(slip, opening).tension;  // contacts carry none
  }
  double cohesion(double slip, double opening) const {
    return held_ * std::max(0.0, left(slip, opening).cohesion - property_.residual.cohesion);
  }

 private:
  Strength left(double slip, double opening) const { return property_.reduction(intact_, {held_ * slip, opening, 0}); }

  const JointProperty& property_;
  Strength intact_;
  double aslant_;  // length of the path beside the joint, of the joint's own
  // Of the cohesion; slips count by it too, so that it takes G_II whatever it is. What fails in tension where cracks
  // have paths holds no more along its own than it failed with: the whole would lock the zigzag.
  double held_ = 1;
};

inline double worn_by(const Bridge& bridge, double x) {
  return std::max(bridge.worn, x - bridge.reach);
}

// On its line, or at its worst jump where the line ends.
inline double on_line(const Bridge& bridge, double strength) {
  const double end = bridge.reach + bridge.worn;
  return end > 0 ? strength * std::clamp(bridge.now / end, -1.0, 1.0) : 0;
}

}  // namespace talus
