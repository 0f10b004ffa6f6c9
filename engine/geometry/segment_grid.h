#pragma once
// Square bins over line segments: which segments are near a point, which pairs may meet. Internal to
// engine/geometry.
#include <span>
#include <utility>
#include <vector>

#include "geometry/polygon.h"

namespace talus {

class SegmentGrid {
 public:
  struct Segment {
    Vec2 a, b;
  };
  // A segment is entered in every bin that it comes within `margin` of.
  SegmentGrid(const std::vector<Segment>& segments, double margin);

  // Indices of the segments within the margin of `point`, and others; ascending.
  std::span<const int> near(const Vec2& point) const;
  // Pairs (i, j), i < j, that come within the margin of each other, and others; ascending.
  std::vector<std::pair<int, int>> pairs() const;

 private:
  template <class Visit>
  void for_each_bin(const Segment& segment, double margin, const Visit& visit) const;
  int column(double x) const;
  int row(double y) const;

  Bounds box_;
  double bin_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<int> begin_, items_;  // compressed rows: bin k holds items_[begin_[k] .. begin_[k + 1])
};

}  // namespace talus
