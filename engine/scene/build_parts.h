#pragma once
// The three parts of build(), in order.
#include "geometry/tessellation.h"
#include "model/model.h"

namespace talus {

// A free edge of a region at the start, for loads and boundaries: block and the number of its edge.
struct FreeEdge {
  int region, block, edge;
  Vec2 from, to;  // model coordinates, block on the left
};

void check_contact_rules(const Scene& scene);                           // that no two are for one pair
void check_regions(Scene& scene);                                       // also turns outlines counter-clockwise
void doubt_units(const Scene& scene, std::vector<std::string>& notes);  // what looks like a forgotten unit
std::vector<FreeEdge> build_blocks(Model& model);                       // blocks, joints, nodes
// fixities, loads, viscous boundaries, probes
void attach(Model& model, const std::vector<FreeEdge>& edges);
void attach_charges(Model& model, const std::vector<FreeEdge>& edges);  // hole walls; after attach()

}  // namespace talus
