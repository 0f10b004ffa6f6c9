// Compares ways to solve a step's contacts on the same problems. Each problem is a scene, run by the engine to its
// last step (time.max_steps), whose contact problem every candidate then gets. Writes the tables of
// docs/contact_study.md to standard output; scripts/contact_study runs it. --check: the shipped way alone, as a
// test. --steps: what the steps of a scene cost beside a bare factorisation.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

#include "problem.h"
#include "script/session.h"
#include "step/part_timer.h"
#include "step/step.h"

namespace talus::study {

namespace {

constexpr int most_checked = 12;  // factorisations, with --check
constexpr double alike = 1e-5;    // part of the change of energy

struct Entry {
  std::string name, scene;
  std::vector<std::pair<std::string, std::string>> parameters;
};

using Tallies = std::map<std::string, struct Tally>;

struct Tally {
  int converged = 0, tried = 0;
  double worst_residual = 0;
  std::vector<double> accepted;  // classical flips
  std::vector<double> costs;
};

std::pair<std::string, std::string> parameter(const std::string& word) {  // name=value
  const size_t equals = word.find('=');
  return {word.substr(0, equals), word.substr(equals + 1)};
}

std::vector<Entry> read_list(const std::string& folder) {
  std::ifstream file(folder + "/problems.txt");
  std::vector<Entry> list;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    Entry entry;
    if (line.empty() || line[0] == '#' || !(words >> entry.name >> entry.scene)) continue;
    for (std::string word; words >> word;) entry.parameters.push_back(parameter(word));
    list.push_back(entry);
  }
  return list;
}

int closed_contacts(const Problem& problem, const Vector& d) {
  int closed = 0;
  for (const ContactRows& row : problem.contacts.rows())
    closed += row.gap0 + problem.contacts.factor() * row.along(row.normal_i, row.normal_j, d) < 0;
  return closed;
}

void print_row(const Problem& problem, const Named& candidate, const Outcome& outcome) {
  std::printf("| %s | %s | %.1e | %d | %d | %.1f | ", candidate.name, outcome.converged ? "yes" : "no",
              outcome.residual, outcome.factorisations, outcome.sweeps, outcome.seconds / problem.bare);
  if (outcome.converged) std::printf("%.6e", problem.energy(outcome.d) - problem.energy());
  std::printf(" | %s |\n", outcome.note.c_str());
  std::fflush(stdout);
}

// own: the residual at which the engine took the step, or 0 where it had to cut it or began again from where it had got
// to, or used the splitting, which an island that needed it in the step before gets at once.
void compare(Problem& problem, double own, Tallies& tallies) {
  if (Desk(problem).count() == 0) throw std::runtime_error(problem.name + ": nothing touches in this step");
  problem.bare = bare_cost(problem, 10).known;
  std::vector<Outcome> outcomes;
  for (const Named& candidate : candidates()) {
    Desk desk(problem);
    const double start = cpu_seconds();
    candidate.solve(desk);
    desk.outcome.seconds = cpu_seconds() - start;
    outcomes.push_back(desk.outcome);
  }
  if (own > 0 && outcomes.back().residual != own)
    throw std::logic_error(problem.name + ": this is not the problem that the engine has solved");
  const auto best = std::find_if(outcomes.rbegin(), outcomes.rend(), [](const Outcome& o) { return o.converged; });
  const int closed = best == outcomes.rend() ? 0 : closed_contacts(problem, best->d);
  std::printf(
      "\n## %s\n\n%zu blocks, Δt %.3g s, %zu contacts, %zu near, %d closed; E at the start %.6e J; bare %.3g "
      "ms.\n\n",
      problem.name.c_str(), problem.model.blocks.size(), problem.scheme.dt, problem.contacts.rows().size(),
      Desk(problem).count(), closed, problem.energy(), 1e3 * problem.bare);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Outcome& outcome : outcomes)
    if (outcome.converged) {
      const double change = problem.energy(outcome.d) - problem.energy();
      least = std::min(least, change);
      most = std::max(most, change);
    }
  if (most - least > alike * std::max(std::abs(most), std::abs(least)))
    std::printf("Converged to more than one solution, friction leaves a choice.\n\n");
  std::printf(
      "| candidate | converged | residual | factors | sweeps | CPU, bare | ΔE, J | "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (size_t c = 0; c < outcomes.size(); ++c) {
    print_row(problem, candidates()[c], outcomes[c]);
    Tally& tally = tallies[candidates()[c].name];
    ++tally.tried;
    tally.converged += outcomes[c].converged;
    if (outcomes[c].accepted >= 0) tally.accepted.push_back(outcomes[c].accepted);
    if (outcomes[c].converged)
      tally.costs.push_back(outcomes[c].seconds / problem.bare);
    else
      tally.worst_residual = std::max(tally.worst_residual, outcomes[c].residual);
  }
}

// The shipped way alone, as a test.
void check(Problem& problem, double, Tallies& tallies) {
  Desk desk(problem);
  shipped(desk);
  const bool good = desk.done() && desk.outcome.factorisations <= most_checked;
  std::printf("%s  %s: residual %.1e after %d factorisations and %d sweeps\n", good ? "PASS" : "FAIL",
              problem.name.c_str(), desk.outcome.residual, desk.outcome.factorisations, desk.outcome.sweeps);
  Tally& tally = tallies[candidates().back().name];
  ++tally.tried;
  tally.converged += good;
}

// Runs the scene with the engine; `use` gets the problem of its last step.
bool study(const std::string& folder, const Entry& entry, decltype(&compare) use, Tallies& tallies) {
  Problem problem;
  bool found = false;
  int assembled = 0;    // times, for that step
  long splittings = 0;  // iterations, before it
  SessionOptions options;
  options.script = folder + "/" + entry.scene;
  options.parameters = entry.parameters;
  options.progress = false;
  options.on_run = [&](Run& run) {
    Simulation& simulation = run.simulation;
    double tried = 0;  // the step first tried: with more candidates near where one was missed, not the shorter
                       // ones after a cut
    simulation.stepper().on_assembled = [&, tried](const Scheme& scheme, const System& system,
                                                   const ContactTerms& contacts) mutable {
      if (simulation.totals.steps + 1 != simulation.model.scene.time.max_steps) return;
      if (++assembled == 1) splittings = simulation.totals.splittings;
      if (tried == 0) tried = scheme.dt;
      if (scheme.dt == tried) problem = {entry.name, simulation.model, scheme, system, contacts};
    };
    simulation.on_step.emplace_back([&](Simulation& now) {
      if (now.totals.steps != now.model.scene.time.max_steps) return;
      found = true;
      use(problem, assembled == 1 && now.totals.splittings == splittings ? now.last.residual : 0, tallies);
      problem = {};  // laws of the script go before it
    });
  };
  const int status = Session(std::move(options)).execute();
  problem = {};
  if (status != 0 || !found) std::fprintf(stderr, "study: %s did not get to its step\n", entry.name.c_str());
  return status == 0 && found;
}

void summary(Tallies& tallies) {
  std::printf(
      "\n## Summary\n\n| candidate | solved | median cost | worst cost | worst residual left "
      "|\n|---|---|---|---|---|\n");
  for (const Named& candidate : candidates()) {
    Tally& tally = tallies[candidate.name];
    std::sort(tally.costs.begin(), tally.costs.end());
    std::printf("| %s | %d of %d | ", candidate.name, tally.converged, tally.tried);
    if (tally.costs.empty())
      std::printf("– | – | ");
    else
      std::printf("%.1f | %.1f | ",
                  (tally.costs[(tally.costs.size() - 1) / 2] + tally.costs[tally.costs.size() / 2]) / 2,
                  tally.costs.back());
    if (tally.worst_residual > 0)
      std::printf("%.0e |\n", tally.worst_residual);
    else
      std::printf("– |\n");
  }
  const Tally& classical = tallies[candidates().front().name];
  const auto& accepted = classical.accepted;
  std::printf(
      "\nBy their own rule, states that no longer flip within six iterations, the classical flips accept %zu of "
      "the %d problems",
      accepted.size(), classical.tried);
  if (accepted.empty())
    std::printf(".\n");
  else
    std::printf(", at residuals up to %.0e; the others they take again with a shorter step.\n",
                *std::max_element(accepted.begin(), accepted.end()));
}

}  // namespace

}  // namespace talus::study

int main(int argc, char** argv) {
  using namespace talus::study;
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.size() > 1 && names.front() == "--steps") {
    std::vector<std::pair<std::string, std::string>> parameters;
    for (size_t k = 2; k < names.size(); ++k) parameters.push_back(parameter(names[k]));
    return report_steps(names[1], parameters);
  }
  const bool checks = !names.empty() && names.front() == "--check";
  if (checks) names.erase(names.begin());
  if (names.empty())
    return std::fprintf(stderr,
                        "contact_study [--check] <folder of problems.txt> [name…] | --steps <scene> [name=value…]\n"),
           2;
  Tallies tallies;
  int lost = 0;
  for (const Entry& entry : read_list(names.front())) {
    if (names.size() > 1 && std::find(names.begin() + 1, names.end(), entry.name) == names.end()) continue;
    if (!study(names.front(), entry, checks ? check : compare, tallies)) ++lost;
  }
  if (!checks) return summary(tallies), lost > 0;
  const Tally& tally = tallies[candidates().back().name];
  const int failed = tally.tried - tally.converged + lost;
  std::printf("%d passed, %d failed\n", tally.converged, failed);
  return failed > 0;
}
