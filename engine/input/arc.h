#pragma once
// Arcs of a drawing as chords. Internal to engine/input.
#include <vector>

#include "geometry/vec2.h"

namespace talus {

struct BulgedPoint {
  Vec2 at;
  double bulge = 0;  // tan(angle/4) of the arc to the next point, counter-clockwise positive; 0: straight
};

// `side` -1 mirrors x at the end; `chord` is the greatest sagitta, of the radius.
Polyline arc(const Vec2& centre, double radius, double from, double to, int side,
             double chord);  // rad, from < to or + 2π
Polyline with_arcs(const std::vector<BulgedPoint>& vertices, bool closed, int side, double chord);

}  // namespace talus
