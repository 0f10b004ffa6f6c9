#include "step/damping.h"

#include <cmath>

#include "model/rates.h"
#include "step/energies.h"

namespace talus {

std::vector<double> kept_velocities(const Model& model, const std::vector<BlockState>& moved, double dt) {
  const Numerics& numerics = model.scene.numerics;
  const double parameter = numerics.integrator == Integrator::newmark ? numerics.dynamic_parameter : 1;
  if (parameter == 1 && !numerics.damping) return {};
  std::vector<double> kept(moved.size(), parameter);
  if (!numerics.damping) return kept;
  for (const int b : model.awake_blocks()) {
    const auto& v = moved[b].velocity;
    if (model.shapes[b].dofs > 0 && !stands_still(v)) kept[b] *= numerics.damping(std::hypot(v[0], v[1]), dt);
  }
  return kept;
}

// The energy is that at X, not at y: what the way between them holds changes with the velocity, and is read off the
// state.
double damp(Model& model, const std::vector<double>& kept) {
  double taken = 0;
  if (kept.empty()) return 0;
  for (const int b : model.awake_blocks()) {
    if (model.shapes[b].dofs == 0) continue;
    taken += (1 - kept[b] * kept[b]) * kinetic_energy(model, b, 0);
    for (double& rate : model.blocks[b].velocity) rate *= kept[b];
  }
  return taken;
}

}  // namespace talus
