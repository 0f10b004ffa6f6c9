#pragma once
// Ready-made laws of what a failed bond still carries. Without one it falls at once to its residual strength.
#include "scene/strength.h"

namespace talus {

// With r = opening/δ_I + slip/δ_II the part 1 - r (linear) or exp(-r) (exponential) of tension and cohesion above the
// residual is left. The area under each curve is its fracture energy (J/m2): δ = 2G/f or G/f, f the strength that is
// lost (Hillerborg, Modéer & Petersson 1976); where both go on in proportion the works W add up to W_I/G_I + W_II/G_II
// = 1 (the linear criterion of Wu & Reuter 1965).
struct Softening {
  bool exponential = false;
  double energy_opening = 0, energy_slip = 0;  // G_I, G_II
  Strength residual;
};
ReductionLaw softening(const Softening& law);

// Tension is lost at once, cohesion and friction fall linearly over `distance` (m) of slip (Ida 1972).
ReductionLaw slip_weakening(double distance, const Strength& residual);

// Friction angle φ_r + JRC log10(JCS/σn), at most 70°, without cohesion (Barton & Choubey 1977). `jcs`: Pa.
ReductionLaw barton_bandis(double jrc, double jcs, double residual_friction);

// m/Pa, opening over tension lost where the law is steepest: 2 G_I/f² (linear), G_I/f² (exponential), f (Pa) the
// tension above the residual. Times Young's modulus it is the largest block that can soften before the energy stored in
// it passes what the crack takes (Bažant & Oh 1983); infinite where no tension is lost.
double softening_compliance(const Softening& law, double tension);
// The same of slip and cohesion, with G_II.
double shear_compliance(const Softening& law, double cohesion);

}  // namespace talus
