#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "geometry/convex_parts.h"
#include "geometry/polygon.h"
#include "hand_model.h"

namespace talus {
namespace {

using test::rectangle;

// The square [0, 2]² without its upper right quarter.
const Polyline l_shape = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

Polyline shifted(Polyline points, const Vec2& by, double angle = 0, double scale = 1) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec2& p : points) p = by + scale * Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  return points;
}

Polyline reversed(Polyline points) {
  std::reverse(points.begin(), points.end());
  return points;
}

// A star with `arms` points at radius 1, notches at radius 0.3.
Polyline star(int arms) {
  Polyline points;
  for (int k = 0; k < 2 * arms; ++k) {
    const double angle = std::numbers::pi * k / arms;
    points.push_back((k % 2 ? 0.3 : 1.0) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void expect_integrals(const Polyline& polygon, double area, const Vec2& centroid, double xx, double yy, double xy,
                      double tolerance = 1e-14) {
  const PolygonIntegrals i = integrate(polygon);
  const double extent = bounds(polygon).extent(), moment = tolerance * area * extent * extent;
  EXPECT_NEAR(i.area, area, tolerance * area);
  EXPECT_NEAR((i.centroid - centroid).norm(), 0, tolerance * std::max(extent, centroid.norm()));
  EXPECT_NEAR(i.xx, xx, moment);
  EXPECT_NEAR(i.yy, yy, moment);
  EXPECT_NEAR(i.xy, xy, moment);
}

TEST(PolygonIntegrals, OfExactShapes) {
  expect_integrals(rectangle(1, -2, 3, 5), 15, {2.5, 0.5}, 27.0 * 5 / 12, 3.0 * 125 / 12, 0);
  const double b = 3, h = 2;
  expect_integrals({{0, 0}, {b, 0}, {0, h}}, b * h / 2, {b / 3, h / 3}, b * b * b * h / 36, b * h * h * h / 36,
                   -b * b * h * h / 72);
  // By the square of area 4 less that of area 1, with Steiner's shares.
  expect_integrals(l_shape, 3, {5.0 / 6, 5.0 / 6}, 11.0 / 12, 11.0 / 12, -1.0 / 3);
}

TEST(PolygonIntegrals, OfARegularPolygonHaveNoDirection) {
  for (int n : {3, 5, 8, 301}) {
    Polyline points;
    for (int k = 0; k < n; ++k)
      points.push_back(
          Vec2(std::cos(0.3 + 2 * std::numbers::pi * k / n), std::sin(0.3 + 2 * std::numbers::pi * k / n)));
    const double area = n / 2.0 * std::sin(2 * std::numbers::pi / n), side = 2 * std::sin(std::numbers::pi / n);
    expect_integrals(points, area, {0, 0}, area / 24 * (6 - side * side), area / 24 * (6 - side * side), 0);
  }
}

TEST(PolygonIntegrals, MomentsTurnAsATensor) {
  const double angle = 0.7, c = std::cos(angle), s = std::sin(angle), xx = 27.0 * 5 / 12, yy = 3.0 * 125 / 12;
  expect_integrals(shifted(rectangle(0, 0, 3, 5), {0, 0}, angle), 15, {1.5 * c - 2.5 * s, 1.5 * s + 2.5 * c},
                   c * c * xx + s * s * yy, s * s * xx + c * c * yy, c * s * (xx - yy));
}

// Corners on integers: a shift by 2^30 is exact, and only the centroid is rounded, by 2^-23 of a unit; it enters
// the moments by its square.
TEST(PolygonIntegrals, DoNotDependOnTheOrigin) {
  const double far = 0x1p30;
  const PolygonIntegrals i = integrate(shifted(l_shape, {far, -far}));
  EXPECT_EQ(i.area, 3);
  EXPECT_NEAR(i.centroid.x() - far, 5.0 / 6, 0x1p-22);
  EXPECT_NEAR(i.centroid.y() + far, 5.0 / 6, 0x1p-22);
  EXPECT_NEAR(i.xx, 11.0 / 12, 1e-13);
  EXPECT_NEAR(i.yy, 11.0 / 12, 1e-13);
  EXPECT_NEAR(i.xy, -1.0 / 3, 1e-13);
}

TEST(PolygonIntegrals, AreaIsNegativeClockwise) {
  EXPECT_DOUBLE_EQ(signed_area(l_shape), 3);
  EXPECT_DOUBLE_EQ(signed_area(reversed(l_shape)), -3);
  EXPECT_DOUBLE_EQ(integrate(reversed(l_shape)).area, -3);
  EXPECT_NEAR((integrate(reversed(l_shape)).centroid - Vec2(5.0 / 6, 5.0 / 6)).norm(), 0, 1e-15);
  EXPECT_EQ(signed_area({}), 0);
}

std::string reason(const Polyline& polygon) {
  return defect(polygon).value_or("none");
}
void expect_reason(const Polyline& polygon, const std::string& part) {
  EXPECT_NE(reason(polygon).find(part), std::string::npos) << reason(polygon);
}

TEST(PolygonDefect, NoneAtAnySizeAndPlace) {
  for (double scale : {1e-9, 1.0, 1e9})
    for (const Polyline& polygon : {l_shape, star(7), Polyline{{0, 0}, {1, 0}, {0.5, 1e-11}}})
      EXPECT_EQ(reason(shifted(polygon, {1e3 * scale, -2e3 * scale}, 0.3, scale)), "none") << scale;
}

TEST(PolygonDefect, IsNamed) {
  expect_reason({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "edges 1 and 3 cross at (0.5, 0.5)");
  expect_reason(reversed(l_shape), "clockwise");
  expect_reason({{0, 0}, {1, 0}}, "2 points");
  expect_reason({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, "points 2 and 3 are the same");
  expect_reason({{0, 0}, {1, 0}, {0, 1}, {0, 0}}, "closes itself");
  expect_reason({{0, 0}, {2, 0}, {1, 0}, {0, 1}}, "edges 1 and 2 fold back");
  expect_reason({{0, 0}, {1, 1}, {3, 3}}, "area is zero");
  expect_reason({{0, 0}, {1, 0}, {0.5, 1e-13}}, "area is zero");
  expect_reason({{0, 0}, {1, NAN}, {0, 1}}, "point 2 is (1, nan)");
  expect_reason({{0, 0}, {1, INFINITY}, {0, 1}}, "point 2 is");
}

// Exact predicates: the least height above the edge that a double can hold is not on it.
TEST(PolygonDefect, TouchingIsExact) {
  expect_reason({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}, "touch at (2, 0)");
  expect_reason({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 3}, {4, 2}, {0, 1}}, "touch at (4, 2)");
  EXPECT_EQ(reason({{0, 0}, {4, 0}, {4, 2}, {2, 5e-324}, {0, 2}}), "none");
  expect_reason({{0, 0}, {4, 0}, {4, 2}, {2, -1e-300}, {0, 2}}, "cross");
}

// By the sum of the angles under which a point sees the edges: another way than that of the engine.
bool inside_by_angles(const Polyline& polygon, const Vec2& p) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 a = polygon[k] - p, b = polygon[(k + 1) % polygon.size()] - p;
    sum += std::atan2(cross(a, b), a.dot(b));
  }
  return std::abs(sum) > std::numbers::pi;
}

TEST(PolygonContains, RandomPointsOfAStar) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.1, 1.1);
  const Polyline polygon = star(7);
  int inside = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec2 p(coordinate(random), coordinate(random));
    ASSERT_EQ(contains(polygon, p), inside_by_angles(polygon, p)) << p.transpose();
    inside += contains(polygon, p);
  }
  EXPECT_GT(inside, 100);
}

