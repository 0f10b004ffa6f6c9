#pragma once
// Static loading: increments of load that stop where the first bond reaches its strength, and bonds that fail under a load
// held until nothing more breaks.
#include <string>
#include <vector>

#include "step/equilibrium.h"
#include "step/step_parts.h"

namespace talus {

class LoadSteps {
 public:
  explicit LoadSteps(StepParts& parts);

  // Equilibrium under the loads of a later time, `to` at most, or under the same load after the bonds that the last step
  // overstressed have failed. `first`: nothing was loaded before. Throws RunError where there is none and nothing has failed yet.
  StepReport step(double to, bool first);
  std::string collapse_note() const;  // of a load step that found no equilibrium

  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h

 private:
  // Of a load step: from one time to another, or of the way of loads that jump between these.
  struct Part {
    double from, until;       // s
    double come = 0, go = 1;  // parts of the way
  };

  StepReport take(double to, bool first);
  StepReport load(double to, bool first);
  bool may_quarter(double increment) const;
  bool quarter(Part& part, bool alike, bool first) const;
  double reachable(double to) const;
  double foreseen(double from, double to, double utilisation) const;
  StepReport raise_load(double to, bool first);
  StepReport break_bonds(const std::vector<int>& due);
  void book(const LoadStepBooking& booking, bool first);
  StepReport collapse(const EquilibriumSearch& search);

  StepParts& parts_;
  Model& model_;
  const Plan& plan_;
  RunTotals& totals_;
  Ledger& ledger_;
  Equilibrium equilibrium_;
  std::string collapse_;
  int short_increments_ = 0;  // of load, one after the other
  double pace_ = 0;           // 1/s, at which utilisations came up with the last of them
};

}  // namespace talus
