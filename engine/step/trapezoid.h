#pragma once
// Whether a part of a static load step is as straight as its booking takes it for. Contacts that open or begin to slide
// bend the curve of loads over displacements, whose trapezoids are booked: a part that is off by too much of the work
// put in by it is to be taken in quarters. What is given off in the shortest is a jump.
#include "step/ledger.h"
#include "step/load_path.h"

namespace talus {

// part of a load step, or of a jump of loads, that is not cut for its bend alone
constexpr double finest_increment = 1.0 / 256;

enum class Trapezoid { holds, jumps, too_long };

struct Off {        // J/m
  double now = 0;   // given off in the part, for which nothing is booked
  double rest = 0;  // unexplained by the ledger as a whole after it
};

// Of a part with the ledgers before and after it.
Trapezoid trapezoid_of(LoadPath& path, const Off& off, const Ledger& before, const Ledger& after,
                       const TimeControl& time);

}  // namespace talus
