#include "output/progress.h"

#include <cmath>
#include <iostream>
#include <limits>

#include "output/output.h"
#include "output/text.h"
#include "step/clock.h"

namespace talus {

namespace {

constexpr double quiet = 1;                               // s of a run without any progress line
constexpr double terminal_every = 0.1, plain_every = 10;  // s between lines
// of the ledger's scale, that is unexplained or came from nothing: the bound of verification
constexpr double worth_a_note = 0.01;
// of theta: below it what turns may gain energy (docs/theory.md, § 2)
constexpr double little_damping = 0.6;
constexpr const char* clear_line = "\r\x1b[K";

std::string scientific(double value) {
  if (!(value > 0)) return "0";
  const double power = std::floor(std::log10(value));
  const std::string digits = std::to_string(static_cast<int>(std::abs(power)));
  return fixed(value / std::pow(10, power), 1) + "e" + (power < 0 ? "-" : "+") + (digits.size() < 2 ? "0" : "") +
         digits;
}

void tell_energies(const Simulation& simulation) {
  const Energies energies = simulation.energies();
  const Numerics& numerics = simulation.model.scene.numerics;
  const bool undamped =
      simulation.plan.dynamic && numerics.integrator == Integrator::theta && numerics.theta < little_damping;
  const char* const advice =
      undamped ? "numerics.theta below 0.6 gains energy in what turns on pins and bonds; its default is 0.75"
      : simulation.plan.dynamic ? "a smaller time.dt tells whether the answer hangs on it"
                                : "more load steps tell whether the answer hangs on it";
  const auto tell = [&](double part, const char* what) {
    if (part > worth_a_note * energies.scale)
      std::cerr << "note: " << significant(100 * part / energies.scale, 2) << " % of the energy " << what << ": "
                << advice << "\n";
  };
  tell(std::abs(energies.unexplained), "is unexplained (sim.energy.unexplained over scale)");
  // else the floor of what rests on it may lift places y by as much for a while
  if (undamped || !simulation.plan.dynamic)
    tell(-energies.numerical, "came from nothing (sim.energy.numerical is negative)");
}

}  // namespace

std::string duration(double seconds) {
  if (seconds < 90) return fixed(std::ceil(seconds), 0) + " s";
  if (seconds < 5400) return fixed(seconds / 60, 0) + " min";
  return fixed(seconds / 3600, 1) + " h";
}

std::string progress_line(const StepReport& step, double t_end, double left) {
  const double done = t_end > 0 ? step.time / t_end : 0;
  std::string line = "t " + significant(step.time, 4) + " s";
  if (t_end > 0) line += " (" + fixed(std::floor(100 * done), 0) + " %)";
  line += "  step " + std::to_string(step.step) + "  dt " + scientific(step.dt) + " s  it " +
          std::to_string(step.iterations) + "  contacts " + std::to_string(step.closed_contacts);
  if (left > 0) line += "  ETA " + duration(left);
  return line;
}

std::string done_line(double stopped_at, long steps, long blocks, double cpu, const std::string& folder) {
  const auto count = [](long n, const std::string& thing) {
    return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
  };
  const std::string how = std::isnan(stopped_at) ? "done" : "stopped at t = " + significant(stopped_at, 4) + " s";
  return how + ": " + count(steps, "step") + ", " + count(blocks, "block") + ", " + fixed(cpu, cpu < 10 ? 2 : 0) +
         " s CPU" + (folder.empty() ? "" : "; results in " + folder);
}

Progress::Progress(bool terminal) : terminal_(terminal), started_(wall_seconds()) {}

void Progress::after_step(const Simulation& simulation) {
  const double running = wall_seconds() - started_;
  // which holds the search for a settled start too; and a run that is resumed begins at some other time
  if (std::isnan(first_)) {
    first_ = running;
    first_time_ = simulation.model.time;
  }
  // The first line comes when the run has proved not to be a short one.
  const double due = last_ > 0 ? last_ + (terminal_ ? terminal_every : plain_every) : terminal_ ? quiet : plain_every;
  if (running < due) return;
  last_ = running;
  const double t_end = simulation.model.scene.time.t_end, come = simulation.model.time - first_time_;
  const double left = come > 0 ? (running - first_) / come * (t_end - simulation.model.time) : 0;
  const std::string line = progress_line(simulation.last, t_end, left);
  std::cerr << (terminal_ ? clear_line : "") << line << (terminal_ ? "" : "\n") << std::flush;
}

void Progress::done(const Simulation& simulation, bool ended) {
  if (terminal_ && last_ > 0) std::cerr << clear_line;
  double cpu = 0;  // of this simulation: its script may have others
  for (const RunTotals::Part& part : simulation.totals.parts) cpu += part.seconds;
  const RunTotals& totals = simulation.totals;
  if (totals.inaccurate > 0)
    std::cerr
        << "note: the error of " << totals.inaccurate << " of " << totals.steps
        << " steps was beyond time.tolerance at the least step there is: something jumps or rings in them, which shorter ones do not cure; order = \"rigid\", a fixed "
           "time.dt or a larger dt_min leave out the ringing of blocks\n";
  tell_energies(simulation);
  std::cerr << done_line(ended ? std::numeric_limits<double>::quiet_NaN() : simulation.model.time, totals.steps,
                         static_cast<long>(simulation.model.shapes.size()), cpu, simulation.model.scene.output.dir)
            << std::endl;
}

}  // namespace talus
