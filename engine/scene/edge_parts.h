#pragma once
// Corners between the ends of edges, where contacts follow edges that bend from corner to corner (model/curved_edge.h):
// what comes to rest between the ends is seen there, and forces at three places can do the work of any pressure that is
// linear along the edge.
#include "geometry/polygon.h"
#include "geometry/tessellation.h"

namespace talus {

// With a corner in the middle of each edge. Edges of slender blocks have more: bent by 1 rad, the most that second
// order describes, an edge of length L in n parts is off their chords by L/8n², which then is a twentieth of what the
// block is thick, area/L.
Polyline divided(const Polyline& outline);

struct DividedCell {
  Polyline outline;
  std::vector<int> corner;  // where the cell's own are in it, and at the end its size
};
// The cells of a tessellation, those that bend divided likewise (of others no edge, and `bends` may be empty); what
// lies beside one has the same corners on their common edges.
std::vector<DividedCell> divided(const Tessellation& t, const std::vector<char>& bends);

}  // namespace talus
