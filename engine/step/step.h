#pragma once
// One step of the simulation, and equilibrium.
#include <functional>
#include <vector>

#include "contact/detection.h"
#include "equations/contact_terms.h"
#include "equations/joint_terms.h"
#include "equations/linear_solver.h"
#include "model/state_visitor.h"
#include "scene/plan.h"
#include "step/energies.h"
#include "step/ledger.h"
#include "step/open_close.h"
#include "step/simulation.h"
#include "step/time_control.h"

namespace talus {

class Stepper {
 public:
  Stepper(Model& model, const Plan& plan, RunTotals& totals, Ledger& ledger);

  // One accepted step from model.time. Throws RunError when none can be accepted at the least time step; the model
  // is then as it was.
  StepReport dynamic_step();
  // Equilibrium under the loads of model.time; those of the step before were of `from`, `first`: there were none.
  StepReport load_step(double from, bool first);
  // The start of a settled run: equilibrium with friction where there is one, else that in which nothing slides.
  // What is to be said to the user where there is neither, and nothing has moved.
  std::string settle();

  void begin_ledger();  // the energies since the present state
  Energies energies();

  // Called with what is about to be solved for contacts in a step of motion, at every attempt (tests/contact).
  std::function<void(const Scheme&, const System&, const ContactTerms&)> on_assembled;

  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h
  void restored();                          // the model has been put back: what was derived from it is stale

 private:
  Scheme scheme(double dt) const;
  void prepare_bonds();
  StepReport equilibrium(bool stick);
  struct Equilibrium {
    StepReport report;
    OpenCloseResult last;
    Vector d;  // m, last displacements
  };
  bool find_equilibrium(bool stick, double hold, int iterations, Equilibrium& search);
  OpenCloseResult solve(bool motion, Vector& d);
  bool rests(double dt);
  OpenCloseResult stay(Vector& d);
  void assemble(const Scheme& scheme, bool stick, double nearness);
  void accept(std::vector<BlockState> moved, const Scheme& scheme, const Vector& d);
  [[noreturn]] void give_up(const OpenCloseResult& result, double dt) const;
  int culprit(const Equilibrium& search) const;  // the block that is named when there is no equilibrium

  Model& model_;
  const Plan& plan_;
  RunTotals& totals_;
  Ledger& ledger_;
  StepSize step_size_;
  ContactSearch search_;
  JointTerms joints_;
  Supports supports_;
  ContactTerms contacts_;
  std::vector<Contact> contacts_before_;  // the attempt at a step
  Poses poses_;
  System system_;
  LinearSolver solver_;
  OpenClose open_close_;
  long revision_ = -1;
};

}  // namespace talus
