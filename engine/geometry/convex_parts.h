#pragma once
#include <vector>

#include "geometry/vec2.h"

namespace talus {

// corners of the polygon, counter-clockwise; sides that are not the polygon's lie within it
using ConvexPart = std::vector<int>;

// Of a simple, counter-clockwise polygon: no more than four times as many as the least that there can be (Hertel &
// Mehlhorn 1983).
std::vector<ConvexPart> convex_parts(const Polyline& polygon);

}  // namespace talus
