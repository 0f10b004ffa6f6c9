#pragma once
#include <algorithm>
#include <span>

#include "model/model.h"

namespace talus {

// Of a block with these rates of its unknowns.
inline bool stands_still(std::span<const double> rates) {
  return std::ranges::all_of(rates, [](double rate) { return rate == 0; });
}

// Of a block that goes from one state to another in `dt` s.
inline Rates rates_of_way(const BlockShape& shape, const BlockState& from, const BlockState& to, double dt) {
  Rates rates = from.velocity;
  const Vec2 shift = (to.shift - from.shift) / dt;
  const Vec3 strain = (to.strain - from.strain) * shape.length / dt;
  const double turn = (to.angle - from.angle) * shape.length / dt;
  for (int k = 0; k < first_order_dofs; ++k) rates[k] = k < 2 ? shift[k] : k == 2 ? turn : strain[k - 3];
  for (size_t k = 0; from.bend && k < from.bend->size(); ++k)
    rates[first_order_dofs + k] = ((*to.bend)[k] - (*from.bend)[k]) / dt;
  return rates;
}

inline bool stands_still(const Model& model, int block) {
  return stands_still(model.blocks[size_t(block)].velocity);
}

}  // namespace talus
