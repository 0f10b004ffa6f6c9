#pragma once
// The words of the progress line, apart from when and where it is written.
#include <string>

#include "step/simulation.h"

namespace talus {

// "t 0.123 s (12 %)  step 456  dt 1.0e-03 s  it 3  contacts 120  ETA 12 s"; `left`: wall seconds still to go, 0: nobody
// knows.
std::string progress_line(const StepReport& step, double t_end, double left);
// "done: 1 step, 1340 blocks, 0.08 s CPU; results in out"; `folder`: empty where nothing was written. "stopped at t =
// 0.5 s: …" where it was (s; else NaN).
std::string done_line(double stopped_at, long steps, long blocks, double cpu, const std::string& folder);
// "45 s", "12 min", "3.5 h"
std::string duration(double seconds);

}  // namespace talus
