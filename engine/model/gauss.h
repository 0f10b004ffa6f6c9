#pragma once
// Where integrals along an edge are taken. The displacement of a first-order block is linear along an edge and that of
// a second-order one quadratic, so that the square of a jump is of degree two or four: two and three points of Gauss
// are exact.
#include <span>

#include "model/model.h"

namespace talus {

struct GaussPoint {
  double at = 0, share = 0;  // 0–1 along the edge; part of its length
};

inline std::span<const GaussPoint> gauss_points(int count) {
  static constexpr double two = 0.28867513459481287, three = 0.3872983346207417;  // √3/6, √(3/5)/2
  static constexpr GaussPoint of_two[] = {{0.5 - two, 0.5}, {0.5 + two, 0.5}};
  static constexpr GaussPoint of_three[] = {{0.5 - three, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + three, 5.0 / 18}};
  return count == 2 ? std::span<const GaussPoint>(of_two) : std::span<const GaussPoint>(of_three);
}
inline std::span<const GaussPoint> gauss_points(const BlockShape& shape) {
  return gauss_points(shape.second_order() ? 3 : 2);
}

}  // namespace talus
