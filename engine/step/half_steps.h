#pragma once
// Steps as long as their error allows: each is taken whole, then again as two halves, which stand. What the two ends
// differ by is the error of the whole step, and from it follows that of the halves (Richardson 1911; docs/theory.md, §
// 2).
#include <string>
#include <vector>

#include "model/model.h"
#include "step/step.h"

namespace talus {

class HalfSteps {
 public:
  HalfSteps(StepParts& parts, Stepper& stepper);

  // One accepted step of two halves. Throws RunError where the stepper does; the model is then as it was.
  StepReport step();
  const std::vector<int>& fractures() const { return fractures_; }  // of both halves
  const std::vector<GasEvent>& gas_events() const { return gas_events_; }
  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h

 private:
  std::string state();
  void put_back(const std::string& state);
  StepReport whole_step();
  StepReport halves(double dt, double end);
  void take_half(double dt, StepReport& sum);
  double allowed_error(double dt, double end) const;
  double error_of(const std::vector<BlockState>& whole);

  StepParts& parts_;
  Model& model_;
  Stepper& stepper_;
  RunTotals& totals_;
  Ledger& ledger_;
  double tolerance_, t_end_;
  double least_;        // s, below which errors are let be
  int order_;           // of the integrator
  double dt_;           // s, what the error allows
  double fastest_ = 0;  // J/m, most kinetic energy so far
  std::vector<int> fractures_;
  std::vector<GasEvent> gas_events_;
};

}  // namespace talus
