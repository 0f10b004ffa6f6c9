#pragma once
// Edges and corners of blocks as what others come up against, and what they press back with, found once for all pairs
// of a search.
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
  Vec2 at(double position) const { return from + position * along; }
};

// A corner on the outline of its body.
struct OutlineCorner {
  Vec2 ahead, behind;  // along the sides that meet there, away from it; unit vectors
  double turn;         // sine of the angle by which the outline turns outwards
  double shorter;      // m, of the two sides
};

// Pa, of a block's strain: as they are given, blocks under an initial stress lie flush. Nothing of rigid ones.
struct Pressing {
  Vec3 stress = Vec3::Zero();  // global axes
  double largest = 0;          // across any line: what the circle of Mohr reaches
};

struct Surface;  // contact/detection.h

// Of the blocks that come near another, and of those in whose faces the outlines of their bodies go on.
class Faces {
 public:
  void find(const Model& model, const Surface& surface, const std::vector<std::pair<int, int>>& near);
  const Face& operator[](int edge) const { return faces_[size_t(edge)]; }             // global
  const OutlineCorner& corner(int vertex) const { return corners_[size_t(vertex)]; }  // global
  const Pressing& pressing(int block) const { return pressing_[size_t(block)]; }

 private:
  void find(const Model& model, const Surface& surface, int block);
  std::vector<Face> faces_;
  std::vector<OutlineCorner> corners_;
  std::vector<Pressing> pressing_;
  std::vector<char> found_;  // by block
};

}  // namespace talus
