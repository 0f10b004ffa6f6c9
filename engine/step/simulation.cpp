#include "step/simulation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "equations/recovery.h"
#include "fracture/snap_back.h"
#include "gas/gas.h"
#include "model/registry.h"
#include "scene/build.h"
#include "step/half_steps.h"
#include "step/load_steps.h"
#include "step/part_timer.h"
#include "step/peaks.h"
#include "step/step.h"
#include "step/update.h"

namespace talus {

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
    throw RunError(
        "the last step was left half done when a law of the script failed in it: sim:restore goes on from a state that was saved before");
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
  refuse_driven_in();
  const long factors = totals.factorisations;
  last = half_steps_    ? half_steps_->step()
         : plan.dynamic ? stepper_->dynamic_step()
                        : load_steps_->step(next_load(), totals.steps == 0);
  ++totals.steps;
  last.factorisations = int(totals.factorisations - factors);
  totals.failures += last.failures;
  totals.largest_utilisation = std::max(totals.largest_utilisation, last.utilisation);
  if (last.collapsed) notes.push_back(load_steps_->collapse_note());
  totals.largest_residual = std::max(totals.largest_residual, last.residual);
  last.step = totals.steps;
  last.time = model.time;
  if (keep_peaks(model, plan.dynamic ? last.dt : 0)) notes.push_back(strain_note());
  last.closed_contacts = parts_->closed_contacts();
  totals.end_step(totals.steps == 1 || finished());
}

void Simulation::refuse_driven_in() const {
  const Contact* const c = driven_in(model);
  if (c == nullptr) return;
  char depth[32];
  std::snprintf(depth, sizeof depth, "%.3g", c->normal_force / c->normal_stiffness);
  throw RunError(
      "t = " + std::to_string(model.time) + " s: " + block_name(model, c->i) + " is pressed in by " + depth +
      " m where it meets " + block_name(model, c->j) +
      ", more than a tenth of the smaller one's size: what is driven there cannot give way, or joint.stiffness is too little for what it bears");
}

std::string Simulation::strain_note() const {
  const auto& [block, strain, at] = model.strained;
  char text[400];
  std::snprintf(
      text, sizeof text,
      "t = %.6g s: %s is strained by %.3g (sim.strained has the largest): linear elasticity is for small strains, and beyond %g energy may be unexplained; is material.young, "
      "%.3g Pa, too little for what acts?",
      at, block_name(model, block).c_str(), strain, small_strain, model.material(block).young);
  return text;
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
  std::string unsettled = settled ? settle() : "";
  if (plan.fracture)
    for (int count = parts_->initial_cracks(); count > 0; count = parts_->initial_cracks()) {
      totals.failures += count;
      stepper_->step_size().broken(model);
      if (settled) unsettled = settle();
    }
  if (!unsettled.empty()) notes.push_back(unsettled);
  if (totals.failures > 0)
    notes.push_back(totals.failures == 1 ? "1 bond is beyond its strength at the start: it begins as a crack"
                                         : std::to_string(totals.failures) +
                                               " bonds are beyond their strength at the start: they begin as cracks");
  if (plan.viscous && !plan.dynamic)
    notes.push_back(
        "viscous boundaries are held like fixed edges: in a static scene nothing moves that they could absorb");
  begin_ledger();
  begun_ = true;
  recovered_step_ = -1;
}

void Simulation::begin_ledger() {
  parts_->begin_ledger(plan.dynamic ? stepper_->first_ahead() : 0);
}

std::string Simulation::settle() {
  std::vector<Rates> velocities;
  for (const BlockState& state : model.blocks) velocities.push_back(state.velocity);
  std::string note = Equilibrium(*parts_).settle();
  for (size_t b = 0; b < velocities.size(); ++b) model.blocks[b].velocity = velocities[b];
  return note;
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

const Gas* Simulation::gas() const {
  return parts_->gas.get();
}

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
  return totals.steps >= least && model.time >= time.t_end && model.load_way.part == 1 && !parts_->bonds_due();
}

const std::vector<int>& Simulation::fractures() const {
  return half_steps_ ? half_steps_->fractures() : parts_->fractures();
}

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
  if (!begun_) return;
  if (!plan.dynamic) load_steps_->before_change();
  if (changed_) return;
  rest_at_change_ = energies().unexplained;
  changed_ = true;
  recovered_step_ = -1;
}

double Simulation::displacement_until() const {
  return plan.dynamic && begun_ ? model.time + stepper_->step_size().next(model.time) : change_until();
}

void Simulation::book_change() {
  if (!changed_) return;
  if (plan.dynamic) {  // else with the load step
    ledger.external_work = energies().external;
    ledger.keep_largest();
  }
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
