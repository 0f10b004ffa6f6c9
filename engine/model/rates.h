#pragma once
#include <algorithm>
#include <array>

#include "model/model.h"

namespace talus {

// Of a block with these rates of its unknowns.
inline bool stands_still(const std::array<double, max_dofs>& rates) {
  return std::ranges::all_of(rates, [](double rate) { return rate == 0; });
}

}  // namespace talus
