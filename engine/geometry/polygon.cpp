#include "geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace talus {
namespace {

// Round-off of a point computed on a slanted edge, far from the origin too.
double on_boundary_tolerance(const Bounds& box) {
  const double largest = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
  return 1e-12 * box.extent() + 4 * std::numeric_limits<double>::epsilon() * largest;
}

// Integrals about a fixed point, by the simplices (origin, p, q) over every edge p→q (Shi 1988).
struct Moments {
  double area = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
};

Moments moments_about(const Vec2& origin, const Polyline& polygon) {
  Moments m;
  Vec2 p = polygon.back() - origin;
  for (const Vec2& point : polygon) {
    const Vec2 q = point - origin;
    const double w = cross(p, q);
    m.area += w / 2;
    m.x += w * (p.x() + q.x()) / 6;
    m.y += w * (p.y() + q.y()) / 6;
    m.xx += w * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x()) / 12;
    m.yy += w * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y()) / 12;
    m.xy += w * (2 * p.x() * p.y() + p.x() * q.y() + q.x() * p.y() + 2 * q.x() * q.y()) / 24;
    p = q;
  }
  return m;
}

// What two triangles share: at most 6 points, a few more where round-off makes it not quite convex.
struct SmallConvex {
  std::array<Vec2, 12> point;
  int size = 0;
  void push(const Vec2& p) { point[size++] = p; }
};

// Sutherland–Hodgman: the part of `subject` to the left of a→b.
SmallConvex clip_left(const SmallConvex& subject, const Vec2& a, const Vec2& b) {
  SmallConvex kept;
  const Vec2 along = b - a;
  for (int i = 0; i < subject.size; ++i) {
    const Vec2 &p = subject.point[i], &q = subject.point[(i + 1) % subject.size];
    const double side_p = cross(along, p - a), side_q = cross(along, q - a);
    if (side_p >= 0) kept.push(p);
    if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0)) kept.push(p + (q - p) * (side_p / (side_p - side_q)));
  }
  return kept;
}

// Area shared by the triangles (0, a, b) and (0, c, d), signed by the product of their orientations.
double shared_by_fans(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double turn_ab = cross(a, b), turn_cd = cross(c, d);
  if (turn_ab == 0 || turn_cd == 0) return 0;
  if (turn_ab < 0) std::swap(a, b);
  if (turn_cd < 0) std::swap(c, d);
  SmallConvex shared;
  shared.push(Vec2::Zero());
  shared.push(a);
  shared.push(b);
  shared = clip_left(shared, Vec2::Zero(), c);
  shared = clip_left(shared, c, d);
  shared = clip_left(shared, d, Vec2::Zero());
  double area = 0;
  for (int i = 1; i + 1 < shared.size; ++i)
    area += cross(shared.point[i] - shared.point[0], shared.point[i + 1] - shared.point[0]) / 2;
  return (turn_ab < 0) == (turn_cd < 0) ? area : -area;
}

}  // namespace

// A homogeneous polynomial of degree n over the simplex (origin, p, q) is cross(p, q)/(n + 2) times its mean along p→q;
// Gauss's three points give that mean exactly up to degree 5.
HighMoments integrate_high(const Polyline& polygon, const Vec2& origin) {
  constexpr double reach = 0.3872983346207417;  // √(3/5)/2
  HighMoments m;
  Vec2 p = polygon.back() - origin;
  for (const Vec2& point : polygon) {
    const Vec2 q = point - origin;
    const double w = cross(p, q) / 18;
    for (const auto& [at, share] :
         {std::pair(0.5 - reach, 5 * w), std::pair(0.5, 8 * w), std::pair(0.5 + reach, 5 * w)}) {
      const double x = (1 - at) * p.x() + at * q.x(), y = (1 - at) * p.y() + at * q.y();
      const double xx = x * x, xy = x * y, yy = y * y, third = share / 5, fourth = share / 6;
      m.third[0] += third * xx * x;
      m.third[1] += third * xx * y;
      m.third[2] += third * x * yy;
      m.third[3] += third * yy * y;
      m.fourth[0] += fourth * xx * xx;
      m.fourth[1] += fourth * xx * xy;
      m.fourth[2] += fourth * xx * yy;
      m.fourth[3] += fourth * xy * yy;
      m.fourth[4] += fourth * yy * yy;
    }
    p = q;
  }
  return m;
}

