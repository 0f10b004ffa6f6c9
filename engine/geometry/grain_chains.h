#pragma once
// Boundary and traces as smooth chains between their corners, ends and crossings. Internal to engine/geometry.
#include <vector>

#include "geometry/network.h"
#include "geometry/size_field.h"

namespace talus {

struct GrainChain {
  std::vector<int> points;  // of the network, in order; a closed chain ends with its first point
  bool boundary = false;
  bool cornerless = false;  // a closed curve that is smooth all round
};

// Edges of a network joined where two of them meet at less than 31°: finer turns, as those of a circle drawn with
// many sides, are no corners to a grain.
std::vector<GrainChain> grain_chains(const Network& network);

// The middle of one of the intervals that a chain is divided into, each of about the wanted size.
struct ChainStation {
  Vec2 at, along;  // along: unit vector
  double length;   // of the interval
};
std::vector<ChainStation> stations(const GrainChain& chain, const std::vector<Vec2>& points, const SizeField& size);

}  // namespace talus
