#pragma once
// The three parts of build(), in order.
#include "geometry/tessellation.h"
#include "model/model.h"

namespace talus {

// A free edge of a region at the start, for loads and fixities: block, ends from its reference centroid.
struct FreeEdge {
  int region, block;
  Vec2 from, to;  // model coordinates, block on the left
};

void check_regions(Scene& scene);                                          // also turns outlines counter-clockwise
std::vector<FreeEdge> build_blocks(Model& model);                          // blocks, joints, nodes
void attach(Model& model, const std::vector<FreeEdge>& edges);             // fixities, loads, probes

}  // namespace talus
