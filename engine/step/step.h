#pragma once
// One step in motion. Equilibrium: step/equilibrium.h.
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "equations/bridge_motion.h"
#include "step/step_parts.h"
#include "step/time_control.h"

namespace talus {

class Attempt;  // step/attempt.h

class Stepper {
 public:
  explicit Stepper(StepParts& parts);

  // One accepted step from model.time. Throws RunError when none can be accepted at the least time step; the model
  // is then as it was, as when a law of the script throws but where half_done().
  // `most`: s, no step is longer.
  StepReport dynamic_step(double most = std::numeric_limits<double>::infinity());
  // A step was left by an exception. Where none could be accepted, bonds are judged where the blocks are, not where the
  // last attempt had led.
  void left();
  // It was left after it had been accepted, before all was done that follows; until restored().
  bool half_done() const { return half_done_; }
  StepSize& step_size() { return step_size_; }
  // s, of the energies before the first step
  double first_ahead() const { return scheme(step_size_.next(model_.time)).bond_ahead; }

  // Called with what is about to be solved for contacts, at every attempt (tests/contact).
  std::function<void(const Scheme&, const System&, const ContactTerms&)> on_assembled;

  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h; with that of the parts
  void restored();                          // the model has been put back: what was derived from it is stale
  // to the start of a step, by the same run: nobody has changed materials since
  void rewound();

 private:
  struct Course {  // what an attempt at a step comes to
    IslandResult result;
    Vector d;                                 // m, of the unknowns
    std::optional<std::pair<int, int>> past;  // blocks that met where it had no contact
    bool woke = false;                        // something that sleeps, by what it throws
    double far = 0;                           // m, that bounds the step
    double turn = 0;                          // rad, the largest of what is pressed, where steps heed that
    double turning_gain = 0;                  // what turning leaves of energy, of what it may
    int crushed = -1;                         // block
    double released = 0;                      // J/m, by bonds that fail in it, but for what their contacts begin with
    std::optional<BridgeBooking> bridges;     // where bonds can fail
  };
  Scheme scheme(double dt) const;
  double next_dt() const;
  void shorten();
  bool regret(double dt, double last, double most);
  // The energies before the step, where what it loses pays for what is unpaid; `changed`: it is another than the last
  // and may add to them.
  struct Start {
    std::optional<Energies> energies;
    bool changed = false;
  };
  Start begin(const Scheme& scheme, Attempt& attempt, bool regretted);
  Course seek(const Scheme& scheme, Attempt& attempt, StepReport& report);
  void assemble(const Scheme& scheme);
  IslandResult solve(const Scheme& scheme, Vector& d);
  bool settled(const Scheme& scheme, const Vector& d);
  void lead(const Scheme& scheme, Course& course);
  std::optional<std::pair<int, int>> overlooks(double dt, double displacement, const Vector& d, bool first);
  double turning_gain(const Scheme& scheme, const Course& course);
  double kinetic_energy_moved();  // J/m, of where the step leads
  // J/m, and what moves: all there is
  double stored(const Energies& energies) const { return energies.stored() + prestressed_; }
  void widen();
  void count(const IslandResult& result);
  // step/step_bonds.cpp
  bool breaks(double dt, StepReport& report);
  bool fail(const std::vector<int>& due, double time, const std::vector<BondTraction>& judged = {});
  void judge_again();
  void keep_failures(Course& course, StepReport& report);
  bool all_still() const;
  // For the ledger; none where nothing has moved in the step, and nothing did before it: then there is nothing to book.
  std::optional<ContactBooking> contacts_at_start();
  // Returns what the step has added to the energy it began with, where that is given. The model's states are in moved_
  // afterwards.
  double accept(const Scheme& scheme, const Vector& d, const std::optional<ContactBooking>& booking,
                std::optional<Energies> start);
  void change_step(double ahead);
  [[noreturn]] void give_up(const Course& course, double dt) const;  // step/no_step.cpp

  StepParts& parts_;
  Model& model_;
  const Plan& plan_;
  RunTotals& totals_;
  Ledger& ledger_;
  const double prestressed_;  // J/m, from which strain energy counts: what relaxes has less than nothing of it
  StepSize step_size_;
  BridgeMotion bridge_motion_;
  std::vector<Contact> contacts_before_;  // of what is awake, while a step is attempted
  std::vector<BlockState> moved_;         // where an attempt at a step leads,
  std::vector<Vec2> moved_vertex_;        // with Model::vertex there
  long moved_of_ = -1;                    // Model::sleep_changes of what sleeps in it
  std::vector<double> nearness_;          // of contacts, per block; empty: 1 (ContactTerms::linearise)
  // Part of its cohesion with which a contact is pressed that has it. With every attempt that finds no solution more:
  // where cohesion lifts what presses it, the law may have none.
  double pressed_ = ContactTerms::least_pressed;
  // Solves of an attempt for the jumps of bonds, each of which leaves some hundredth of what was missing.
  int again_ = 0;
  static constexpr int most_again = 5;
  double split_anew_ = 0;  // IslandResult's, of an attempt at a step
  double effort_ = 0;      // of the solves of an attempt at a step, in factors
  bool half_done_ = false, gave_up_ = false;
  bool judged_astray_ = false;    // bonds have been judged where an attempt led that came to nothing
  StepParts::Released released_;  // by bonds that have failed in an attempt
};

}  // namespace talus
