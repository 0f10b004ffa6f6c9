#include "step/peaks.h"

namespace talus {

void keep_peaks(Model& model) {
  for (ProbePoint& probe : model.probes) {
    const double speed = model.velocity_at(probe.block, model.place(probe.block, probe.in_block)).norm();
    if (speed <= probe.peak_speed) continue;
    probe.peak_speed = speed;
    probe.peak_at = model.time;
  }
  for (const int b : model.awake_blocks()) {
    if (model.shapes[b].dofs == 0) continue;
    const double rise = model.blocks[b].shift.y();
    if (rise > model.highest.rise) model.highest = {b, rise, model.time};
  }
}

}  // namespace talus
