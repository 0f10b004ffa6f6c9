#include "step/simulation.h"

#include <algorithm>

#include "equations/recovery.h"
#include "model/registry.h"
#include "scene/build.h"
#include "step/part_timer.h"
#include "step/step.h"

namespace talus {

void visit_state(RunTotals& totals, StateVisitor& v) {
  // parts: CPU time is the process's.
  [[maybe_unused]] auto& [steps, iterations, cuts, factorisations, sweeps, steps_at_rest, steps_by_sweeps,
                          largest_iterations, largest_residual, parts] = totals;
  v("steps", steps);
  v("iterations", iterations);
  v("cuts", cuts);
  v("factorisations", factorisations);
  v("sweeps", sweeps);
  v("steps_at_rest", steps_at_rest);
  v("steps_by_sweeps", steps_by_sweeps);
  v("largest_iterations", largest_iterations);
  v("largest_residual", largest_residual);
}

void visit_state(StepReport& report, StateVisitor& v) {
  auto& [step, time, dt, iterations, cuts, factorisations, residual, displacement, closed_contacts] = report;
  v("step", step);
  v("time", time);
  v("dt", dt);
  v("iterations", iterations);
  v("cuts", cuts);
  v("factorisations", factorisations);
  v("residual", residual);
  v("displacement", displacement);
  v("closed_contacts", closed_contacts);
}

double& RunTotals::seconds(const std::string& part) {
  for (Part& p : parts)
    if (p.name == part) return p.seconds;
  parts.push_back({part, 0});
  return parts.back().seconds;
}

Simulation::Simulation(Scene scene) {
  const double start = cpu_seconds();
  model = build(std::move(scene));
  plan = make_plan(model);
  fingerprint_ = fingerprint(model);
  stepper_ = std::make_unique<Stepper>(model, plan, totals, ledger);
  stepper_->begin_ledger();
  totals.seconds("build") = cpu_seconds() - start;
}

Simulation::~Simulation() = default;

StepReport Simulation::step() {
  const TimeControl& time = model.scene.time;
  begin();
  if (plan.dynamic) {
    last = stepper_->dynamic_step();
  } else {
    const double from = model.time;
    model.time = time.t_end * double(totals.steps + 1) / time.steps;
    last = stepper_->load_step(from, totals.steps == 0);
  }
  ++totals.steps;
  totals.largest_residual = std::max(totals.largest_residual, last.residual);
  last.step = totals.steps;
  last.time = model.time;
  last.closed_contacts = int(std::count_if(model.contacts.begin(), model.contacts.end(),
                                           [](const Contact& c) { return c.state != ContactState::open; }));
  for (const auto& handler : on_step) handler(*this);
  return last;
}

void Simulation::begin() {
  if (begun_) return;
  if (plan.dynamic && model.scene.time.settled_start) settle();
  stepper_->begin_ledger();
  begun_ = true;
}

void Simulation::settle() {
  std::vector<std::array<double, max_dofs>> velocities;
  for (const BlockState& state : model.blocks) velocities.push_back(state.velocity);
  if (const std::string note = stepper_->settle(); !note.empty()) notes.push_back(note);
  for (size_t b = 0; b < velocities.size(); ++b) model.blocks[b].velocity = velocities[b];
}

void Simulation::visit_state(StateVisitor& visitor) {
  talus::visit_state(model, visitor);
  visitor("stepper", *stepper_);
  visitor("totals", totals);
  visitor("last", last);
  visitor("ledger", ledger);
  visitor("begun", begun_);
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

std::uint64_t Simulation::hash() const {
  return visited<StateHasher>().value();
}

std::uint64_t Simulation::layout() const {
  return visited<LayoutHasher>().value();
}

bool Simulation::finished() const {
  const TimeControl& time = model.scene.time;
  if (stopped_ || (time.max_steps > 0 && totals.steps >= time.max_steps)) return true;
  return plan.dynamic ? model.time >= time.t_end : totals.steps >= time.steps;
}

Energies Simulation::energies() const { return stepper_->energies(); }

const Recovery* Simulation::recovery() {
  if (!plan.recovery) return nullptr;
  PartTimer timer(totals, "stress recovery");
  if (!recovery_) recovery_ = std::make_unique<Recovery>(model);
  if (recovered_step_ != totals.steps) recovery_->update(model);
  recovered_step_ = totals.steps;
  return recovery_.get();
}

}  // namespace talus
