// Bonds that fail in a step of motion, or before the first one.
#include <algorithm>
#include <utility>

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

const std::vector<int>& Stepper::fractures() const {
  static const std::vector<int> none;
  return fracture_ ? fracture_->events() : none;
}

int Stepper::initial_cracks() {
  prepare_bonds();
  joints_.store_tractions(model_);
  fracture_->judge();
  const std::vector<int> due = fracture_->choose(false);
  fracture_->fail(due, model_.time);
  step_size_.broken(model_);
  return int(due.size());
}

// Not where a law had failed or had no end, which would be asked again: then as the next step begins.
void Stepper::left() {
  if (std::exchange(gave_up_, false) && judged_astray_) judge_again();
}

// Whether bonds fail where the step leads and it is to be taken again. Not in a step shorter than a wave takes through a block, in which a
// bond cannot feel yet that another has failed: those that are due then fail at the start of the next. The states are only lent to the model.
bool Stepper::breaks(double dt, StepReport& report) {
  StepTimer timer(totals_, "fracture");
  judged_astray_ = true;  // until the step is accepted
  std::vector<int> due;
  std::vector<BondTraction> judged;
  {
    const Lent lent(model_, moved_);
    joints_.store_tractions(model_);
    report.utilisation = std::max(report.utilisation, fracture_->judge());
    if (dt >= transit_) due = fracture_->choose(true);
    for (const int j : due) judged.push_back(mean_traction(model_.joints[j]));
  }
  if (due.empty()) return false;
  joints_.store_tractions(model_);
  fail(due, model_.time + dt, true, judged);
  return true;
}

// Bonds where the blocks are.
void Stepper::judge_again() {
  StepTimer timer(totals_, "fracture");
  joints_.store_tractions(model_);
  fracture_->judge();
  judged_astray_ = false;
}

// In motion the blocks beside keep as strain what the jump of their bond was to them. Where they strain more than their bond would let
// them, as in an impact on few blocks, its potential is below nought: without it, and without that strain, they would have more energy.
void Stepper::fail(const std::vector<int>& due, double time, bool motion, const std::vector<BondTraction>& judged) {
  if (due.empty()) return;
  const double before = elastic_energy(ledger_.ahead), before_at_x = elastic_energy(0);
  if (motion)
    for (const int j : due) {
      const auto [of_a, of_b] = joints_.strain_of_jump(model_, j, ledger_.ahead);
      fracture_->add_strain(model_.joints[j].a, of_a);
      fracture_->add_strain(model_.joints[j].b, of_b);
    }
  fracture_->fail(due, time, judged);
  const double released = before - elastic_energy(ledger_.ahead);
  released_ += released;
  released_on_way_ += released - (before_at_x - elastic_energy(0));
}

// Of a step that is accepted.
void Stepper::keep_failures(Course& course, StepReport& report) {
  ledger_.fracture_work += course.released;
  ledger_.numerical_flow -= released_on_way_;
  course.bridges->book(model_, bridge_motion_.keep(model_), ledger_);
  fracture_->weaken();
  report.failures = int(fracture_->events().size());
  if (report.failures > 0) step_size_.broken(model_);
}

// J/m, with which the contacts begin that take over from bonds that have failed in this step.
double Stepper::contacts_of_events() const {
  const auto& events = fracture_->events();
  if (events.empty()) return 0;
  std::vector<char> fails(model_.joints.size(), 0);
  for (const int j : events) fails[j] = 1;
  double sum = 0;
  for (const Contact& c : model_.contacts)
    if (c.joint >= 0 && fails[c.joint]) {
      const double pressed = pressed_at_start(c);
      sum += c.normal_stiffness / 2 * pressed * pressed + c.shear_force * c.shear_force / (2 * c.shear_stiffness);
    }
  return sum;
}

}  // namespace talus
