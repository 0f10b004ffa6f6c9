// What the steps of a scene cost beside one bare factorisation and solve of their own system: scripts/contact_study
// --steps.
#include <algorithm>
#include <cstdio>

#include "problem.h"
#include "script/session.h"
#include "step/part_timer.h"
#include "step/step.h"

namespace talus::study {

namespace {

bool of_steps(const std::string& part) {
  return part == "contact search" || part == "assembly" || part == "open-close and solve" || part == "update" ||
         part == "fracture";
}

// CPU of the steps, s: nothing that a step does not need.
double step_seconds(const RunTotals& totals) {
  double sum = 0;
  for (const auto& [part, seconds] : totals.parts)
    if (of_steps(part)) sum += seconds;
  return sum;
}

struct Row {
  long steps = 0;
  double time = 0, seconds = 0;
  BareCost bare;  // sum of the samples'
  int samples = 0;
};

void print(const char* what, const Row& row) {
  const double step = row.seconds / double(row.steps), known = row.bare.known / row.samples,
               fresh = row.bare.fresh / row.samples;
  std::printf("| %s | %ld | %.3g | %.3g | %.3g | %.1f | %.3g | %.1f |\n", what, row.steps,
              1e3 * row.time / double(row.steps), 1e3 * step, 1e3 * known, step / known, 1e3 * fresh, step / fresh);
  std::fflush(stdout);
}

}  // namespace

int report_steps(const std::string& script, const std::vector<std::pair<std::string, std::string>>& parameters) {
  SessionOptions options;
  options.script = script;
  options.parameters = parameters;
  options.progress = false;
  Row all, now;
  double end = 0;  // s, of the present row
  int sampled = 0;
  RunTotals totals;                          // after the last step
  std::vector<std::pair<int, int>> pattern;  // of the last system
  long systems = 0, changed = 0;
  options.on_run = [&](Run& run) {
    Simulation& simulation = run.simulation;
    if (simulation.model.scene.time.max_steps == 1) return;  // with which a scene makes its mesh
    end = simulation.model.scene.time.t_end / 12;
    std::printf(
        "| until, s | steps | mean step, ms | CPU a step, ms | bare, ms | ratio | bare of a new pattern, ms | ratio |\n|---|---|---|---|---|---|---|---|\n");
    simulation.stepper().on_assembled = [&](const Scheme& scheme, const System& system, const ContactTerms& contacts) {
      const long step = simulation.totals.steps;
      ++systems;
      if (pattern != system.matrix.pairs()) ++changed, pattern = system.matrix.pairs();
      if (step % 25 != 0 || step == sampled) return;
      sampled = int(step);
      const Problem problem{"", simulation.model, scheme, system, contacts};
      const BareCost bare = bare_cost(problem, 3);
      now.bare.known += bare.known;
      now.bare.fresh += bare.fresh;
      ++now.samples;
    };
    simulation.on_step.emplace_back([&, before = 0.0, last = 0.0](Simulation& of) mutable {
      const double seconds = step_seconds(of.totals);
      ++now.steps;
      now.time += of.model.time - last;
      now.seconds += seconds - before;
      last = of.model.time;
      before = seconds;
      totals = of.totals;
      if (of.model.time < end * (1 - 1e-9) || now.samples == 0) return;
      char until[40];
      std::snprintf(until, sizeof until, "%.3g", of.model.time);
      print(until, now);
      all.steps += now.steps;
      all.time += now.time;
      all.seconds += now.seconds;
      all.bare.known += now.bare.known;
      all.bare.fresh += now.bare.fresh;
      all.samples += now.samples;
      now = {};
      end = of.model.time + of.model.scene.time.t_end / 12;
    });
  };
  const int status = Session(std::move(options)).execute();
  if (all.steps > 0) print("all", all);
  if (systems > 0)
    std::printf("\n%.0f %% of the systems have another pattern than the one before.\n",
                100.0 * double(changed) / double(systems));
  if (totals.steps > 0) std::printf("\n| part of a step | CPU, s | of all, %% |\n|---|---|---|\n");
  for (const auto& [part, seconds] : totals.parts)
    if (of_steps(part))
      std::printf("| %s | %.3g | %.0f |\n", part.c_str(), seconds, 100 * seconds / step_seconds(totals));
  return status;
}

}  // namespace talus::study
