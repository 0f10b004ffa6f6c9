#include "step/simulation.h"

#include <algorithm>
#include <cmath>

#include "equations/recovery.h"
#include "fracture/snap_back.h"
#include "model/registry.h"
#include "gas/gas.h"
#include "scene/build.h"
#include "step/half_steps.h"
#include "step/load_steps.h"
#include "step/part_timer.h"
#include "step/peaks.h"
#include "step/step.h"

namespace talus {

void visit_state(RunTotals& totals, StateVisitor& v) {
  // parts, of_steps: CPU time is the process's.
  [[maybe_unused]] auto& [steps, iterations, cuts, factorisations, sweeps, splittings, pivots, steps_at_rest, steps_by_sweeps,
                          islands, failures, inaccurate, largest_iterations, largest_utilisation, largest_residual, parts, of_steps] = totals;
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
  auto& [step, time, dt, iterations, cuts, factorisations, residual, displacement, closed_contacts, failures, utilisation,
         error, collapsed] = report;
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

Simulation::Simulation(Scene scene) {
  const double start = cpu_seconds();
  model = build(std::move(scene));
  plan = make_plan(model);
  notes = model.notes;
  if (const std::string note = check_snap_back(model); !note.empty()) notes.push_back(note);
  fingerprint_ = fingerprint(model);
  parts_ = std::make_unique<StepParts>(model, plan, totals, ledger);
  stepper_ = std::make_unique<Stepper>(*parts_);
  load_steps_ = std::make_unique<LoadSteps>(*parts_);
  if (plan.step_error) half_steps_ = std::make_unique<HalfSteps>(*parts_, *stepper_);
  begin_ledger();
  totals.seconds("build") = cpu_seconds() - start;
  totals.end_step(true);
}

Simulation::~Simulation() = default;

StepReport Simulation::step() {
  if (stepper_->half_done())
    throw RunError("the last step was left half done when a law of the script failed in it: sim:restore goes on from a state that was saved before");
  // A step of motion puts back itself what an attempt has changed. What looks for equilibrium does not.
  const std::string before = plan.dynamic && begun_ ? std::string() : save();
  try {
    take_step();
  } catch (...) {
    if (before.empty())
      stepper_->left();
    else
      restore(before);
    throw;
  }
  for (const auto& handler : on_step) handler(*this);  // the step stands, whatever they do: it is written
  return last;
}

void Simulation::take_step() {
  begin();
  book_change();
  const long factors = totals.factorisations;
  last = half_steps_ ? half_steps_->step()
         : plan.dynamic ? stepper_->dynamic_step()
                        : load_steps_->step(next_load(), totals.steps == 0);
  for (Fixity& fixity : model.scene.fixities) fixity.go_on(model.time);
  ++totals.steps;
  last.factorisations = int(totals.factorisations - factors);
  totals.failures += last.failures;
  totals.largest_utilisation = std::max(totals.largest_utilisation, last.utilisation);
  if (last.collapsed) notes.push_back(load_steps_->collapse_note());
  totals.largest_residual = std::max(totals.largest_residual, last.residual);
  last.step = totals.steps;
  last.time = model.time;
  if (plan.dynamic) keep_peaks(model);
  last.closed_contacts = parts_->closed_contacts();
  totals.end_step(totals.steps == 1 || finished());
}

// Load steps are even parts of t_end; bonds that fail, and increments cut short because one will, come between.
double Simulation::next_load() const {
  const TimeControl& time = model.scene.time;
  if (time.t_end == 0) return 0;
  const double done = model.time / time.t_end * time.steps;
  return time.t_end * std::min((std::floor(done + 1e-9) + 1) / time.steps, 1.0);
}

void Simulation::begin() {
  if (begun_) return;
  const bool settled = plan.dynamic && model.scene.time.settled_start;
  if (settled) settle();
  if (plan.fracture)
    for (int count = parts_->initial_cracks(); count > 0; count = parts_->initial_cracks()) {
      totals.failures += count;
      stepper_->step_size().broken(model);
      if (settled) settle();
    }
  if (totals.failures > 0)
    notes.push_back(totals.failures == 1
                        ? "1 bond is beyond its strength at the start: it begins as a crack"
                        : std::to_string(totals.failures) + " bonds are beyond their strength at the start: they begin as cracks");
  if (plan.viscous && !plan.dynamic)
    notes.push_back("viscous boundaries are held like fixed edges: in a static scene nothing moves that they could absorb");
  begin_ledger();
  begun_ = true;
}

void Simulation::begin_ledger() { parts_->begin_ledger(plan.dynamic ? stepper_->first_ahead() : 0); }

void Simulation::settle() {
  std::vector<std::array<double, max_dofs>> velocities;
  for (const BlockState& state : model.blocks) velocities.push_back(state.velocity);
  if (const std::string note = Equilibrium(*parts_).settle(); !note.empty()) notes.push_back(note);
  for (size_t b = 0; b < velocities.size(); ++b) model.blocks[b].velocity = velocities[b];
}

void Simulation::visit_state(StateVisitor& visitor) {
  talus::visit_state(model, visitor);
  visitor("stepper", *stepper_);
  visitor("load_steps", *load_steps_);
  if (half_steps_) visitor("half_steps", *half_steps_);
  visitor("totals", totals);
  visitor("last", last);
  visitor("ledger", ledger);
  visitor("begun", begun_);
  visitor("changed", changed_);
  visitor("rest_at_change", rest_at_change_);
  visitor.growing("notes", notes);
}

template <class Visitor>
Visitor Simulation::visited() const {
  Visitor visitor;
  const_cast<Simulation*>(this)->visit_state(visitor);
  return visitor;
}

std::string Simulation::save() const {
  return visited<StateWriter>().bytes;
}

void Simulation::restore(const std::string& state) {
  const std::string before = save();
  StateReader reader(state);
  try {
    visit_state(reader);
    if (!reader.done()) throw StateError("is longer than a state of this scene");
  } catch (const StateError&) {
    StateReader back(before);
    visit_state(back);
    throw;
  }
  model.place_vertices();
  ++model.revision;
  stepper_->restored();
  recovery_.reset();
  recovered_step_ = -1;
  stopped_ = false;
}

const Gas* Simulation::gas() const { return parts_->gas.get(); }

std::uint64_t Simulation::hash() const {
  return visited<StateHasher>().value();
}

std::uint64_t Simulation::layout() const {
  return visited<LayoutHasher>().value();
}

bool Simulation::finished() const {
  const TimeControl& time = model.scene.time;
  if (stopped_ || last.collapsed || (time.max_steps > 0 && totals.steps >= time.max_steps)) return true;
  if (plan.dynamic) return model.time >= time.t_end;
  const long least = time.t_end == 0 ? time.steps : 1;
  return totals.steps >= least && model.time >= time.t_end && !parts_->bonds_due();
}

const std::vector<int>& Simulation::fractures() const { return half_steps_ ? half_steps_->fractures() : parts_->fractures(); }

const std::vector<GasEvent>& Simulation::gas_events() const {
  static const std::vector<GasEvent> none;
  return half_steps_ ? half_steps_->gas_events() : gas() ? gas()->events() : none;
}

Energies Simulation::energies() const {
  Energies e = parts_->energies();
  if (!changed_) return e;
  e.external += e.unexplained - rest_at_change_;
  e.unexplained = rest_at_change_;
  return e;
}

void Simulation::before_change() {
  if (changed_ || !begun_ || !plan.dynamic) return;
  rest_at_change_ = energies().unexplained;
  changed_ = true;
}

void Simulation::book_change() {
  if (!changed_) return;
  ledger.external_work = energies().external;
  ledger.largest_work = std::max(ledger.largest_work, std::abs(ledger.external_work));
  changed_ = false;
  rest_at_change_ = 0;
}

const Recovery* Simulation::recovery() {
  if (!plan.recovery) return nullptr;
  PartTimer timer(totals, "stress recovery");
  if (!recovery_) recovery_ = std::make_unique<Recovery>(model);
  if (recovered_step_ != totals.steps) recovery_->update(model);
  recovered_step_ = totals.steps;
  return recovery_.get();
}

}  // namespace talus
