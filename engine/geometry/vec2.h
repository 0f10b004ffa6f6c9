#pragma once
#include <Eigen/Core>
#include <vector>

namespace talus {

using Vec2 = Eigen::Vector2d;
using Polyline = std::vector<Vec2>;

inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The vector turned by +90°: the velocity of a point at `a` under unit spin.
inline Vec2 perp(const Vec2& a) {
  return {-a.y(), a.x()};
}

}  // namespace talus
