#include "fracture/reduction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

double between(double part, double residual, double intact) {
  return residual + part * std::max(0.0, intact - residual);
}

// wear / δ with δ = shape·G/f.
double worn(double wear, double lost, double shape, double energy) {
  return lost > 0 ? wear * lost / (shape * energy) : 0;
}

}  // namespace

ReductionLaw softening(const Softening& law) {
  return [law](const Strength& intact, const JointWear& wear) {
    const double shape = law.exponential ? 1 : 2;
    const double r = worn(wear.opening, intact.tension - law.residual.tension, shape, law.energy_opening) +
                     worn(wear.slip, intact.cohesion - law.residual.cohesion, shape, law.energy_slip);
    const double part = law.exponential ? std::exp(-r) : std::max(0.0, 1 - r);
    return Strength{between(part, law.residual.friction, intact.friction),
                    between(part, law.residual.cohesion, intact.cohesion),
                    between(part, law.residual.tension, intact.tension)};
  };
}

ReductionLaw slip_weakening(double distance, const Strength& residual) {
  return [=](const Strength& intact, const JointWear& wear) {
    const double part = std::max(0.0, 1 - wear.slip / distance);
    return Strength{between(part, residual.friction, intact.friction),
                    between(part, residual.cohesion, intact.cohesion), residual.tension};
  };
}

ReductionLaw barton_bandis(double jrc, double jcs, double residual_friction) {
  constexpr double steepest = 70 * std::numbers::pi / 180;
  return [=](const Strength&, const JointWear& wear) {
    const double pressure = std::max(0.0, -wear.normal);
    const double rough = pressure > 0 ? jrc * std::log10(jcs / pressure) * std::numbers::pi / 180 : steepest;
    return Strength{std::min(steepest, residual_friction + std::max(0.0, rough)), 0, 0};
  };
}

namespace {

double compliance(const Softening& law, double energy, double lost) {
  return (law.exponential ? 1 : 2) * energy / (lost * lost);
}

}  // namespace

double softening_compliance(const Softening& law, double tension) {
  return compliance(law, law.energy_opening, tension - law.residual.tension);
}

double shear_compliance(const Softening& law, double cohesion) {
  return compliance(law, law.energy_slip, cohesion - law.residual.cohesion);
}

}  // namespace talus