PolygonIntegrals integrate(const Polyline& polygon) {
  PolygonIntegrals result;
  if (polygon.empty()) return result;
  const Vec2 near = bounds(polygon).centre();
  const Moments first = moments_about(near, polygon);
  result.area = first.area;
  result.centroid = near;
  if (first.area == 0) return result;
  result.centroid += Vec2(first.x, first.y) / first.area;
  // A second pass about the centroid: taking area·distance² off the first would cancel digits.
  const Moments second = moments_about(result.centroid, polygon);
  result.xx = second.xx;
  result.yy = second.yy;
  result.xy = second.xy;
  return result;
}

double signed_area(const Polyline& polygon) {
  return polygon.empty() ? 0 : moments_about(polygon.front(), polygon).area;
}

double thickness(const Polyline& polygon) {
  double perimeter = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    perimeter += (polygon[i] - polygon[j]).norm();
  return 2 * signed_area(polygon) / perimeter;
}

Bounds bounds(const Polyline& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Bounds box{Vec2::Constant(infinity), Vec2::Constant(-infinity)};
  for (const Vec2& p : points) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  return box;
}

// Liang & Barsky 1984.
std::optional<std::pair<double, double>> clip_to_box(const Vec2& a, const Vec2& direction, double first, double last,
                                                     const Bounds& box) {
  for (int k = 0; k < 2; ++k) {
    if (direction[k] == 0) {
      if (a[k] < box.min[k] || a[k] > box.max[k]) return std::nullopt;
      continue;
    }
    const double t0 = (box.min[k] - a[k]) / direction[k], t1 = (box.max[k] - a[k]) / direction[k];
    first = std::max(first, std::min(t0, t1));
    last = std::min(last, std::max(t0, t1));
  }
  if (!(first < last)) return std::nullopt;
  return std::pair(first, last);
}

double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& point) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0;
  return (point - a - t * along).norm();
}

double distance_to_boundary(const Polyline& polygon, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    least = std::min(least, distance_to_segment(polygon[j], polygon[i], point));
  return least;
}

bool contains(const Polyline& polygon, const Vec2& point) {
  if (polygon.size() < 3) return false;
  const Bounds box = bounds(polygon);
  const double tolerance = on_boundary_tolerance(box);
  if ((point.array() < box.min.array() - tolerance).any() || (point.array() > box.max.array() + tolerance).any())
    return false;
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[j], &b = polygon[i];
    if (distance_to_segment(a, b, point) <= tolerance) return true;
    const bool upward = b.y() > a.y();
    const bool crosses_height = (a.y() > point.y()) != (b.y() > point.y());
    if (crosses_height && (cross(b - a, point - a) > 0) == upward) inside = !inside;
  }
  return inside;
}

double overlap_area(const Polyline& a, const Polyline& b) {
  if (a.size() < 3 || b.size() < 3) return 0;
  const double smaller = std::min(std::abs(signed_area(a)), std::abs(signed_area(b)));
  const Bounds box_a = bounds(a), box_b = bounds(b);
  const Bounds common{box_a.min.cwiseMax(box_b.min), box_a.max.cwiseMin(box_b.max)};
  const Vec2 sides = common.max - common.min;
  const double negligible = 1e-9 * smaller;
  if (sides.x() <= 0 || sides.y() <= 0 || sides.prod() <= negligible) return 0;

  // Both polygons as signed fans of triangles about a point of the common part, where round-off is least.
  const Vec2 origin = common.centre();
  double shared = 0;
  for (std::size_t i = 0, j = a.size() - 1; i < a.size(); j = i++)
    for (std::size_t k = 0, l = b.size() - 1; k < b.size(); l = k++)
      shared += shared_by_fans(a[j] - origin, a[i] - origin, b[l] - origin, b[k] - origin);
  shared = std::abs(shared);  // a clockwise polygon turns the sign, not the area
  return shared > negligible ? shared : 0;
}

}  // namespace talus
