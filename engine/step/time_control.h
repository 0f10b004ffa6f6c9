#pragma once
// The size of the next step.
#include "model/model.h"

namespace talus {

class StepSize {
 public:
  explicit StepSize(const Model& model);

  double next(double time) const;  // s, never past t_end
  bool too_far(double displacement) const { return automatic_ && displacement > 2 * limit_; }
  void cut(double dt, double displacement);  // after an attempt of `dt` that was thrown away
  void accepted(double dt, double displacement, int iterations);
  double least() const { return least_; }

 private:
  double limit_;  // m, displacement a step
  bool automatic_;
  double dt_, least_, most_, end_;
};

}  // namespace talus
