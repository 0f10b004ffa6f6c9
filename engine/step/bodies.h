#pragma once
// Blocks that hang together by bonds, each taken as one rigid body.
#include <algorithm>
#include <vector>

#include "model/model.h"

namespace talus {

// Means of the mass of its blocks.
struct Body {
  double mass = 0, inertia = 0;                           // kg/m, kg m about the centroid
  Vec2 centroid = Vec2::Zero(), velocity = Vec2::Zero();  // m, m/s
  double spin = 0;                                        // rad/s
};

inline size_t body_count(const std::vector<int>& body_of) {
  return body_of.empty() ? 0 : size_t(*std::ranges::max_element(body_of)) + 1;
}
// `count` bodies as they are in `blocks`. Blocks with a body below 0 are in none; a body without blocks is nought.
std::vector<Body> bodies_of(const Model& model, const std::vector<BlockState>& blocks, const std::vector<int>& body_of,
                            size_t count);

}  // namespace talus
