#pragma once
// What is too small for a block after a cut: slivers are merged into a neighbour, short edges are closed.
// Internal to engine/geometry and engine/scene.
#include <functional>

#include "geometry/tessellation.h"

namespace talus {

struct SliverCount {
  long cells = 0;
  Vec2 where = Vec2::Zero();  // centroid of the thinnest, against what is asked for there
  double thickness = 0;       // m, its
};

using LengthAt = std::function<double(const Vec2&)>;  // m, at a point

// Cells of less thickness (2·area/perimeter) than `least` at their centroid.
SliverCount count_slivers(const Tessellation& t, const LengthAt& least);

// Merges slivers, the thinnest first, each into the neighbour with the longest shared edge: across edges without a
// trace where there are any, else across traces if `across_traces`. Returns how many. What has no such neighbour,
// or would enclose a hole with it, stays.
long merge_slivers(Tessellation& t, const LengthAt& least, bool across_traces);

// Closes edges shorter than `least` at their middle, the shortest first, by moving one end onto the other: a point
// that lies on no trace rather than one on a trace, and that rather than one on the boundary, which moves along a
// straight side only. `kept` are points that do not move. Returns how many. An edge stays where a cell would not
// be simple any more, or lose its last three corners.
long close_short_edges(Tessellation& t, const LengthAt& least, const std::vector<Polyline>& kept);

}  // namespace talus
