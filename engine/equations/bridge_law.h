#pragma once
// What a bridge pulls with: see equations/bridge_terms.h.
#include <algorithm>
#include <cmath>

#include "model/model.h"

namespace talus {

// Strengths of a joint above what its contact carries in the end, Pa, after a slip and an opening, m.
class BridgeLaws {
 public:
  BridgeLaws(const Model& model, const Joint& joint)
      : property_(model.scene.properties[joint.property]), intact_(model.strength(joint)) {}

  double tension(double slip, double opening) const {
    return std::max(0.0, left(slip, opening).tension - property_.residual.tension);
  }
  double cohesion(double slip, double opening) const {
    return std::max(0.0, left(slip, opening).cohesion - property_.residual.cohesion);
  }

 private:
  Strength left(double slip, double opening) const { return property_.reduction(intact_, {slip, opening, 0}); }

  const JointProperty& property_;
  Strength intact_;
};

inline double worn_by(const Bridge& bridge, double x) { return std::max(bridge.worn, x - bridge.reach); }

// On its line, or at its worst jump where the line ends.
inline double on_line(const Bridge& bridge, double strength) {
  const double end = bridge.reach + bridge.worn;
  return end > 0 ? strength * std::clamp(bridge.now / end, -1.0, 1.0) : 0;
}

}  // namespace talus
