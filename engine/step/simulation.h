#pragma once
// A run: a model, the parts its plan calls for, the loop over steps and those who watch it.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/model.h"
#include "model/saved_state.h"
#include "scene/plan.h"
#include "step/ledger.h"
#include "step/totals.h"

namespace talus {

class StepParts;
class Stepper;
class HalfSteps;
class LoadSteps;
class Recovery;
class Gas;
struct GasEvent;

struct CheckLine {
  std::string name, value, expected;
  bool pass = false;
};  // talus.check, kept for run.json

class Simulation {
 public:
  explicit Simulation(Scene scene);  // builds the model; throws InputError
  ~Simulation();

  // Brings the scene to where the first step starts (a settled start); step() does so where it was not done.
  void begin();
  // One accepted step. Throws RunError when none can be accepted at dt_min.
  StepReport step();
  bool finished() const;  // t_end, the static load steps, or max_steps reached, or stop() called
  void stop() { stopped_ = true; }
  bool stopped() const { return stopped_; }
  bool begun() const { return begun_; }
  bool collapsed() const { return last.collapsed; }  // a static run has reached a load that nothing holds

  // Joints that failed in the last step.
  const std::vector<int>& fractures() const;
  const std::vector<GasEvent>& gas_events() const;  // what charges did in the last step
  const Gas* gas() const;                           // null where there are no charges

  // The state between two steps. restore() continues from it bit by bit; it throws StateError and leaves
  // everything as it was when `state` is not of this scene.
  std::string save() const;
  void restore(const std::string& state);
  std::uint64_t hash() const;
  std::uint64_t layout() const;  // which tables save() writes
  const Fingerprint& scene_fingerprint() const { return fingerprint_; }

  Model model;
  Plan plan;
  RunTotals totals;
  StepReport last;
  std::vector<std::string> notes;  // what the user should know of the run; shown and kept in run.json
  Ledger ledger;                   // of energy, since the start of the run
  Energies energies() const;
  // To be called before materials, joint properties, supports or velocities are changed between two steps: what that
  // adds to the energy is work put in.
  void before_change();
  // s, until when a load or support that is changed now comes to what it becomes: over the next load step. 0 in motion,
  // and before the first: at once.
  double change_until() const { return plan.dynamic || totals.steps == 0 ? 0 : next_load(); }
  // The same of a support's displacement, which in motion comes over the next step: at once it would strain its spring
  // by all of it.
  double displacement_until() const;
  StepParts& step_parts() { return *parts_; }
  Stepper& stepper() { return *stepper_; }
  // Smoothed stress, brought up to date on first use after a step. Null when numerics.recovery is off.
  const Recovery* recovery();

  // Called after every accepted step (in order of registration), and once before the first (step = 0).
  std::vector<std::function<void(Simulation&)>> on_step;

 private:
  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h
  template <class Visitor>
  Visitor visited() const;  // by a visitor that only reads
  void take_step();
  void refuse_driven_in() const;
  std::string strain_note() const;
  void begin_ledger();
  void book_change();
  std::string settle();  // equilibrium, with the initial velocities kept; what is to be said where there is none

  Fingerprint fingerprint_;
  std::unique_ptr<StepParts> parts_;
  std::unique_ptr<Stepper> stepper_;       // motion
  std::unique_ptr<LoadSteps> load_steps_;  // static
  std::unique_ptr<HalfSteps> half_steps_;  // where the errors of steps are looked at
  std::unique_ptr<Recovery> recovery_;
  long recovered_step_ = -1;
  double next_load() const;  // s, to which the next load step goes
  bool begun_ = false, stopped_ = false;
  bool changed_ = false;       // since the last step, by before_change()
  double rest_at_change_ = 0;  // J/m, that was unexplained then
};

}  // namespace talus
