#pragma once
// Time integration as a handful of numbers. One solve a step finds d, in metres; with v0 the velocity at the
// start of the step
//   velocity at the end      v1 = v0 + d · velocity_d
//   displacement of the step u  = v0 · Δt_x + d · move_d
// Everything is linearised about the configuration the velocities reach at mid-step (exact rotation), and
//   bulk and bonds act on the strain  v0 · bond_v  + d · bond_d     beyond it (bonds: see bond_end),
//   contacts act on the gap           v0 · contact_v + d · contact_d beyond it,
//   shear springs of contacts stretch by v0 · Δt_x + d · contact_d, and of a held block, whose d is nought, by
//   bond_ahead times what it gets faster.
// Momentum: M d · inertia = forces.  docs/theory.md derives the coefficients and what they conserve.
#include "scene/scene.h"

namespace talus {

struct Scheme {
  double dt = 0;          // s
  double mid = 0;         // s, from the start to the configuration of linearisation
  double inertia = 0;     // 1/s2
  double velocity_d = 0;  // 1/s
  double step_v = 0, move_d = 0;
  double bond_v = 0, bond_d = 0;
  // A bond's jump is weighed from its two ends of the step, each in the axes that turn with the blocks, because
  // straight flight alone stretches whatever turns by (ω Δt)²:
  // (1 - bond_end) (g0 + bond_ahead ġ0) + bond_end (g1 + bond_ahead ġ1), to first order the line above.
  double bond_end = 1, bond_ahead = 0;  // -, s
  double contact_v = 0, contact_d = 0;
  double load_time = 0;  // s from the start: when loads are read

  // Velocity θ-scheme: positions by the mean of old and new velocity (exact for constant acceleration);
  // strains and gaps are those of X + (θ-½) Δt v, bulk and bonds at θ of the step, contacts at its end.
  // For linear forces its energy never rises; no acceleration is stored.
  static Scheme theta(double dt, double theta) {
    Scheme s;
    s.dt = dt;
    s.mid = dt / 2;
    s.inertia = 1 / (dt * dt);
    s.velocity_d = 1 / dt;
    s.step_v = dt;
    s.move_d = 0.5;
    s.bond_v = (2 * theta - 1) * dt;
    s.bond_d = theta * theta;
    s.bond_end = theta;
    s.bond_ahead = (theta - 0.5) * dt;
    s.contact_v = theta * dt;
    s.contact_d = theta;
    s.load_time = dt / 2;
    return s;
  }

  // DDA's own (Shi 1988): Newmark β = ½, γ = 1, forces at the end of the step.
  static Scheme newmark(double dt) {
    Scheme s = theta(dt, 0.5);
    s.bond_v = s.contact_v = dt / 2;
    s.bond_d = s.contact_d = 0.5;
    s.bond_end = 1;
    s.bond_ahead = 0;
    s.load_time = dt;
    return s;
  }

  // Equilibrium: no velocities.
  static Scheme equilibrium() {
    Scheme s;
    s.move_d = s.bond_d = s.contact_d = 1;
    return s;
  }
};

}  // namespace talus
