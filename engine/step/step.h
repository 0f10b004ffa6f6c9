#pragma once
// One step of the simulation, and equilibrium.
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/detection.h"
#include "equations/bridge_motion.h"
#include "equations/bridge_terms.h"
#include "equations/contact_terms.h"
#include "equations/joint_terms.h"
#include "equations/term.h"
#include "fracture/fracture.h"
#include "gas/gas.h"
#include "model/state_visitor.h"
#include "scene/plan.h"
#include "step/alternation.h"
#include "step/energies.h"
#include "step/ledger.h"
#include "step/island_solver.h"
#include "step/sleep.h"
#include "step/simulation.h"
#include "step/time_control.h"

namespace talus {

class Attempt;  // step/attempt.h

class Stepper {
 public:
  Stepper(Model& model, const Plan& plan, RunTotals& totals, Ledger& ledger);

  // One accepted step from model.time. Throws RunError when none can be accepted at the least time step; the model
  // is then as it was, as when a law of the script throws but where half_done().
  // `most`: s, no step is longer.
  StepReport dynamic_step(double most = std::numeric_limits<double>::infinity());
  // Static (step/load_step.cpp): equilibrium under the loads of a later time, `to` at most, or under the same load after
  // the bonds that the last step overstressed have failed. `first`: nothing was loaded before.
  StepReport load_step(double to, bool first);
  std::string collapse_note() const;  // of a load step that found no equilibrium
  // Bonds beyond their strength before the first step fail. How many did.
  int initial_cracks();
  // A step was left by an exception: bonds are judged where the blocks are, not where it would have led.
  void left();
  // It was left after it had been accepted, before all was done that follows; until restored().
  bool half_done() const { return half_done_; }
  StepSize& step_size() { return step_size_; }
  bool bonds_due() const { return fracture_ && fracture_->any_due(); }
  const std::vector<int>& fractures() const;  // joints that failed in the last step
  const Gas* gas() const { return gas_.get(); }
  // The start of a settled run: equilibrium with friction where there is one, else that in which nothing slides.
  // What is to be said to the user where there is neither, and nothing has moved.
  std::string settle();

  std::vector<Vec2> reactions();  // N/m per fixity, on what it holds

  void begin_ledger();  // the energies since the present state
  Energies energies();
  int closed_contacts();

  // Called with what is about to be solved for contacts in a step of motion, at every attempt (tests/contact).
  std::function<void(const Scheme&, const System&, const ContactTerms&)> on_assembled;

  // Called before each solve for equilibrium, of which a load step may take thousands; what it throws ends the step, and
  // Simulation::step() puts everything back.
  std::function<void()> on_equilibrium_solve;

  // Of a program of one's own, from before the first step on (docs/extending.md).
  std::vector<std::shared_ptr<const Term>> terms;

  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h
  void restored();                          // the model has been put back: what was derived from it is stale
  void rewound();                           // to the start of a step, by the same run: nobody has changed materials since

