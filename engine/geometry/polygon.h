#pragma once
// Simple polygons: exact simplex integrals (Shi 1988), checks, queries. No tolerance here depends on an
// absolute length: each is relative to the polygon's own extent.
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "geometry/vec2.h"

namespace talus {

// Integrals over a polygon about its centroid: area (m2), centroid (m), second moments
// xx = ∫(x-cx)² dA, yy, xy (m4).
struct PolygonIntegrals {
  double area = 0;
  Vec2 centroid = Vec2::Zero();
  double xx = 0, yy = 0, xy = 0;
};
PolygonIntegrals integrate(const Polyline& polygon);  // signed area: negative when clockwise

// Third and fourth moments about `origin`: ∫x³, x²y, xy², y³ dA (m5), ∫x⁴, x³y, x²y², xy³, y⁴ dA (m6).
struct HighMoments {
  std::array<double, 4> third{};
  std::array<double, 5> fourth{};
};
HighMoments integrate_high(const Polyline& polygon, const Vec2& origin);

double signed_area(const Polyline& polygon);

// 2·area/perimeter (m): the radius of the inscribed circle where one touches all sides, as in a triangle; the width of
// a long strip. What tells a sliver.
double thickness(const Polyline& polygon);

// Axis-parallel box around points. `extent` is its longer side, the length that tolerances refer to.
struct Bounds {
  Vec2 min, max;
  double extent() const { return (max - min).maxCoeff(); }
  Vec2 centre() const { return min + (max - min) / 2; }
};
Bounds bounds(const Polyline& points);

Polyline convex_hull(const Polyline& points);  // counter-clockwise

// The part of the line a + t·direction with first ≤ t ≤ last inside the box, as its range of t, or nothing
// where it misses the box or only touches a corner.
std::optional<std::pair<double, double>> clip_to_box(const Vec2& a, const Vec2& direction, double first, double last,
                                                     const Bounds& box);

bool contains(const Polyline& polygon, const Vec2& point);  // boundary counts as inside
double distance_to_boundary(const Polyline& polygon, const Vec2& point);
double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& point);

// Why `polygon` is not a simple polygon with positive area, in words for the user ("edges 2 and 5 cross at
// (1.5, 2)"), or nothing. Repeated points, zero area (less than 1e-12 of the square of its extent), edges that
// fold back, self-crossing, self-touching, clockwise turn, NaN and infinity are found, by exact predicates.
// Points count from 1; edge k runs from point k to the next.
std::optional<std::string> defect(const Polyline& polygon);

// The area two simple polygons share (m2), or 0 where it is less than 1e-9 of the smaller one's: touching
// along edges is not overlapping.
double overlap_area(const Polyline& a, const Polyline& b);

}  // namespace talus
