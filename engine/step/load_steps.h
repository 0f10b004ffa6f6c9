#pragma once
// Static loading: increments of load that stop where the first bond reaches its strength, and bonds that fail under a
// load held until nothing more breaks.
#include <string>
#include <vector>

#include "step/closure.h"
#include "step/equilibrium.h"
#include "step/load_path.h"
#include "step/load_step_booking.h"
#include "step/step_parts.h"

namespace talus {

class LoadSteps {
 public:
  explicit LoadSteps(StepParts& parts);

  // Equilibrium under the loads of a later time, `to` at most, or under the same load after the bonds that the last
  // step overstressed have failed. `first`: nothing was loaded before. Throws RunError where there is none and nothing
  // has failed yet.
  StepReport step(double to, bool first);
  void before_change();  // of materials or joints, by the script: what that puts in is booked with the next load step
  std::string collapse_note() const;  // of a load step that found no equilibrium

  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h

 private:
  struct IncrementBooking {
    LoadStepBooking loads;
    BridgeBooking bridges;
    const Closure& closure;
    double rest;  // J/m, unexplained before
    bool first;
  };

  StepReport take(double to, bool first);
  void go_on();
  StepReport load(double to, bool first);
  bool load_part(LoadPath& path, const ConstantsWay* constants, bool follow, bool first, StepReport& report);
  double reachable(double to) const;
  StepReport raise_load(double to, bool first);
  double foreseen(const LoadPath& path, double utilisation) const;
  double pace(const LoadPath& path, double utilisation) const;
  StepReport break_bonds(const std::vector<int>& due);
  void book(const LoadStepBooking& booking, bool first);
  bool book(const IncrementBooking& booking, LoadPath& path, bool jumped, double raised);
  void cut(LoadPath& path, double part);
  StepReport collapse(const EquilibriumSearch& search);

  StepParts& parts_;
  Model& model_;
  const Plan& plan_;
  RunTotals& totals_;
  Ledger& ledger_;
  Equilibrium equilibrium_;
  std::string collapse_;
  Constants constants_before_;  // where the script has changed them since the last load step
  int short_increments_ = 0;    // of load, one after the other
  // 1/s, or in a jump of loads over all of it, at which utilisations came up with the last of them
  double pace_ = 0;
};

}  // namespace talus
