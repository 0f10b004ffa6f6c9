// Equations of state of explosion gas.
#include <gtest/gtest.h>

#include <cmath>

#include "gas/eos.h"

namespace talus {
namespace {

constexpr Jwl anfo = {49.46e9, 1.891e9, 3.907, 1.118, 0.333, 2.484e9};

TEST(GasLaw, WorkIsTheIntegralOfThePressure) {
  for (const GasLaw& law : {polytropic(1e9, 1.4), polytropic(1e9, 1), jwl(anfo, 1), jwl(anfo, 0.5)}) {
    const GasLaw by_quadrature = {law.pressure, {}};
    for (const double to : {1 + 1e-6, 1.1, 2., 131.4})
      EXPECT_NEAR(work(law, 1, to) / work(by_quadrature, 1, to), 1, 1e-6) << to;
    EXPECT_NEAR(work(law, 1, 3) + work(law, 3, 9), work(law, 1, 9), 1e-12 * work(law, 1, 9));
  }
}

// The paper's chamber of 0.031 m3 a metre to 129.65 times its volume; fully coupled ANFO in a hole of 0.1 m (both MJ a metre).
TEST(GasLaw, WorkOfThePapersChamber) {
  EXPECT_NEAR(0.0314159 * work(polytropic(1e9, 1.4), 1, 129.65) / 1e6, 67.3, 0.1);
  EXPECT_NEAR(0.0314159 * work(jwl(anfo, 1), 1, 129.65) / 1e6, 67.6, 0.1);
}

// All of its energy comes out in the end, and less of it presses on the rock from a hole that it does not fill.
TEST(GasLaw, AnExplosiveGivesItsEnergy) {
  EXPECT_NEAR(work(jwl(anfo, 1), 1, 1e30) / anfo.energy, 1, 1e-6);
  EXPECT_LT(jwl(anfo, 0.5).pressure(1), 0.5 * jwl(anfo, 1).pressure(1));
}

}  // namespace
}  // namespace talus
