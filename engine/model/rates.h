#pragma once
#include <algorithm>
#include <span>

#include "model/model.h"

namespace talus {

// Of a block with these rates of its unknowns.
inline bool stands_still(std::span<const double> rates) {
  return std::ranges::all_of(rates, [](double rate) { return rate == 0; });
}

inline bool stands_still(const Model& model, int block) { return stands_still(model.blocks[size_t(block)].velocity); }

}  // namespace talus
