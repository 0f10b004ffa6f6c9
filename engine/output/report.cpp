#include "output/report.h"

#include "output/json.h"
#include "output/versions.h"
#include "step/energy_terms.h"

namespace talus {

namespace {

void add_versions(Json& json) {
  const Versions known = versions();
  json.text("talus", known.talus).text("commit", known.commit);
  json.object("libraries").text("eigen", known.eigen).text("cgal", known.cgal).text("vtk", known.vtk);
  json.text("suitesparse", known.suitesparse).end();
}

void add_plan(Json& json, const Plan& plan) {
  json.array("plan");
  for (const auto& [part, what] : plan.lines) json.text(part + ": " + what);
  json.end();
}

void add_sizes(Json& json, const Model& model) {
  json.object("sizes").whole("blocks", static_cast<long>(model.shapes.size())).whole("unknowns", model.dofs);
  json.whole("joints", static_cast<long>(model.joints.size()));
  json.whole("contacts", static_cast<long>(model.contacts.size())).end();
}

void add_totals(Json& json, const RunTotals& totals) {
  json.whole("steps", totals.steps).whole("iterations", totals.iterations);
  json.whole("largest_iterations", totals.largest_iterations).whole("step_cuts", totals.cuts);
  json.whole("steps_at_rest", totals.steps_at_rest).whole("steps_by_sweeps", totals.steps_by_sweeps);
  json.object("islands").whole("at_rest", totals.islands.at_rest).whole("single", totals.islands.single);
  json.whole("by_sweeps", totals.islands.by_sweeps).whole("with_factor", totals.islands.with_factor);
  json.whole("asleep", totals.islands.asleep).end();
  if (totals.failures > 0) json.whole("failed_bonds", totals.failures);
  if (totals.largest_utilisation > 0) json.number("largest_utilisation", totals.largest_utilisation);
  if (totals.inaccurate > 0) json.whole("inaccurate_steps", totals.inaccurate);
  json.whole("sweeps", totals.sweeps)
      .whole("splittings", totals.splittings)
      .whole("pivots", totals.pivots)
      .whole("factorisations", totals.factorisations)
      .number("largest_residual", totals.largest_residual);
}

void add_energy(Json& json, const Simulation& simulation) {
  const Energies energies = simulation.energies();
  json.object("energy");
  for (const EnergyTerm* term : energy_terms(simulation.plan, energies))
    json.number(term->column, energies.*term->value);
  json.number("scale", energies.scale);
  json.number("unexplained_ratio", energies.scale > 0 ? energies.unexplained / energies.scale : 0).end();
}

void add_seconds(Json& json, const RunTotals& totals, const RunAccount& account) {
  json.object("cpu_seconds");
  for (const RunTotals::Part& part : totals.parts) json.number(part.name, part.seconds);
  json.number("total", account.cpu_seconds).end().number("wall_seconds", account.wall_seconds);
}

void add_checks(Json& json, const std::vector<CheckLine>& checks) {
  json.array("checks");
  for (const CheckLine& check : checks) {
    json.object().text("name", check.name).text("value", check.value).text("expected", check.expected);
    json.truth("pass", check.pass).end();
  }
  json.end();
}

void add_results(Json& json, const std::vector<ResultLine>& results) {
  json.object("results");
  for (const ResultLine& result : results) {
    json.object(result.name);
    if (const auto* number = std::get_if<double>(&result.value)) json.number("value", *number);
    if (const auto* text = std::get_if<std::string>(&result.value)) json.text("value", *text);
    if (const auto* truth = std::get_if<bool>(&result.value)) json.truth("value", *truth);
    json.text("unit", result.unit).end();
  }
  json.end();
}

// Estimated, of stress, relative in energy norm.
void add_errors(Json& json, const Model& model, const std::vector<ErrorNorm>& errors) {
  if (errors.empty()) return;
  ErrorNorm whole;
  for (const ErrorNorm& one : errors) whole += one;
  json.object("error").number("whole", whole.relative()).object("regions");
  for (size_t r = 0; r < errors.size(); ++r) json.number(model.scene.regions[r].name, errors[r].relative());
  json.end().end();
}

void add_restores(Json& json, const std::vector<RunAccount::Restore>& restores) {
  json.array("restored");
  for (const RunAccount::Restore& one : restores)
    json.object().text("from", one.from).whole("step", one.step).number("time", one.time).end();
  json.end();
}

}  // namespace

std::string run_report(const Simulation& simulation, const RunAccount& account) {
  Json json;
  json.object();
  add_versions(json);
  json.text("title", simulation.model.scene.title).text("scene", simulation.model.scene.file);
  json.text("command_line", account.command_line).text("outcome", account.outcome);
  json.number("end_time", simulation.model.time).text("state_hash", hex(simulation.hash()));
  add_restores(json, account.restores);
  add_plan(json, simulation.plan);
  json.array("notes");
  for (const std::string& note : simulation.notes) json.text(note);
  json.end();
  add_sizes(json, simulation.model);
  add_totals(json, simulation.totals);
  add_energy(json, simulation);
  add_errors(json, simulation.model, account.errors);
  add_seconds(json, simulation.totals, account);
  add_checks(json, account.checks);
  add_results(json, account.results);
  return json.end().file();
}

}  // namespace talus
