// Equations of state of explosion gas, and its flow through an orifice.
#include <gtest/gtest.h>

#include <cmath>

#include "gas/eos.h"
#include "gas/orifice.h"

namespace talus {
namespace {

constexpr Jwl anfo = {49.46e9, 1.891e9, 3.907, 1.118, 0.333, 2.484e9};

TEST(GasLaw, WorkIsTheIntegralOfThePressure) {
  for (const GasLaw& law : {polytropic(1e9, 1.4), polytropic(1e9, 1), jwl(anfo, 1), jwl(anfo, 0.5)}) {
    const GasLaw by_quadrature = {law.pressure, {}, {}};
    for (const double to : {1 + 1e-6, 1.1, 2., 131.4})
      EXPECT_NEAR(work(law, 1, to) / work(by_quadrature, 1, to), 1, 1e-6) << to;
    EXPECT_NEAR(work(law, 1, 3) + work(law, 3, 9), work(law, 1, 9), 1e-12 * work(law, 1, 9));
  }
}

// The paper's chamber of 0.031 m3 a metre to 129.65 times its volume; fully coupled ANFO in a hole of 0.1 m (both MJ a
// metre).
TEST(GasLaw, WorkOfThePapersChamber) {
  EXPECT_NEAR(0.0314159 * work(polytropic(1e9, 1.4), 1, 129.65) / 1e6, 67.3, 0.1);
  EXPECT_NEAR(0.0314159 * work(jwl(anfo, 1), 1, 129.65) / 1e6, 67.6, 0.1);
}

// All of its energy comes out in the end, and less of it presses on the rock from a hole that it does not fill.
TEST(GasLaw, AnExplosiveGivesItsEnergy) {
  EXPECT_NEAR(work(jwl(anfo, 1), 1, 1e30) / anfo.energy, 1, 1e-6);
  EXPECT_LT(jwl(anfo, 0.5).pressure(1, {}), 0.5 * jwl(anfo, 1).pressure(1, {}));
}

// A law that depends on the moment is taken at that moment throughout.
TEST(GasLaw, WorkAtOneMoment) {
  const GasLaw law = {[](double v, const GasMoment& m) { return (1 + m.t) * 1e6 / v; }, {}, {}};
  EXPECT_NEAR(work(law, 1, 8, {.t = 2}), 3e6 * std::log(8), 1);
}

// Choked and unchoked flow meet at the critical ratio, which gives the most; towards r = 1 it is Bernoulli's √(2 ρ ΔP).
TEST(Orifice, FlowOfAnIdealGas) {
  const double gamma = 1.4, pressure = 5e6, density = 60, critical = std::pow(2 / 2.4, 3.5);
  const double choked = mass_flux(gamma, pressure, density, 0.3 * pressure);
  EXPECT_NEAR(choked, 0.684731 * std::sqrt(pressure * density), 1e-5 * choked);  // √1.4 (2/2.4)^3
  EXPECT_NEAR(mass_flux(gamma, pressure, density, (critical + 1e-9) * pressure), choked, 1e-9 * choked);
  EXPECT_LT(mass_flux(gamma, pressure, density, 0.7 * pressure), choked);
  EXPECT_NEAR(mass_flux(gamma, pressure, density, 0.9999 * pressure), std::sqrt(2 * density * 1e-4 * pressure), 1e-1);
  EXPECT_EQ(mass_flux(gamma, pressure, density, pressure), 0);
  EXPECT_EQ(mass_flux(gamma, pressure, density, 2 * pressure), 0);
}

// A fixed volume, choked: x^(-(γ-1)/2) = 1 + (γ-1)/2 C A a0/V (2/(γ+1))^((γ+1)/(2(γ-1))) t, P = P0 x^γ, a0 = √(γ
// P0/ρ0).
TEST(Orifice, BlowDownOfAFixedVolume) {
  const double gamma = 1.3, first = 20e6, density = 150, volume = 0.04, opening = 0.01, mass = density * volume;
  const Orifice orifice = {
      .coefficient = 0.84, .gamma = gamma, .density = density, .atmosphere = 101325, .opening = {}};
  const auto pressure = [&](double x) { return first * std::pow(x, gamma); };
  const double rate = 0.84 * opening / volume * std::sqrt(gamma * first / density) *
                      std::pow(2 / (gamma + 1), (gamma + 1) / (2 * (gamma - 1)));
  for (const double t : {1e-4, 3e-3, 0.02, 0.05}) {
    const double expected = std::pow(1 + (gamma - 1) / 2 * rate * t, -2 / (gamma - 1));
    ASSERT_GT(pressure(expected), 2 * 101325) << "not choked any more";
    EXPECT_NEAR(blow_down(orifice, opening, mass, volume, pressure, t), expected, 1e-7 * expected) << t;
  }
  const double half = blow_down(orifice, opening, mass, volume, pressure, 0.02);
  const double rest = blow_down(
      orifice, opening, half * mass, volume, [&](double x) { return pressure(half * x); }, 0.02);
  EXPECT_NEAR(half * rest, blow_down(orifice, opening, mass, volume, pressure, 0.04), 1e-7 * half * rest);
  EXPECT_EQ(blow_down(orifice, opening, mass, volume, pressure, 5), 0);
  EXPECT_EQ(blow_down(orifice, 0, mass, volume, pressure, 5), 1);
}

}  // namespace
}  // namespace talus
