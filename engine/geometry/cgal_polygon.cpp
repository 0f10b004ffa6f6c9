#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numeric>

#include "geometry/polygon.h"

namespace talus {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double least_relative_area = 1e-12;

// The exact sign of cross(b - a, c - a).
int turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return CGAL::orientation(Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()), Kernel::Point_2(c.x(), c.y()));
}

std::string text(const Vec2& p) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "(%.10g, %.10g)", p.x(), p.y());
  return buffer;
}

std::string numbers(std::size_t i, std::size_t j) {
  return std::to_string(std::min(i, j) + 1) + " and " + std::to_string(std::max(i, j) + 1);
}

// A polygon whose edge i runs from point i to the next.
class Outline {
 public:
  explicit Outline(const Polyline& points) : points_(points) {}

  std::size_t size() const { return points_.size(); }
  std::size_t next(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }
  const Vec2& from(std::size_t edge) const { return points_[edge]; }
  const Vec2& to(std::size_t edge) const { return points_[next(edge)]; }
  double left(std::size_t edge) const { return std::min(from(edge).x(), to(edge).x()); }
  double right(std::size_t edge) const { return std::max(from(edge).x(), to(edge).x()); }
  bool touches_box(std::size_t edge, const Vec2& p) const {
    return left(edge) <= p.x() && p.x() <= right(edge) && std::min(from(edge).y(), to(edge).y()) <= p.y() &&
           p.y() <= std::max(from(edge).y(), to(edge).y());
  }

 private:
  const Polyline& points_;
};

std::optional<std::string> bad_point(const Outline& o) {
  for (std::size_t i = 0; i < o.size(); ++i)
    if (!o.from(i).allFinite()) return "point " + std::to_string(i + 1) + " is " + text(o.from(i));
  constexpr double most = 1e50;  // m: the sixth power of twice that, as of the moments of blocks, is a number
  for (std::size_t i = 0; i < o.size(); ++i)
    if (!(o.from(i).cwiseAbs().maxCoeff() <= most))
      return "point " + std::to_string(i + 1) + ", " + text(o.from(i)) +
             ", is farther off than 1e50 m, beyond which moments of blocks are no numbers";
  for (std::size_t i = 0; i < o.size(); ++i)
    if (o.from(i) == o.to(i)) {
      const bool closed_twice = o.next(i) == 0;
      return "points " + numbers(i, o.next(i)) + " are the same, " + text(o.from(i)) +
             (closed_twice ? " (an outline closes itself: leave the last one out)" : "");
    }
  return std::nullopt;
}

bool on_one_line(const Polyline& polygon) {
  const Vec2& a = polygon.front();
  const Vec2 along = *std::max_element(polygon.begin(), polygon.end(), [&](const Vec2& p, const Vec2& q) {
    return (p - a).squaredNorm() < (q - a).squaredNorm();
  }) - a;
  return std::all_of(polygon.begin(), polygon.end(), [&](const Vec2& p) {
    return std::abs(cross(along, p - a)) <= least_relative_area * along.squaredNorm();
  });
}

std::optional<std::string> fold(const Outline& o) {
  for (std::size_t i = 0; i < o.size(); ++i) {
    const std::size_t j = o.next(i);
    if (turn(o.from(i), o.to(i), o.to(j)) == 0 && (o.to(i) - o.from(i)).dot(o.to(j) - o.from(j)) < 0)
      return "edges " + numbers(i, j) + " fold back on each other at point " + std::to_string(j + 1) + ", " +
             text(o.from(j));
  }
  return std::nullopt;
}

// What edges i and j, which are not neighbours, have in common.
std::optional<std::string> meeting(const Outline& o, std::size_t i, std::size_t j) {
  const Vec2 &a = o.from(i), &b = o.to(i), &c = o.from(j), &d = o.to(j);
  const int c_side = turn(a, b, c), d_side = turn(a, b, d);
  if (c_side * d_side > 0) return std::nullopt;
  const int a_side = turn(c, d, a), b_side = turn(c, d, b);
  if (a_side * b_side > 0) return std::nullopt;
  const auto touch = [&](const Vec2& p) { return "edges " + numbers(i, j) + " touch at " + text(p); };
  if (c_side == 0 && o.touches_box(i, c)) return touch(c);
  if (d_side == 0 && o.touches_box(i, d)) return touch(d);
  if (a_side == 0 && o.touches_box(j, a)) return touch(a);
  if (b_side == 0 && o.touches_box(j, b)) return touch(b);
  if (c_side == 0 || d_side == 0 || a_side == 0 || b_side == 0) return std::nullopt;
  const double t = cross(c - a, d - c) / cross(b - a, d - c);
  return "edges " + numbers(i, j) + " cross at " + text(a + t * (b - a));
}

// Sweep over x: each edge meets only those that begin before it ends.
std::optional<std::string> self_meeting(const Outline& o) {
  std::vector<std::size_t> order(o.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return o.left(i) != o.left(j) ? o.left(i) < o.left(j) : i < j; });
  for (std::size_t m = 0; m < order.size(); ++m)
    for (std::size_t k = m + 1; k < order.size() && o.left(order[k]) <= o.right(order[m]); ++k) {
      const std::size_t i = order[m], j = order[k];
      if (o.next(i) == j || o.next(j) == i) continue;
      if (auto found = meeting(o, i, j)) return found;
    }
  return std::nullopt;
}

}  // namespace

Polyline convex_hull(const Polyline& points) {
  std::vector<Kernel::Point_2> all, hull;
  for (const Vec2& p : points) all.emplace_back(p.x(), p.y());
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(hull));
  Polyline line;
  for (const Kernel::Point_2& p : hull) line.emplace_back(p.x(), p.y());
  return line;
}

std::optional<std::string> defect(const Polyline& polygon) {
  const Outline o(polygon);
  if (o.size() < 3) return "it has " + std::to_string(o.size()) + " points, and 3 are the least";
  if (auto found = bad_point(o)) return found;
  if (on_one_line(polygon)) return "its area is zero: all points lie on one line";
  if (auto found = fold(o)) return found;
  if (auto found = self_meeting(o)) return found;
  const double area = signed_area(polygon), extent = bounds(polygon).extent();
  if (std::abs(area) <= least_relative_area * extent * extent) return "its area is zero";
  if (area < 0) return "its points run clockwise";
  return std::nullopt;
}

}  // namespace talus
