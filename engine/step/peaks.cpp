#include "step/peaks.h"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

void raise(Peak& peak, int block, double value, double time) {
  if (value > peak.value) peak = {block, value, time};
}

double largest_principal(const Vec3& e) {
  return std::abs(e[0] + e[1]) / 2 + std::hypot((e[0] - e[1]) / 2, e[2] / 2);
}

void keep_peak_velocities(Model& model) {
  for (ProbePoint& probe : model.probes) {
    const double speed = model.velocity_at(probe.block, model.place(probe.block, probe.in_block)).norm();
    if (speed <= probe.peak_speed) continue;
    probe.peak_speed = speed;
    probe.peak_at = model.time;
  }
}

// What flies and has turned round in the step was higher in it, which may be long: by its fall since.
void keep_rise(Model& model, int block, double dt) {
  const double g = model.scene.gravity.norm();
  const Vec2 up = g > 0 ? Vec2(-model.scene.gravity / g) : Vec2(0, 1);
  const BlockState& state = model.blocks[block];
  const double rise = state.shift.dot(up), falls = -up.dot(Vec2(state.velocity[0], state.velocity[1]));
  if (falls > 0 && falls < g * dt && rise + falls * falls / (2 * g) > model.highest.value) {
    const auto pressed = [block](const Contact& c) { return (c.i == block || c.j == block) && c.normal_force > 0; };
    if (std::ranges::none_of(model.awake_contacts(), pressed))
      raise(model.highest, block, rise + falls * falls / (2 * g), model.time - falls / g);
  }
  raise(model.highest, block, rise, model.time);
}

}  // namespace

bool keep_peaks(Model& model, double dt) {
  const bool small = model.strained.value <= small_strain;
  if (dt > 0) keep_peak_velocities(model);
  for (const int b : model.awake_blocks()) {  // once, as of many blocks the states are more than caches hold
    const BlockState& state = model.blocks[b];
    const int dofs = model.shapes[b].dofs;
    if (dt > 0 && dofs > 0) keep_rise(model, b, dt);
    if (dofs > rigid_dofs && state.strain.lpNorm<1>() > model.strained.value)
      raise(model.strained, b, largest_principal(state.strain), model.time);
  }
  return small && model.strained.value > small_strain;
}

}  // namespace talus
