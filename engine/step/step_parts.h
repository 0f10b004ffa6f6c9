#pragma once
// What steps in motion and searches for equilibrium are both made of: the terms that the plan calls for, the linear
// system that they put together, and its solution with contacts.
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "contact/detection.h"
#include "equations/contact_terms.h"
#include "equations/joint_terms.h"
#include "equations/term.h"
#include "fracture/fracture.h"
#include "gas/gas.h"
#include "model/state_visitor.h"
#include "scene/plan.h"
#include "step/island_solver.h"
#include "step/ledger.h"
#include "step/sleep.h"
#include "step/totals.h"

namespace talus {

// Which contacts a system is put together with.
struct ContactChoice {
  bool stick = false;                            // those of joints that touch do not slide
  double pressed = ContactTerms::least_pressed;  // part of its cohesion with which one is pressed that has it
  std::span<const double> nearness = {};         // per block; empty: 1 (ContactTerms::linearise)
};

class StepParts {
 public:
  StepParts(Model& model, const Plan& plan, RunTotals& totals, Ledger& ledger);

  // What hangs on materials and bonds alone, where the script has changed them since.
  void prepare_bonds();
  // K d = f for everything but contacts and softening bonds, and the contacts' rows. Where a step in motion begins as
  // the last one did, in which nothing moved, rows, pattern and islands are those of that; not where bonds fail, as a
  // script's law of what they leave may go by the time.
  void assemble(const Scheme& scheme, const ContactChoice& choice);
  // dt = 0: equilibrium.
  IslandResult solve(double dt, double most_effort, Vector& d);

  struct Released {  // J/m, of what bonds that failed stored, and their blocks through them
    double energy = 0;
    // of that what they stored by the way from X to y alone, which the integrator's loss counts with the state
    double on_way = 0;
  };
  Released fail(const std::vector<int>& due, double time, bool motion, const std::vector<BondTraction>& judged = {});
  // J/m, with which the contacts begin that take over from bonds that have failed in this step
  double contacts_of_events() const;
  int initial_cracks();  // bonds beyond their strength before the first step fail: how many did
  bool bonds_due() const { return fracture && fracture->any_due(); }
  const std::vector<int>& fractures() const;  // joints that failed in the last step

  void begin_ledger(double ahead);  // the energies since the present state
  Energies energies();
  double elastic_energy(double ahead);
  int closed_contacts();
  std::vector<Vec2> reactions();  // N/m per fixity, on what it holds
  double transit() const { return transit_; }

  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h
  // the model has been put back, rewound() follows: what hangs on materials is stale
  void restored();
  void rewound();  // to the start of a step: what was derived from the model's state is stale

  // Of a program of one's own, from before the first step on (docs/extending.md).
  std::vector<std::shared_ptr<const Term>> terms;
  // Called before each solve for equilibrium, of which a load step may take thousands; what it throws ends the step,
  // and Simulation::step() puts everything back.
  std::function<void()> on_equilibrium_solve;

  Model& model;
  const Plan& plan;
  RunTotals& totals;
  Ledger& ledger;
  ContactSearch search;
  JointTerms joints;
  Supports supports;
  ContactTerms contacts;
  Poses poses;
  System system;
  IslandSolver islands;
  Sleep sleep;
  std::unique_ptr<Gas> gas;            // where there are charges
  std::unique_ptr<Fracture> fracture;  // where bonds can fail

 private:
  void link(const Scheme& scheme, const ContactChoice& choice);
  bool balances_as_before() const;
  void fail_in_motion(const std::vector<int>& due, double time, const std::vector<BondTraction>& judged);

  bool plain_ = false;  // the last assembly was one that may serve again: see assemble()
  bool linked_as_before_ = false;
  struct {  // of the last solution of such a one, if nothing moved in it
    Vector force;
    std::vector<double> scale, rounding;
  } at_rest_;
  std::vector<int> block_sizes_;  // unknowns of each block
  long revision_ = -1;
  double transit_ = 0;  // s, Fracture::least_transit() of the present revision
};

}  // namespace talus
