#pragma once
// The size of the next step.
#include <algorithm>

#include "model/model.h"

namespace talus {

// s, the first time after `time` at which a table of a load, support or body force bends or jumps, or infinity: an
// automatic step ends there.
double next_bend(const Scene& scene, double time);

class StepSize {
 public:
  StepSize(const Model& model, bool contacts);
  void among_cracks();  // bonds can fail
  // s, a wave's way through a block: shorter steps are not easier to solve.
  void short_enough(double transit) { short_enough_ = transit; }
  void broken(const Model& model);  // bonds have failed
  void restored(const Model& model);
  // Whether no bond has failed for so long that contacts come and go no more than in rubble.
  bool quiet() const { return since_broken_ >= quiet_steps; }

  double next(double time) const;  // s, never past t_end
  // m, the displacement that bounds an automatic step as turning by `turn` (rad) does.
  double as_far_as(double turn) const { return turn / most_turn * limit_; }
  // Whether a step in which a block moves so far may not grow as it would.
  bool bounded_by(double displacement) const { return displacement > (automatic_ ? limit_ : thinnest_) / 2; }
  bool heeds_turns() const { return heeds_turns_; }
  // rad: where all turn by less in a step, the lever of a contact comes and goes with half the square of it. What
  // topples from near its balance has no more energy than that at first; a step that was given, and even more one among
  // cracks, is not halved for so little.
  double straight() const { return straight_; }
  bool too_far(double displacement) const { return displacement > (automatic_ ? 2 * limit_ : thinnest_); }
  void cut(double dt, double displacement);  // after an attempt of `dt` that was thrown away
  // An attempt whose contacts were not those that it came to meet is taken again in half of it.
  bool may_halve(double dt) const { return dt / 2 >= least_; }
  void halve(double dt) { dt_ = std::max(dt / 2, least_); }
  void at_most(double seconds) {  // the next one, where steps are automatic
    if (automatic_) dt_ = std::min(dt_, std::max(seconds, least_));
  }
  void stop_in(double seconds) {  // an automatic step, and the one before it is no short one
    if (automatic_ && seconds < 2 * dt_) dt_ = std::max(least_, seconds <= dt_ ? seconds : seconds / 2);
  }
  // A change to `dt` from `last`: that length again, or half of dt where that is more, and then slowly on. Where that
  // did not help, as what swings gains in steps of any length, not again meanwhile: steps would only ever become
  // shorter.
  bool may_regret() const { return regrets_help_ || cautious_ == 0; }
  void regretted(bool helped) { regrets_help_ = helped; }
  void regret(double dt, double last) {
    dt_ = std::clamp(last, std::max(least_, dt / 2), most_);
    cautious_ = caution_;
  }
  struct Motion {
    double displacement;  // m
    double turn;          // rad, of what is pressed
    double turning_gain;  // energy that turning leaves, by the square of the step, of what it may; 0 below heeded_gain
  };
  // effort: what the solution took, in factors. split_anew: part of what moves whose contacts only the splitting
  // solved, where it did not before.
  void accepted(double dt, const Motion& motion, double effort, double split_anew);
  static constexpr double heeded_gain = 0.2;  // of which a step that grows by half makes less than a half
  double least() const { return least_; }
  bool is_least(double dt) const { return dt <= least_ * (1 + 2 * as_good_as); }
  // The bounds come from the scene; a restart may have set others.
  template <class Visitor>  // of the registry, model/registry.h
  void visit_state(Visitor& visitor) {
    visitor("dt", dt_);
    visitor("cautious", cautious_);
    visitor("regrets_help", regrets_help_);
    visitor("since_split", since_split_);
    visitor("since_broken", since_broken_);
    dt_ = std::min(dt_, most_);
  }

 private:
  static constexpr double as_good_as = 1e-6;  // of a step, by which it may be longer, to end at what is to be met
  // rad a step: what rolls or topples then lands as it would in short steps. Measured: verification, rolling.
  static constexpr double most_turn = 0.05;
  double limit_;     // m, displacement a step
  double thinnest_;  // m, what a step given by the user may not pass either, where blocks can meet
  bool automatic_;
  double dt_, least_, most_, end_;
  int caution_;              // steps, after one that did not converge
  double worth_;             // factors, from which on a longer step does not pay
  double growth_;            // of a step that went well
  double short_enough_ = 0;  // s, not shortened for what it takes
  bool heeds_effort_, heeds_splits_ = true, heeds_turns_;
  double straight_;   // rad
  int cautious_ = 0;  // steps still to be grown slowly
  bool regrets_help_ = true;
  int since_split_;                       // steps since one that accepted() was told of with split_anew
  static constexpr int quiet_steps = 10;  // what a bond lets go of has struck or left its neighbours by then
  int since_broken_ = 0;                  // steps since bonds have failed, or the first
  double every_;                          // s, between outputs, which an automatic step does not pass; 0: none
};

}  // namespace talus
