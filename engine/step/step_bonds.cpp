// Bonds that fail: in a step of motion, under a load held, or before the first step.
#include <algorithm>
#include <utility>

#include "step/bond_release.h"
#include "step/part_timer.h"
#include "step/step.h"

namespace talus {

namespace {

class Lent {  // blocks where a step leads, also where a criterion of the script fails there
 public:
  Lent(Model& model, std::vector<BlockState>& moved) : model_(model), moved_(moved) { model_.blocks.swap(moved_); }
  ~Lent() { model_.blocks.swap(moved_); }
  Lent(const Lent&) = delete;
  Lent& operator=(const Lent&) = delete;

 private:
  Model& model_;
  std::vector<BlockState>& moved_;
};

}  // namespace

// After give_up() alone. A law of the script that failed would be asked again here: its bonds are judged as the next
// step begins.
void Stepper::left() {
  if (std::exchange(gave_up_, false) && judged_astray_) judge_again();
}

// Whether bonds fail where the step leads and it is to be taken again. Not in a step shorter than a wave takes through
// a block, in which a bond cannot feel yet that another has failed: those that are due then fail at the start of the
// next. The states are only lent to the model.
bool Stepper::breaks(double dt, StepReport& report) {
  StepTimer timer(totals_, "fracture");
  judged_astray_ = true;  // until the step is accepted
  for (;;) {
    std::vector<int> due;
    std::vector<BondTraction> judged;
    {
      const Lent lent(model_, moved_);
      parts_.joints.store_tractions(model_);
      report.utilisation = std::max(report.utilisation, parts_.fracture->judge());
      if (dt >= parts_.transit()) due = parts_.fracture->choose(true);
      for (const int j : due) judged.push_back(mean_traction(model_.joints[j]));
    }
    if (due.empty()) return false;
    parts_.joints.store_tractions(model_);
    if (fail(due, model_.time + dt, judged)) return true;
  }
}

// Bonds where the blocks are.
void Stepper::judge_again() {
  StepTimer timer(totals_, "fracture");
  parts_.joints.store_tractions(model_);
  parts_.fracture->judge();
  judged_astray_ = false;
}

// Whether any of them does: those that would make energy wait, in this step.
bool Stepper::fail(const std::vector<int>& due, double time, const std::vector<BondTraction>& judged) {
  const std::size_t before = parts_.fracture->events().size();
  const StepParts::Released released = parts_.fail(due, time, true, judged);
  released_.energy += released.energy;
  released_.on_way += released.on_way;
  return parts_.fracture->events().size() > before;
}

// Of a step that is accepted.
void Stepper::keep_failures(Course& course, StepReport& report) {
  ledger_.fracture_work += course.released;
  ledger_.numerical_flow -= released_.on_way;
  course.bridges->book(model_, bridge_motion_.keep(model_), ledger_);
  parts_.fracture->weaken();
  report.failures = int(parts_.fracture->events().size());
  if (report.failures > 0) step_size_.broken(model_);
}

int StepParts::initial_cracks() {
  prepare_bonds();
  joints.store_tractions(model);
  fracture->judge();
  const std::vector<int> due = fracture->choose(false);
  fracture->fail(due, model.time);
  return int(due.size());
}

StepParts::Released StepParts::fail(const std::vector<int>& due, double time, bool motion,
                                    const std::vector<BondTraction>& judged) {
  if (due.empty()) return {};
  const double before = elastic_energy(ledger.ahead), before_at_x = elastic_energy(0);
  if (motion)
    fail_in_motion(due, time, judged);
  else
    fracture->fail(due, time, judged);
  const double energy = before - elastic_energy(ledger.ahead);
  return {energy, energy - (before_at_x - elastic_energy(0))};
}

// In motion the blocks beside keep as strain what the jump of their bond was to them. Where they strain more than their
// bond would let them, as in an impact on few blocks, its potential is below nought: without it, and without that
// strain, they would have more energy.
void StepParts::fail_in_motion(const std::vector<int>& due, double time, const std::vector<BondTraction>& judged) {
  std::vector<int> failing;
  std::vector<BondTraction> failing_judged;
  BondRelease release(model, joints, due, ledger.ahead);
  for (size_t k = 0; k < due.size(); ++k) {
    const auto strains = release.fail(due[k]);
    if (!strains) {
      fracture->hold_back(due[k]);
      continue;
    }
    fracture->add_strain(model.joints[due[k]].a, strains->front());
    fracture->add_strain(model.joints[due[k]].b, strains->back());
    failing.push_back(due[k]);
    if (!judged.empty()) failing_judged.push_back(judged[k]);
  }
  fracture->fail(failing, time, failing_judged);
}

double StepParts::contacts_of_events() const {
  const auto& events = fracture->events();
  if (events.empty()) return 0;
  std::vector<char> fails(model.joints.size(), 0);
  for (const int j : events) fails[j] = 1;
  double sum = 0;
  for (const Contact& c : model.contacts)
    if (c.joint >= 0 && fails[c.joint]) {
      const double pressed = pressed_at_start(c);
      sum += c.normal_stiffness / 2 * pressed * pressed + c.shear_force * c.shear_force / (2 * c.shear_stiffness);
    }
  return sum;
}

}  // namespace talus
