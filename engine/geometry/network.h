#pragma once
// Outline, holes and traces as edges that meet only at common points: what `cut` and `mesh` both start from.
// Internal to engine/geometry.
#include <vector>

#include "geometry/tessellation.h"

namespace talus {

struct Network {
  // trace = -1: on the outline or a hole; else the lowest of the traces that run along it.
  struct Edge {
    int p, q, trace;
  };
  std::vector<Vec2> points;  // first those of the outline, then of the holes, in their order and to the bit
  int boundary_points = 0;   // how many of them
  // They meet at their ends only; no two have the same ends; of traces, only what lies in the region.
  std::vector<Edge> edges;
  double tolerance = 0;  // m
};

// Traces are bent, ended or merged where they pass within `tolerance` (m; at least 1e-9 of the outline's extent,
// at most a third of the boundary's clearance) of the boundary, of a point or of each other; the boundary stays
// as it is. So a trace that ends on the outline but for round-off does reach it, and three joints through one
// point do meet there. Another tolerance is tried where bent traces would go on meeting. Throws
// std::invalid_argument for a trace with a point that is not finite, or for traces too entangled.
Network make_network(const TessellationInput& input, double tolerance = 0);

// The least distance (m) between a point of the boundary and an edge that does not end there, or `most`.
double boundary_clearance(const TessellationInput& input, double most);

}  // namespace talus
