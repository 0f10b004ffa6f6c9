#include "step/peaks.h"

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

}  // namespace

bool keep_peaks(Model& model, bool in_motion) {
  const bool small = model.strained.value <= small_strain;
  if (in_motion) keep_peak_velocities(model);
  const Vec2 up = model.scene.gravity.isZero() ? Vec2(0, 1) : Vec2(-model.scene.gravity.normalized());
  for (const int b : model.awake_blocks()) {  // once, as of many blocks the states are more than caches hold
    const BlockState& state = model.blocks[b];
    const int dofs = model.shapes[b].dofs;
    if (in_motion && dofs > 0) raise(model.highest, b, state.shift.dot(up), model.time);
    if (dofs > rigid_dofs && state.strain.lpNorm<1>() > model.strained.value)
      raise(model.strained, b, largest_principal(state.strain), model.time);
  }
  return small && model.strained.value > small_strain;
}

}  // namespace talus
