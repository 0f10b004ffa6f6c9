#include "step/simulation.h"

#include <algorithm>

#include "equations/block_terms.h"
#include "equations/recovery.h"
#include "scene/build.h"
#include "step/part_timer.h"
#include "step/step.h"

namespace talus {

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
  stepper_ = std::make_unique<Stepper>(model, plan, totals);
  totals.seconds("build") = cpu_seconds() - start;
}

Simulation::~Simulation() = default;

StepReport Simulation::step() {
  const TimeControl& time = model.scene.time;
  begin();
  if (plan.dynamic) {
    last = stepper_->dynamic_step();
  } else {
    model.time = time.t_end * double(totals.steps + 1) / time.steps;
    last = stepper_->equilibrium(false);
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
  if (!begun_ && plan.dynamic && model.scene.time.settled_start) settle();
  begun_ = true;
}

void Simulation::settle() {
  std::vector<std::array<double, max_dofs>> velocities;
  for (const BlockState& state : model.blocks) velocities.push_back(state.velocity);
  if (const std::string note = stepper_->settle(); !note.empty()) notes.push_back(note);
  for (size_t b = 0; b < velocities.size(); ++b) model.blocks[b].velocity = velocities[b];
}

bool Simulation::finished() const {
  const TimeControl& time = model.scene.time;
  if (stopped_ || (time.max_steps > 0 && totals.steps >= time.max_steps)) return true;
  return plan.dynamic ? model.time >= time.t_end : totals.steps >= time.steps;
}

double Simulation::kinetic_energy() const {
  double sum = 0;
  for (size_t b = 0; b < model.blocks.size(); ++b) {
    const auto v = Eigen::Map<const DofColumn>(model.blocks[b].velocity.data());
    sum += v.dot(mass_matrix(model, int(b)) * v) / 2;
  }
  return sum;
}

double Simulation::strain_energy() const {
  double sum = 0;
  for (size_t b = 0; b < model.blocks.size(); ++b) {
    const Vec3& e = model.blocks[b].strain;
    const Vec3 stress = model.shapes[b].initial_stress + elasticity(model.material(int(b))) * e / 2;
    sum += model.shapes[b].area * e.dot(stress);
  }
  return sum;
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
