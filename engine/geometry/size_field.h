#pragma once
// The wanted edge length as the mesher sees it, and the frame it works in. Internal to engine/geometry.
#include <functional>
#include <vector>

#include "geometry/polygon.h"

namespace talus {

// A frame that moves, turns and grows with the outline: x runs along its first edge. Meshers work in it, coordinates of
// given points rounded to `resolution`: the same scene 10 km off, turned or 1000 times larger gives the same numbers,
// and so the same mesh.
class MeshFrame {
 public:
  static constexpr double resolution = 0x1p-36;
  // From the corner of the box round the outline, in units of its extent.
  static MeshFrame about_box(const Polyline& outline);
  // From the outline's first point, in units of the square root of its area.
  static MeshFrame about_first_point(const Polyline& outline);
  Vec2 local(const Vec2& point) const;
  Vec2 local_of_given(const Vec2& point) const;
  Vec2 world(const Vec2& local) const { return origin_ + unit_ * (local.x() * axis_ + local.y() * perp(axis_)); }
  double unit() const { return unit_; }  // m

 private:
  MeshFrame(const Vec2& origin, double unit, const Vec2& axis) : origin_(origin), unit_(unit), axis_(axis) {}

  Vec2 origin_;
  double unit_;
  Vec2 axis_;
};

class SizeField {
 public:
  SizeField(const MeshFrame& frame, const std::function<double(Vec2)>& size_at) : frame_(frame), size_at_(size_at) {}

  // Wanted edge length at a local point, local units. Throws std::invalid_argument where it is not positive.
  double at(const Vec2& local) const;
  // Edges of the wanted length on a–b: the integral of 1/size.
  double edges_along(const Vec2& a, const Vec2& b) const;
  // The fraction of a–b by which the integral of 1/size has come to `edges`.
  double where(const Vec2& a, const Vec2& b, double edges) const;
  // Where to cut a–b into the whole number of edges nearest to that: fractions of its length between 0 and 1.
  std::vector<double> divisions(const Vec2& a, const Vec2& b) const;
  // The integral of 1/size² over the triangle.
  double squares_in(const Vec2& a, const Vec2& b, const Vec2& c) const;

 private:
  double squares_in(const Vec2& a, const Vec2& b, const Vec2& c, double one_point, int depth) const;
  double one_point_rule(const Vec2& a, const Vec2& b, const Vec2& c) const;
  static double fraction(const std::vector<double>& sum, double wanted, std::size_t& i);
  std::vector<double> cumulated_edges(const Vec2& a, const Vec2& b) const;

  const MeshFrame& frame_;
  const std::function<double(Vec2)>& size_at_;
};

}  // namespace talus
