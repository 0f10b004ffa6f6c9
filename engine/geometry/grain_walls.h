#pragma once
// Whether boundary or traces stand between two points. Internal to engine/geometry.
#include "geometry/network.h"
#include "geometry/segment_grid.h"

namespace talus {

class GrainWalls {
 public:
  // `reach`: how far apart the two points may be.
  GrainWalls(const Network& network, double reach) : reach_(reach), segments_(of(network)), grid_(segments_, reach) {}

  double reach() const { return reach_; }
  bool cross(const Vec2& a, const Vec2& b) const {
    for (int i : grid_.near(a)) {
      const auto& [p, q] = segments_[i];
      const bool divides = (cross_product(q - p, a - p) > 0) != (cross_product(q - p, b - p) > 0);
      if (divides && (cross_product(b - a, p - a) > 0) != (cross_product(b - a, q - a) > 0)) return true;
    }
    return false;
  }

 private:
  static double cross_product(const Vec2& a, const Vec2& b) { return talus::cross(a, b); }
  static std::vector<SegmentGrid::Segment> of(const Network& network) {
    std::vector<SegmentGrid::Segment> list;
    for (const Network::Edge& e : network.edges) list.push_back({network.points[e.p], network.points[e.q]});
    return list;
  }

  double reach_;
  std::vector<SegmentGrid::Segment> segments_;
  SegmentGrid grid_;
};

}  // namespace talus
