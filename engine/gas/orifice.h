#pragma once
// Gas that blows out through an opening: isentropic flow of an ideal gas through a nozzle (Shapiro 1953, chapter
// 4).
#include <functional>

#include "gas/reach.h"

namespace talus {

// kg/(m2 s) from gas of a pressure (Pa) and density (kg/m3) to the pressure `outside`, r = outside/pressure:
//   √(γ P ρ) (2/(γ+1))^((γ+1)/(2(γ-1)))              choked, r <= (2/(γ+1))^(γ/(γ-1)),
//   √(2γ/(γ-1) P ρ (r^(2/γ) - r^((γ+1)/γ)))          else, and none where r >= 1.
double mass_flux(double gamma, double pressure, double density, double outside);

// Part of the gas left after `seconds` through `opening` (m), of `mass` (kg) in `volume` (m2): dx/dt = -C A
// flux(P(x), x m/V)/m from x = 1, `pressure(x)` that of the part x. 0 where it has come down to the atmosphere's.
double blow_down(const Orifice& orifice, double opening, double mass, double volume,
                 const std::function<double(double)>& pressure, double seconds);

// m: what is given, or how far the joints that the gas has come through are open where they end at free surfaces.
double opening(const Orifice& orifice, const Model& model, const Reach& reach);

}  // namespace talus
