#pragma once
// An edge of a second-order block as it bends: displacements that are quadratic in the block leave it a parabola,
// exactly.
#include <algorithm>

#include "geometry/vec2.h"

namespace talus {

// What is nearest to a point on an edge.
struct EdgeFoot {
  Vec2 foot, along, normal;  // along the edge there, and outward: unit vectors
  double gap;                // m, of the point, negative below the edge
};

inline EdgeFoot straight_foot(const Vec2& from, const Vec2& to, const Vec2& point) {
  const Vec2 along = (to - from).normalized(), normal = -perp(along);
  const double gap = normal.dot(point - from);
  return {point - gap * normal, along, normal, gap};
}

// Beyond its ends it goes straight on.
struct CurvedEdge {
  Vec2 from, span, rise;  // m; rise: of its middle, from that of the straight line between its ends

  static double within(double at) { return std::clamp(at, 0.0, 1.0); }
  Vec2 place(double at) const {
    const double in = within(at);
    return from + in * span + 4 * in * (1 - in) * rise + (at - in) * tangent(in);
  }
  Vec2 tangent(double at) const { return span + 4 * (1 - 2 * within(at)) * rise; }
  double nearest(const Vec2& point) const;  // 0 to 1 between the ends
  EdgeFoot foot(const Vec2& point) const {
    const double at = nearest(point);
    const Vec2 along = tangent(at).normalized(), normal = -perp(along), foot = place(at);
    return {foot, along, normal, normal.dot(point - foot)};
  }
};

}  // namespace talus
