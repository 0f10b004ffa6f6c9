#pragma once
// Equations of state of explosion gas, as pressure over v = V/V0, V0 the volume of its hole.
#include "scene/scene.h"

namespace talus {

GasLaw polytropic(double pressure, double gamma);  // P0 v^-γ (Ning et al. 2011, equation 4)

// Jones, Wilkins and Lee (Lee, Hornig & Kury 1968), whose P(w, E) = A(1 - ω/(R1 w)) e^(-R1 w) + B(1 - ω/(R2 w)) e^(-R2
// w) + ω E/w with dE = -P dw from E(1) = E0 is the isentrope
//   P = A e^(-R1 w) + B e^(-R2 w) + C w^-(1+ω),   C = ω (E0 - A/R1 e^-R1 - B/R2 e^-R2),
// w the volume over that of the explosive before it went off. `filled`: part of the hole that the explosive fills: w =
// v/filled.
struct Jwl {
  double a, b, r1, r2, omega, energy;  // Pa, Pa, -, -, -, J/m3
};
GasLaw jwl(const Jwl& constants, double filled);

// ∫ P dv; by Gauss's rule with 5 points on parts over which v at most doubles, where the law has no closed form. A law
// that depends on time and chamber is taken as it is at one moment.
double work(const GasLaw& law, double from, double to, const GasMoment& moment = {});

}  // namespace talus
