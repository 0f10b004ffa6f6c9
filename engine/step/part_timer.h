#pragma once
// CPU time by part, added to the run's totals.
#include <string>

#include "step/clock.h"
#include "step/simulation.h"

namespace talus {

class StepTimer {  // of a part of a step
 public:
  StepTimer(RunTotals& totals, const char* part) : totals_(totals), part_(part), start_(wall_seconds()) {}
  ~StepTimer() { totals_.add_of_step(part_, wall_seconds() - start_); }
  StepTimer(const StepTimer&) = delete;
  StepTimer& operator=(const StepTimer&) = delete;

 private:
  RunTotals& totals_;
  const char* part_;
  double start_;
};

class PartTimer {  // of what is no step
 public:
  PartTimer(RunTotals& totals, const char* part) : totals_(totals), part_(part), start_(cpu_seconds()) {}
  ~PartTimer() { totals_.seconds(part_) += cpu_seconds() - start_; }
  PartTimer(const PartTimer&) = delete;
  PartTimer& operator=(const PartTimer&) = delete;

 private:
  RunTotals& totals_;
  const char* part_;
  double start_;
};

}  // namespace talus
