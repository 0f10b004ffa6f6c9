#pragma once
// Edges of blocks as what others come up against, found once for all pairs of a search.
#include <utility>
#include <vector>

#include "model/model.h"

namespace talus {

// An edge of a block.
struct Face {
  Vec2 from, along, normal;  // unit vectors; normal outward
  double length;
  double gap(const Vec2& p) const { return normal.dot(p - from); }
  double position(const Vec2& p) const { return along.dot(p - from); }
};

struct Surface;  // contact/detection.h

// Of the blocks that come near another, and of those in whose faces the outlines of their bodies go on, by global edge.
class Faces {
 public:
  void find(const Model& model, const Surface& surface, const std::vector<std::pair<int, int>>& near);
  const Face& operator[](int edge) const { return faces_[size_t(edge)]; }

 private:
  void find(const Model& model, int block);
  std::vector<Face> faces_;
  std::vector<char> found_;  // by block
};

}  // namespace talus
