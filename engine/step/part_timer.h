#pragma once
// CPU time by part, added to the run's totals.
#include "step/clock.h"
#include "step/totals.h"

namespace talus {

template <auto clock, auto book>
class Timer {  // of a scope
 public:
  Timer(RunTotals& totals, const char* part) : totals_(totals), part_(part), start_(clock()) {}
  ~Timer() { book(totals_, part_, clock() - start_); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  RunTotals& totals_;
  const char* part_;
  double start_;
};

inline void book_of_step(RunTotals& totals, const char* part, double wall) {
  totals.add_of_step(part, wall);
}
inline void book_cpu(RunTotals& totals, const char* part, double cpu) {
  totals.seconds(part) += cpu;
}

using StepTimer = Timer<wall_seconds, book_of_step>;  // of a part of a step
using PartTimer = Timer<cpu_seconds, book_cpu>;       // of what is no step

}  // namespace talus