 private:
  Scheme scheme(double dt) const;
  double next_dt() const;
  void prepare_bonds();
  struct Equilibrium {
    StepReport report;
    OpenCloseResult last;
    Vector d;  // m, last displacements
    Alternation alternation;
    int most_solves = std::numeric_limits<int>::max();
    bool may_jump = true;    // through states that are not stable
    bool jumped = false;
    bool in_place = false;   // ends where a body topples or falls
    int left = -1;           // a block of that body
    bool whole_way = false;  // friction by all that slides in the load step, not by what each solve of the search slides
  };
  bool find_equilibrium(bool stick, double hold, int iterations, Equilibrium& search);
  bool balance(Equilibrium& search);
  void start_sliding();
  double reachable(double to) const;
  double foreseen(double from, double to, double utilisation) const;
  StepReport raise_load(double to, bool first);
  void book_load(const LoadStepBooking& booking, bool first);
  StepReport collapse(const Equilibrium& search);
  StepReport break_bonds(const std::vector<int>& due);
  [[noreturn]] void give_up(const Equilibrium& search) const;
  struct Course {  // what an attempt at a step comes to
    IslandResult result;
    Vector d;                              // m, of the unknowns
    bool past = false;                     // contacts that it did not have
    bool woke = false;                     // something that sleeps, by what it throws
    double far = 0;                        // m, that bounds the step
    int crushed = -1;                      // block
    double released = 0;                   // J/m, by bonds that fail in it, but for what their contacts begin with
    std::optional<BridgeBooking> bridges;  // where bonds can fail
  };
  void shorten();
  bool regret(double dt, double last, double most);
  std::optional<Energies> begin(const Scheme& scheme, Attempt& attempt);
  Course seek(const Scheme& scheme, Attempt& attempt, StepReport& report);
  void keep_failures(Course& course, StepReport& report);
  bool breaks(double dt, StepReport& report);
  void judge_again();
  void change_step(double ahead);
  void fail(const std::vector<int>& due, double time, bool motion, const std::vector<BondTraction>& judged = {});
  double contacts_of_events() const;
  double elastic_energy(double ahead);
  bool settled(const Scheme& scheme, const Vector& d);
  double hold_and_leave(bool stick, const std::vector<BlockState>& moved, double least);
  IslandResult solve(double dt, Vector& d);  // dt = 0: equilibrium
  void lead(const Scheme& scheme, Course& course);
  bool overlooks(double dt, double displacement, const Vector& d);
  bool turns_gain(const Scheme& scheme, const Course& course);
  void widen();
  void assemble(const Scheme& scheme, bool stick);
  void keep_rest(std::vector<BlockState>& moved);
  void count(const IslandResult& result);
  bool all_still() const;
  // For the ledger; none where nothing has moved in the step, and nothing did before it.
  std::optional<ContactBooking> contacts_at_start();
  // `booking`: of a step in motion; without it such a step has nothing to book.
  // Returns what the step has added to the energy it began with, where that is given.
  // The model's states are in `moved` afterwards.
  double accept(std::vector<BlockState>& moved, const Scheme& scheme, const Vector& d, const std::optional<ContactBooking>& booking = {},
                const std::optional<Energies>& start = {});
  [[noreturn]] void give_up(const OpenCloseResult& result, double dt, int crushed = -1) const;
  int culprit(const Equilibrium& search) const;  // the block that is named when there is no equilibrium

  Model& model_;
  const Plan& plan_;
  RunTotals& totals_;
  Ledger& ledger_;
  StepSize step_size_;
  ContactSearch search_;
  JointTerms joints_;
  BridgeTerms bridges_;           // in equilibrium
  BridgeMotion bridge_motion_;
  Supports supports_;
  ContactTerms contacts_;
  std::vector<Contact> contacts_before_;  // of what is awake, while a step is attempted
  Poses poses_;
  std::vector<BlockState> moved_;  // where an attempt at a step in motion leads
  long moved_of_ = -1;             // Model::sleep_changes of what sleeps in it
  std::vector<int> block_sizes_;  // unknowns of each block
  System system_;
  IslandSolver islands_;
  Sleep sleep_;
  std::vector<double> hold_;      // of equilibrium, per block; empty: none
  Vector hold_lead_;              // m; empty: none
  std::vector<double> nearness_;  // of contacts, per block; empty: 1 (ContactTerms::linearise)
  std::unique_ptr<Gas> gas_;            // where there are charges
  std::unique_ptr<Fracture> fracture_;  // where bonds can fail
  double transit_ = 0;                  // s, Fracture::least_transit() of the present revision
  std::string collapse_;
  int short_increments_ = 0;  // of load, one after the other
  double pace_ = 0;           // 1/s, at which utilisations came up with the last of them
  long revision_ = -1;
  // Part of its cohesion with which a contact is pressed that has it. With every attempt that finds no solution more: where cohesion lifts what presses
  // it, the law may have none.
  double pressed_ = ContactTerms::least_pressed;
  // Solves of an attempt for the jumps of bonds, each of which leaves some hundredth of what was missing.
  int again_ = 0;
  static constexpr int most_again = 5;
  double split_anew_ = 0;  // IslandResult's, of an attempt at a step
  bool weighed_late_ = true;  // some block is not weighed at y, or may not be
  double effort_ = 0;  // of the solves of an attempt at a step, in factors
  bool half_done_ = false, gave_up_ = false;
  bool judged_astray_ = false;   // bonds have been judged where an attempt led that came to nothing
  double released_ = 0;         // J/m, that bonds stored which have failed in an attempt, and their blocks through them
  double released_on_way_ = 0;  // J/m, of that what they stored by the way from X to y alone, which the integrator's loss counts with the state
};

}  // namespace talus
