#include "fracture/criterion.h"

#include <cmath>
#include <limits>
#include <vector>

namespace talus {

namespace {

double part(double load, double strength) {
  if (load <= 0) return 0;
  return strength > 0 ? load / strength : std::numeric_limits<double>::infinity();
}

BondPlaces places_in(const Model& model) {
  return [&model](int j) {
    const Joint& joint = model.joints[j];
    const Vec2 ends[] = {model.place(joint.a, joint.in_a[0]), model.place(joint.a, joint.in_a[1])};
    Vec2 along = ends[1] - ends[0];
    if (along.x() < 0 || (along.x() == 0 && along.y() < 0)) along = -along;
    return BondPlace{joint.length, (ends[0] + ends[1]) / 2 + model.origin, std::atan2(along.y(), along.x())};
  };
}

}  // namespace

Utilisation utilisation(const BondTraction& traction, const Strength& strength) {
  return {part(traction.normal, strength.tension),
          part(std::abs(traction.shear) + traction.normal * std::tan(strength.friction), strength.cohesion)};
}

double utilisation(const Model& model, const Joint& joint) {
  return utilisation(model, joint, mean_traction(joint));
}

double utilisation(const Model& model, const Joint& joint, const BondTraction& traction) {
  const JointProperty& property = model.scene.properties[joint.property];
  if (!property.criterion) return utilisation(traction, model.strength(joint)).most();
  JudgedBond bond = {int(&joint - model.joints.data()), traction, model.strength(joint)};
  property.criterion({&bond, 1}, places_in(model));
  return bond.used;
}

void judge(Model& model, std::span<const int> joints) {
  std::vector<std::vector<JudgedBond>> asked(model.scene.properties.size());  // of criteria of the script's own
  for (const int j : joints) {
    Joint& joint = model.joints[j];
    if (joint.state != JointState::intact) continue;
    if (model.scene.properties[joint.property].criterion)
      asked[joint.property].push_back({j, mean_traction(joint), model.strength(joint)});
    else
      joint.utilisation = utilisation(mean_traction(joint), model.strength(joint)).most();
  }
  for (std::size_t p = 0; p < asked.size(); ++p) {
    if (asked[p].empty()) continue;
    model.scene.properties[p].criterion(asked[p], places_in(model));
    for (const JudgedBond& bond : asked[p]) model.joints[bond.joint].utilisation = bond.used;
  }
}

FailureMode failure_mode(const Model& model, const Joint& joint, const BondTraction& traction) {
  const auto mode = [](bool tension) { return tension ? FailureMode::tension : FailureMode::shear; };
  if (model.scene.properties[joint.property].criterion)
    return mode(traction.normal > 0 && traction.normal >= std::abs(traction.shear));
  const Utilisation by = utilisation(traction, model.strength(joint));
  return mode(by.tension >= by.shear);
}

}  // namespace talus
