#include "script/estimate.h"

#include <sys/resource.h>

#include <cmath>

#include "output/text.h"
#include "step/part_timer.h"

namespace talus {
namespace {

std::string duration(double seconds) {
  if (seconds < 1) return "less than 1 s";
  if (seconds < 90) return "about " + significant(seconds, 2) + " s";
  if (seconds < 5400) return "about " + fixed(seconds / 60, 0) + " min";
  return "about " + (seconds < 36e5 ? fixed(seconds / 3600, 1) + " h" : significant(seconds / 86400, 2) + " days");
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1000;
}

// Unknowns to CPU seconds of one factorisation and to megabytes of the factor: cantilevers of 1340 to 22 000 blocks.
double factor_seconds(double unknowns) {
  return 8e-3 * std::pow(unknowns / 8000, 1.5);
}
double factor_megabytes(double unknowns) {
  return 13 * std::pow(unknowns / 8000, 1.15);
}

std::string in_steps(const Simulation& simulation) {
  const double unknowns = simulation.model.dofs;
  const TimeControl& time = simulation.model.scene.time;
  return "  memory  about " + significant(peak_megabytes() + factor_megabytes(unknowns), 2) + " MB\n  time    " +
         duration(factor_seconds(unknowns) * 3 * time.steps) + " CPU: " + std::to_string(time.steps) + " load step" +
         (time.steps == 1 ? "" : "s") +
         " of three factorisations; each step in which contacts change or bonds fail takes more\n";
}

std::string in_motion(Simulation& simulation) {
  constexpr double patience = 1;  // s
  constexpr int most = 20;
  const double begun = cpu_seconds();
  simulation.begin();
  const double start = cpu_seconds(), from = simulation.model.time;
  int steps = 0;
  while (steps < most && !simulation.finished() && cpu_seconds() - start < patience) ++steps, simulation.step();
  const double each = (cpu_seconds() - start) / std::max(steps, 1),
               dt = (simulation.model.time - from) / std::max(steps, 1);
  const TimeControl& time = simulation.model.scene.time;
  double left = dt > 0 ? std::ceil((time.t_end - simulation.model.time) / dt * (1 - 1e-9)) : 0;
  if (time.max_steps > 0) left = std::min(left, double(time.max_steps - steps));
  return "  memory  about " + significant(peak_megabytes(), 2) + " MB\n  time    " +
         duration(start - begun + (steps + left) * each) + " CPU: " + fixed(steps + left, 0) + " steps of " +
         significant(dt, 2) + " s at " + significant(each * 1e3, 2) + " ms, as the first " + std::to_string(steps) +
         " of them; contacts and cracks that come later take more\n";
}

}  // namespace

std::string estimate_text(Run& run) {
  Simulation& simulation = run.simulation;
  return simulation.plan.dynamic ? in_motion(simulation) : in_steps(simulation);
}

}  // namespace talus
