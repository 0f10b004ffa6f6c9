#include "step/totals.h"

#include "step/part_timer.h"

namespace talus {

void visit_state(RunTotals& totals, StateVisitor& v) {
  // parts, of_steps: CPU time is the process's.
  [[maybe_unused]] auto& [steps, iterations, cuts, factorisations, sweeps, splittings, pivots, steps_at_rest,
                          steps_by_sweeps, islands, failures, inaccurate, largest_iterations, largest_utilisation,
                          largest_residual, parts, of_steps] = totals;
  v("steps", steps);
  v("iterations", iterations);
  v("cuts", cuts);
  v("factorisations", factorisations);
  v("sweeps", sweeps);
  v("splittings", splittings);
  v("pivots", pivots);
  v("steps_at_rest", steps_at_rest);
  v("steps_by_sweeps", steps_by_sweeps);
  for (long* count : {&islands.at_rest, &islands.single, &islands.by_sweeps, &islands.with_factor, &islands.asleep})
    v("islands", *count);
  v("failures", failures);
  v("inaccurate", inaccurate);
  v("largest_iterations", largest_iterations);
  v("largest_utilisation", largest_utilisation);
  v("largest_residual", largest_residual);
}

void visit_state(StepReport& report, StateVisitor& v) {
  auto& [step, time, dt, iterations, cuts, factorisations, residual, displacement, closed_contacts, failures,
         utilisation, error, collapsed] = report;
  v("step", step);
  v("time", time);
  v("dt", dt);
  v("iterations", iterations);
  v("cuts", cuts);
  v("factorisations", factorisations);
  v("residual", residual);
  v("displacement", displacement);
  v("closed_contacts", closed_contacts);
  v("failures", failures);
  v("utilisation", utilisation);
  v("error", error);
  v("collapsed", collapsed);
}

double& RunTotals::seconds(const std::string& part) {
  for (Part& p : parts)
    if (p.name == part) return p.seconds;
  parts.push_back({part, 0});
  return parts.back().seconds;
}

void RunTotals::add_of_step(const char* part, double wall) {
  for (StepPart& own : of_steps.parts)
    if (own.name == part) {
      own.wall += wall;
      return;
    }
  of_steps.parts.push_back({part, wall});
}

void RunTotals::end_step(bool book) {
  constexpr double enough = 1e-3;  // s
  const double wall = wall_seconds() - of_steps.wall;
  if (!book && wall < enough) return;
  const double cpu = cpu_seconds() - of_steps.cpu;
  for (StepPart& part : of_steps.parts) seconds(part.name) += part.wall * (wall > 0 ? cpu / wall : 1);
  of_steps.parts.clear();
  of_steps.cpu += cpu;
  of_steps.wall += wall;
}

}  // namespace talus
