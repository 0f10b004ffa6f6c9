#pragma once
// CPU time of a part of the step, added to the run's totals.
#include <ctime>
#include <string>

#include "step/simulation.h"

namespace talus {

inline double cpu_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

class PartTimer {
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
