#pragma once
// What failed bonds make together: cracks, which are joints that hang together by their ends, and fragments, which are
// blocks that hang together by intact bonds.
#include <vector>

#include "model/fragments.h"

namespace talus {

// The crack that passes through each node, or -1: numbered by their first joints. Real joints are cracks from the
// start.
std::vector<int> cracks_at_nodes(const Model& model);

const char* failure_word(FailureMode mode);  // "none", "tension", "shear"
const char* crack_word(CrackKind kind);      // "none", "initiated", "propagated", "coalesced"

// What a bond that fails now is to the cracks there are.
CrackKind crack_kind(const std::vector<int>& crack_at_node, const Joint& joint);

struct Fragment {
  int blocks = 0, first = 0;  // how many; the first of them
  bool held = false;          // a held block, or one at a support or a viscous edge, is among them
  double area = 0, mass = 0;  // m2, kg/m
  double angle = 0;           // rad since the start, mean of its mass
  // m, m since the start, m/s, of its mass
  Vec2 centroid = Vec2::Zero(), shift = Vec2::Zero(), velocity = Vec2::Zero();
  double size() const;  // m, diameter of the disc of its area
};
std::vector<Fragment> fragments(const Model& model);

struct CrackLengths {
  double tension = 0, shear = 0;  // m, of bonds that failed
  int joints = 0;
};
CrackLengths crack_lengths(const Model& model);

}  // namespace talus
