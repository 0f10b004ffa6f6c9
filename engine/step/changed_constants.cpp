#include "step/changed_constants.h"

#include <utility>

#include "step/energies.h"

namespace talus {

namespace {

BlockState middle(const BlockState& a, const BlockState& b) {
  BlockState mean = a;
  mean.centroid = (a.centroid + b.centroid) / 2;
  mean.shift = (a.shift + b.shift) / 2;
  mean.angle = (a.angle + b.angle) / 2;
  mean.strain = (a.strain + b.strain) / 2;
  for (size_t k = 0; mean.bend && k < mean.bend->size(); ++k) (*mean.bend)[k] = ((*a.bend)[k] + (*b.bend)[k]) / 2;
  return mean;
}

void displace(Fixity& fixity, const Vec2& moved) {
  fixity.motion = Fixity::displacement;
  fixity.value = {History(moved.x()), History(moved.y())};
}

template <class Of, class... Fields>
void between(const Of& from, double part, Of& to, Fields Of::*... fields) {
  ((to.*fields = (1 - part) * from.*fields + part * to.*fields), ...);
}

}  // namespace

Constants constants_of(const Scene& scene) {
  return {scene.materials, scene.properties};
}

ConstantsWay::ConstantsWay(const Model& model, const Constants& before, double ends)
    : from_(before), to_(constants_of(model.scene)), begins_(model.time), ends_(ends) {}

void ConstantsWay::go(Model& model, double time) const {
  Constants there = to_;
  if (time < ends_) {
    const double part = (time - begins_) / (ends_ - begins_);
    for (size_t m = 0; m < to_.materials.size(); ++m)
      between(from_.materials[m], part, there.materials[m], &Material::density, &Material::young, &Material::poisson);
    for (size_t p = 0; p < to_.properties.size(); ++p) {
      between(from_.properties[p], part, there.properties[p], &JointProperty::friction, &JointProperty::cohesion,
              &JointProperty::penalty, &JointProperty::shear_ratio);
      if (from_.properties[p].stiffness_kind == to_.properties[p].stiffness_kind)
        between(from_.properties[p], part, there.properties[p], &JointProperty::stiffness);
    }
  }
  model.scene.materials = std::move(there.materials);
  model.scene.properties = std::move(there.properties);
  ++model.revision;
}

WithConstants::WithConstants(const Model& as_it_is, const Constants& constants) : model(as_it_is) {
  model.scene.materials = constants.materials;
  model.scene.properties = constants.properties;
  joints.prepare(model);
  supports.prepare(model, joints.ground_stiffness());
}

double WithConstants::stored() const {
  return strain_energy(model, joints, supports, 0);
}

ConstantsBooking::ConstantsBooking(const Model& model, const Constants& before, const std::vector<Vec2>& moved)
    : before_(before), blocks_(model.blocks), moved_(moved) {}

// With D = ½ u·(K₁ - K₀)u, which is what the change adds to the energy stored at u: 2 D((u₀ + u₁)/2) - (D(u₀) +
// D(u₁))/2.
double ConstantsBooking::work(const Model& model, const std::vector<Vec2>& moved) const {
  WithConstants now(model, constants_of(model.scene)), then(model, before_);
  const auto added = [&](double part) {  // of the way from the start of the load step
    for (WithConstants* rock : {&now, &then}) {
      for (size_t b = 0; b < blocks_.size(); ++b)
        rock->model.blocks[b] = part == 0   ? blocks_[b]
                                : part == 1 ? model.blocks[b]
                                            : middle(blocks_[b], model.blocks[b]);
      for (size_t f = 0; f < moved.size(); ++f)
        displace(rock->model.scene.fixities[f], (1 - part) * moved_[f] + part * moved[f]);
    }
    return now.stored() - then.stored();
  };
  return 2 * added(0.5) - (added(0) + added(1)) / 2;
}

}  // namespace talus
