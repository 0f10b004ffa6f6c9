#include "model/curved_edge.h"

#include <cmath>

namespace talus {

// Newton's method on (p - x)·x' = 0, from the foot on the straight line. Edges that bend by less than their length need
// two or three steps; where a point is farther than the edge's radius, and has more than one foot, it stays at the last
// that had one.
double CurvedEdge::nearest(const Vec2& point) const {
  constexpr int most_steps = 8;
  constexpr double settled = 1e-15;  // of the edge
  double at = (point - from).dot(span) / span.squaredNorm();
  for (int k = 0; k < most_steps; ++k) {
    const Vec2 off = point - place(at), along = tangent(at);
    const double slope = along.squaredNorm() + (at > 0 && at < 1 ? 8 * off.dot(rise) : 0);
    if (slope <= 0) break;
    const double step = off.dot(along) / slope;
    at += step;
    if (std::abs(step) <= settled) break;
  }
  return at;
}

}  // namespace talus
