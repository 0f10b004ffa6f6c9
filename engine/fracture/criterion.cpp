#include "fracture/criterion.h"

#include <cmath>
#include <limits>

namespace talus {

namespace {

double part(double load, double strength) {
  if (load <= 0) return 0;
  return strength > 0 ? load / strength : std::numeric_limits<double>::infinity();
}

}  // namespace

Utilisation utilisation(const BondTraction& traction, const Strength& strength) {
  return {part(traction.normal, strength.tension),
          part(std::abs(traction.shear) + traction.normal * std::tan(strength.friction), strength.cohesion)};
}

double utilisation(const Model& model, const Joint& joint) { return utilisation(model, joint, mean_traction(joint)); }

double utilisation(const Model& model, const Joint& joint, const BondTraction& traction) {
  const JointProperty& property = model.scene.properties[joint.property];
  const Strength strength = model.strength(joint);
  return property.criterion ? property.criterion(traction, strength) : utilisation(traction, strength).most();
}

}  // namespace talus