TEST(PolygonContains, BoundaryCornersAndNotch) {
  for (const Vec2& shift : {Vec2(0, 0), Vec2(1e6, -3e6)}) {
    const Polyline polygon = shifted(star(7), shift, 0.1);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      EXPECT_TRUE(contains(polygon, a));
      EXPECT_TRUE(contains(polygon, a + 0.37 * (b - a)));  // rounded, on a slanted edge
      EXPECT_FALSE(contains(polygon, a + 0.37 * (b - a) - 1e-6 * perp(b - a)));
    }
  }
  EXPECT_FALSE(contains(l_shape, {1.5, 1.5}));
  EXPECT_FALSE(contains(l_shape, {-0.5, 1}));  // level with an edge and with corners
  EXPECT_TRUE(contains(l_shape, {0.5, 1}));
}

TEST(PolygonDistance, ToTheNearestEdgeOrCorner) {
  EXPECT_DOUBLE_EQ(distance_to_boundary(l_shape, {0.25, 1}), 0.25);
  EXPECT_DOUBLE_EQ(distance_to_boundary(l_shape, {0.4, 0.4}), 0.4);
  EXPECT_DOUBLE_EQ(distance_to_boundary(l_shape, {5, -4}), 5);
  EXPECT_DOUBLE_EQ(distance_to_segment({1, 1}, {1, 1}, {4, 5}), 5);
}

TEST(PolygonOverlap, OfConvexAndOtherPolygons) {
  const Polyline square = rectangle(0.5, 0.5, 1, 1);
  for (const Vec2& far : {Vec2(0, 0), Vec2(0x1p20, 0x1p20)}) {
    EXPECT_NEAR(overlap_area(shifted(l_shape, far), shifted(square, far)), 0.75, 1e-12);
    EXPECT_NEAR(overlap_area(shifted(reversed(l_shape), far), shifted(square, far)), 0.75, 1e-12);
  }
  EXPECT_NEAR(overlap_area(l_shape, rectangle(-1, -1, 9, 9)), 3, 1e-12);
  EXPECT_EQ(overlap_area(l_shape, rectangle(1, 1, 1, 1)), 0);  // fills the notch: common edges only
  EXPECT_EQ(overlap_area(l_shape, rectangle(4, 0, 1, 1)), 0);
  EXPECT_NEAR(overlap_area(star(5), shifted(star(5), {0, 0}, 2 * std::numbers::pi / 5)), signed_area(star(5)), 1e-12);
}

TEST(ClipToBox, IsTheRangeInside) {
  const Bounds box{{0, 0}, {2, 1}};
  const auto part = clip_to_box({-1, -1}, {1, 1}, 0, 9, box);
  ASSERT_TRUE(part);
  EXPECT_EQ(*part, std::pair(1.0, 2.0));
  EXPECT_FALSE(clip_to_box({0, 1}, {1, 1}, -9, 9, box).has_value());  // touches a corner
  EXPECT_FALSE(clip_to_box({0, 2}, {1, 0}, -9, 9, box).has_value());
}

TEST(ConvexParts, AreConvexAndAllThereIs) {
  for (const Polyline& whole :
       {l_shape, shifted(l_shape, {3, 4}, 0.3, 1e-3), star(5), star(11), Polyline{{0, 0}, {1, 0}, {2, 0}, {2, 1}}}) {
    double area = 0;
    for (const ConvexPart& part : convex_parts(whole)) {
      Polyline corners;
      for (const int k : part) corners.push_back(whole[size_t(k)]);
      EXPECT_NEAR(signed_area(convex_hull(corners)), signed_area(corners), 1e-12 * signed_area(whole));
      area += signed_area(corners);
    }
    EXPECT_NEAR(area, signed_area(whole), 1e-12 * area);
  }
}

}  // namespace
}  // namespace talus
