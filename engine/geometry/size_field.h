#pragma once
// The wanted edge length as the mesher sees it, and the frame it works in. Internal to engine/geometry.
#include <functional>
#include <vector>

#include "geometry/polygon.h"

namespace talus {

// The mesher works about the outline's corner in units of its extent, coordinates of given points rounded to
// `resolution`: the same scene 10 km off or 1000 times larger gives the same numbers, and so the same mesh.
class MeshFrame {
 public:
  static constexpr double resolution = 0x1p-36;
  explicit MeshFrame(const Polyline& outline) : origin_(bounds(outline).min), unit_(bounds(outline).extent()) {}
  Vec2 local_of_given(const Vec2& point) const;
  Vec2 world(const Vec2& local) const { return origin_ + unit_ * local; }
  double unit() const { return unit_; }  // m

 private:
  Vec2 origin_;
  double unit_;
};

class SizeField {
 public:
  SizeField(const MeshFrame& frame, const std::function<double(Vec2)>& size_at)
      : frame_(frame), size_at_(size_at) {}

  // Wanted edge length at a local point, local units. Throws std::invalid_argument where it is not positive.
  double at(const Vec2& local) const;
  // Edges of the wanted length on a–b: the integral of 1/size.
  double edges_along(const Vec2& a, const Vec2& b) const;
  // Where to cut a–b into the whole number of edges nearest to that: fractions of its length between 0 and 1.
  std::vector<double> divisions(const Vec2& a, const Vec2& b) const;
  // The integral of 1/size² over the triangle.
  double squares_in(const Vec2& a, const Vec2& b, const Vec2& c) const;

 private:
  double squares_in(const Vec2& a, const Vec2& b, const Vec2& c, double one_point, int depth) const;
  double one_point_rule(const Vec2& a, const Vec2& b, const Vec2& c) const;
  std::vector<double> cumulated_edges(const Vec2& a, const Vec2& b) const;

  const MeshFrame& frame_;
  const std::function<double(Vec2)>& size_at_;
};

}  // namespace talus
