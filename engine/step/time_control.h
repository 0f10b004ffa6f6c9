#pragma once
// The size of the next step.
#include <algorithm>

#include "model/model.h"

namespace talus {

class StepSize {
 public:
  StepSize(const Model& model, bool contacts, bool fracture);

  double next(double time) const;  // s, never past t_end
  bool too_far(double displacement) const { return displacement > (automatic_ ? 2 * limit_ : thinnest_); }
  void cut(double dt, double displacement);  // after an attempt of `dt` that was thrown away
  void accepted(double dt, double displacement, int iterations);
  double least() const { return least_; }
  // The bounds come from the scene; a restart may have set others.
  template <class Visitor>  // of the registry, model/registry.h
  void visit_state(Visitor& visitor) {
    visitor("dt", dt_);
    visitor("cautious", cautious_);
    dt_ = std::min(dt_, most_);
  }

 private:
  double limit_;     // m, displacement a step
  double thinnest_;  // m, what a step given by the user may not pass either, where blocks can meet
  bool automatic_;
  double dt_, least_, most_, end_;
  int caution_;       // steps, after one that did not converge
  int cautious_ = 0;  // steps still to be grown slowly
  double every_;  // s, between outputs, which an automatic step does not pass; 0: none
};

}  // namespace talus
