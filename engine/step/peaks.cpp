#include "step/peaks.h"

#include <cmath>

namespace talus {

namespace {

void raise(Peak& peak, int block, double value, double time) {
  if (value > peak.value) peak = {block, value, time};
}

double largest_principal(const Vec3& e) { return std::abs(e[0] + e[1]) / 2 + std::hypot((e[0] - e[1]) / 2, e[2] / 2); }

}  // namespace

void keep_peaks(Model& model) {
  for (ProbePoint& probe : model.probes) {
    const double speed = model.velocity_at(probe.block, model.place(probe.block, probe.in_block)).norm();
    if (speed <= probe.peak_speed) continue;
    probe.peak_speed = speed;
    probe.peak_at = model.time;
  }
  for (const int b : model.awake_blocks())
    if (model.shapes[b].dofs > 0) raise(model.highest, b, model.blocks[b].shift.y(), model.time);
}

bool keep_strained(Model& model) {
  const bool before = model.strained.value > small_strain;
  for (const int b : model.awake_blocks())
    if (model.shapes[b].dofs > rigid_dofs) raise(model.strained, b, largest_principal(model.blocks[b].strain), model.time);
  return !before && model.strained.value > small_strain;
}

}  // namespace talus
