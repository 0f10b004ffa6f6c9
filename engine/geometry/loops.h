#pragma once
// A tessellation whose cells can be changed one by one. Internal to engine/geometry.
#include <cstdint>
#include <vector>

#include "geometry/tessellation.h"

namespace talus {

inline constexpr int on_boundary = -2;  // "trace" of an edge with one cell

// A corner of a cell, and the edge that leaves it.
struct Corner {
  int point, trace;
};
using Loop = std::vector<Corner>;

inline std::uint64_t directed(int p, int q) {
  return static_cast<std::uint64_t>(p) << 32 | static_cast<std::uint32_t>(q);
}

// A tessellation as loops whose edges know their trace; a cell that is gone has an empty one.
class Loops {
 public:
  explicit Loops(const Tessellation& t);
  Tessellation tessellation() const;

  int size() const { return static_cast<int>(loops_.size()); }
  const Loop& operator[](int cell) const { return loops_[cell]; }
  Loop& operator[](int cell) { return loops_[cell]; }
  Polyline outline(const Loop& loop) const {
    Polyline points;
    for (const Corner& c : loop) points.push_back(points_[c.point]);
    return points;
  }
  std::vector<Vec2>& points() { return points_; }
  const std::vector<Vec2>& points() const { return points_; }

 private:
  std::vector<Vec2> points_;
  std::vector<Loop> loops_;
};

}  // namespace talus
