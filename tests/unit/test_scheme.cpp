#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "equations/scheme.h"

namespace talus {
namespace {

// A mass on a spring (and a constant force), stepped by nothing but the coefficients, as the engine does:
// everything is linearised about the place that the velocity reaches at mid-step.
struct Oscillator {
  double mass = 1, bond = 0, contact = 0, force = 0;  // kg, N/m, N/m, N
  double x = 0, v = 0;

  void step(const Scheme& s) {
    const double middle = x + s.mid * v;
    const double stiffness = s.inertia * mass + s.bond_d * bond + s.contact_d * contact;
    const double d = (force - bond * (middle + s.bond_v * v) - contact * (middle + s.contact_v * v)) / stiffness;
    x += s.step_v * v + s.move_d * d;
    v += s.velocity_d * d;
  }
};

// |error| after one period of ω = 1 in n steps, in x and v.
double error(double theta, int n, bool newmark = false) {
  Oscillator o{.bond = 1, .x = 1};
  const double period = 2 * M_PI;
  for (int k = 0; k < n; ++k) o.step(newmark ? Scheme::newmark(period / n) : Scheme::theta(period / n, theta));
  return std::hypot(o.x - 1, o.v);
}

double order(double theta, bool newmark = false) {
  return std::log2(error(theta, 400, newmark) / error(theta, 800, newmark));
}

TEST(Scheme, OrderOfAccuracy) {
  EXPECT_NEAR(order(0.5), 2, 0.02);
  EXPECT_NEAR(order(0.75), 1, 0.02);
  EXPECT_NEAR(order(1), 1, 0.02);
  EXPECT_NEAR(order(0, true), 1, 0.02);
}

// θ damps the amplitude by exp(-(θ-½) ω² Δt t); θ = ½ only lags, by (ωΔt)²/12 of the phase.
TEST(Scheme, LeadingErrors) {
  const int n = 1000;
  const double dt = 2 * M_PI / n;
  EXPECT_NEAR(error(0.5, n), 2 * M_PI * dt * dt / 12, 1e-3 * dt * dt);
  for (double theta : {0.6, 0.75, 1.0})
    EXPECT_NEAR(error(theta, n), 1 - std::exp(-(theta - 0.5) * dt * 2 * M_PI), 5 * dt * dt) << theta;
}

TEST(Scheme, ConstantAccelerationIsExact) {
  for (const Scheme& s : {Scheme::theta(0.3, 0.5), Scheme::theta(0.3, 0.75), Scheme::newmark(0.3)}) {
    Oscillator o{.mass = 2, .force = 6, .x = 5, .v = -4};
    for (int k = 0; k < 10; ++k) o.step(s);
    EXPECT_NEAR(o.x, 5 - 4 * 3 + 3 * 9.0 / 2, 1e-13);
    EXPECT_NEAR(o.v, -4 + 3 * 3, 1e-13);
  }
}

// In y = x + (θ-½) Δt v, of which bulk and bonds take the θ-mean and contacts the end, the θ-scheme is the
// classical one: ½ m v² + ½ (bond + contact) y² cannot rise by more than round-off, at any step and stiffness.
TEST(Scheme, EnergyNeverRises) {
  for (double theta : {0.5, 0.6, 0.75, 1.0})
    for (double dt : {1e-3, 0.1, 1.0, 3.0, 100.0})
      for (bool contact : {false, true}) {
        Oscillator o{.bond = contact ? 0 : 1.0, .contact = contact ? 1.0 : 0, .x = 1, .v = 0.3};
        const auto energy = [&] {
          const double y = o.x + (theta - 0.5) * dt * o.v;
          return (o.v * o.v + y * y) / 2;
        };
        for (int k = 0; k < 200; ++k) {
          const double before = energy();
          o.step(Scheme::theta(dt, theta));
          EXPECT_LE(energy(), before * (1 + 1e-13)) << theta << " " << dt;
          const double least = theta == 0.5 && !contact ? before : 0;
          EXPECT_GE(energy(), least * (1 - 1e-13));
        }
      }
}

// Eigenvalues of the map (x, v) -> next lie in the unit circle.
double spectral_radius(const Eigen::MatrixXd& map) {
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(Scheme, IsStableForEveryStep) {
  for (double dt = 1e-3; dt < 1e4; dt *= 1.7)
    for (const Scheme& s :
         {Scheme::theta(dt, 0.5), Scheme::theta(dt, 0.75), Scheme::theta(dt, 1), Scheme::newmark(dt)}) {
      Eigen::Matrix2d map;
      for (int k = 0; k < 2; ++k) {
        Oscillator o{.bond = 1, .x = k == 0 ? 1.0 : 0, .v = k == 1 ? 1.0 : 0};
        o.step(s);
        map.col(k) << o.x, o.v;
      }
      EXPECT_LE(spectral_radius(map), 1 + 1e-7) << dt;  // √round-off where two coincide
    }
}

// θ = 0.75 has the radius and damping of Newmark (0.5625, 1), which stores accelerations: design.md, 4.3.
TEST(Scheme, ThreeQuartersDampsLikeNewmarkWithThatBeta) {
  for (double omega : {0.1, 0.5, 1.0, 3.0, 10.0}) {
    Eigen::Matrix2d theta;
    for (int k = 0; k < 2; ++k) {
      Oscillator o{.bond = omega * omega, .x = k == 0 ? 1.0 : 0, .v = k == 1 ? 1.0 : 0};
      o.step(Scheme::theta(1, 0.75));
      theta.col(k) << o.x, o.v;
    }
    // Newmark at Δt = 1: x1 = x + v + (½-β) a + β a1, v1 = v + (1-γ) a + γ a1, a1 = -ω² x1, β = 0.5625, γ = 1.
    const double beta = 0.5625, w = omega * omega;
    Eigen::Matrix3d newmark;
    for (int k = 0; k < 3; ++k) {
      const double x = k == 0, v = k == 1, a = k == 2;
      const double x1 = (x + v + (0.5 - beta) * a) / (1 + beta * w), a1 = -w * x1;
      newmark.col(k) << x1, v + a1, a1;
    }
    EXPECT_NEAR(spectral_radius(theta), spectral_radius(newmark), 1e-7) << omega;
  }
}

// The jump of a bond is weighed from both ends of the step; to first order that is `mid + bond_v` and `bond_d`.
TEST(Scheme, BondWeightsAgree) {
  for (double theta : {0.5, 0.75, 1.0}) {
    const Scheme s = Scheme::theta(0.2, theta);
    EXPECT_NEAR(s.bond_end * s.dt + s.bond_ahead, s.mid + s.bond_v, 1e-15);               // of v0, d = 0
    EXPECT_NEAR(s.bond_end * (s.move_d + s.bond_ahead * s.velocity_d), s.bond_d, 1e-15);  // of d
  }
  const Scheme s = Scheme::newmark(0.2);
  EXPECT_NEAR(s.bond_end * s.dt + s.bond_ahead, s.mid + s.bond_v, 1e-15);
  EXPECT_NEAR(s.bond_end * (s.move_d + s.bond_ahead * s.velocity_d), s.bond_d, 1e-15);
}

TEST(Scheme, EquilibriumIsReachedInOneSolve) {
  Oscillator o{.bond = 4, .force = 8, .x = 0.5};
  o.step(Scheme::equilibrium());
  EXPECT_DOUBLE_EQ(o.x, 2);
  EXPECT_EQ(o.v, 0);
}

}  // namespace
}  // namespace talus
