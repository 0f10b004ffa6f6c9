#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "hand_model.h"
#include "tessellation_checks.h"

namespace talus {
namespace {

using test::cell_outline;
using test::expect_tessellation;
using test::rectangle;

constexpr int nx = 5, ny = 3;
constexpr std::size_t rectangles = nx * ny, between_rectangles = (nx - 1) * ny + nx * (ny - 1);

Tessellation make(Pattern kind) {
  return pattern(rectangle(1, 2, 10, 3), kind, nx, ny);
}

// How many cells meet at each point.
std::vector<int> cells_at(const Tessellation& t) {
  std::vector<int> count(t.points.size(), 0);
  for (const auto& cell : t.cells)
    for (int p : cell) ++count[p];
  return count;
}

std::map<int, int> valences_inside(const Tessellation& t) {
  const std::vector<int> count = cells_at(t);
  std::map<int, int> valences;
  for (std::size_t p = 0; p < count.size(); ++p)
    if (distance_to_boundary(rectangle(1, 2, 10, 3), t.points[p]) > 1e-9) ++valences[count[p]];
  return valences;
}

void expect_equal_areas(const Tessellation& t, double area) {
  for (std::size_t c = 0; c < t.cells.size(); ++c)
    EXPECT_NEAR(signed_area(cell_outline(t, c)), area, 1e-14 * area * nx);
}

TEST(Pattern, CrossHasFourTrianglesARectangle) {
  const Tessellation t = make(Pattern::cross);
  expect_tessellation(t, 30);
  EXPECT_EQ(t.cells.size(), 4 * rectangles);
  EXPECT_EQ(t.points.size(), rectangles + (nx + 1) * (ny + 1));
  EXPECT_EQ(t.interfaces.size(), 4 * rectangles + between_rectangles);
  expect_equal_areas(t, 30.0 / (4 * rectangles));
  EXPECT_EQ(valences_inside(t), (std::map<int, int>{{4, int(rectangles)}, {8, (nx - 1) * (ny - 1)}}));
  // The first rectangle's bottom, right, top and left.
  const Vec2 sides[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int k = 0; k < 4; ++k) {
    const Vec2 off = integrate(cell_outline(t, k)).centroid - Vec2(2, 2.5);
    EXPECT_GT(off.dot(sides[k]), 0.1) << k;
  }
}

TEST(Pattern, DiagonalsAllRise) {
  const Tessellation t = make(Pattern::diagonal);
  expect_tessellation(t, 30);
  EXPECT_EQ(t.cells.size(), 2 * rectangles);
  EXPECT_EQ(t.points.size(), std::size_t((nx + 1) * (ny + 1)));
  EXPECT_EQ(t.interfaces.size(), rectangles + between_rectangles);
  expect_equal_areas(t, 30.0 / (2 * rectangles));
  EXPECT_EQ(valences_inside(t), (std::map<int, int>{{6, (nx - 1) * (ny - 1)}}));
  for (const auto& i : t.interfaces) {
    const Vec2 along = t.points[i.q] - t.points[i.p];
    EXPECT_GE(along.x() * along.y(), 0);
  }
}

TEST(Pattern, AlternatingDiagonalsMeetAtEverySecondPoint) {
  const Tessellation t = make(Pattern::alternating);
  expect_tessellation(t, 30);
  EXPECT_EQ(t.cells.size(), 2 * rectangles);
  EXPECT_EQ(t.interfaces.size(), rectangles + between_rectangles);
  expect_equal_areas(t, 30.0 / (2 * rectangles));
  EXPECT_EQ(valences_inside(t), (std::map<int, int>{{4, 4}, {8, 4}}));
}

TEST(Pattern, AnyTurnAndFirstCorner) {
  Polyline outline = rectangle(0, 0, 10, 3);
  for (Vec2& p : outline) p = Vec2(4, 5) + Vec2(0.8 * p.x() - 0.6 * p.y(), 0.6 * p.x() + 0.8 * p.y());
  const Tessellation t = pattern(outline, Pattern::diagonal, nx, ny);
  expect_tessellation(t, 30);
  EXPECT_EQ(t.cells.size(), 2 * rectangles);
  for (int turn = 1; turn < 4; ++turn) {
    std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    EXPECT_TRUE(test::same(pattern(outline, Pattern::diagonal, nx, ny), t)) << turn;
  }
  std::reverse(outline.begin(), outline.end());
  EXPECT_TRUE(test::same(pattern(outline, Pattern::diagonal, nx, ny), t));
  // nx counts along the side nearest to x, though the other is longer
  const Tessellation tall = pattern(rectangle(0, 0, 1, 7), Pattern::diagonal, 2, 1);
  EXPECT_TRUE(std::any_of(tall.points.begin(), tall.points.end(), [](const Vec2& p) { return p.x() == 0.5; }));
}

// 0.1·k/7 is rounded; the points must be equal all the same, or the sides would not meet.
TEST(Pattern, NeighboursHaveTheSamePointsToTheBit) {
  const Tessellation left = pattern({{0.1, 0.1}, {0.7, 0.1}, {0.7, 0.8}, {0.1, 0.8}}, Pattern::cross, 3, 7);
  const Tessellation right = pattern({{1.1, 0.8}, {0.7, 0.8}, {0.7, 0.1}, {1.1, 0.1}}, Pattern::diagonal, 2, 7);
  int common = 0;
  for (const Vec2& p : left.points) {
    if (std::abs(p.x() - 0.7) > 1e-9) continue;
    ++common;
    EXPECT_EQ(std::count(right.points.begin(), right.points.end(), p), 1) << p.transpose();
  }
  EXPECT_EQ(common, 8);
}

// At 45° each of two sides may count as that along x: the common one is walked to and fro, and rounds alike.
TEST(Pattern, NeighboursTurnedBy45Degrees) {
  const Vec2 p(0.4, 0.5), q(-0.3, 1.2);
  const Tessellation below = pattern({{0.1, 0.2}, p, q, {-0.6, 0.9}}, Pattern::diagonal, 3, 7);
  const Tessellation above = pattern({q, p, {1, 1.1}, {0.3, 1.8}}, Pattern::cross, 7, 5);
  int common = 0;
  for (const Vec2& point : below.points) {
    if (distance_to_segment(p, q, point) > 1e-9) continue;
    ++common;
    EXPECT_EQ(std::count(above.points.begin(), above.points.end(), point), 1) << point.transpose();
  }
  EXPECT_EQ(common, 8);
}

TEST(Pattern, NeedsARectangleAndCounts) {
  EXPECT_THROW(pattern({{0, 0}, {1, 0}, {0, 1}}, Pattern::cross, 1, 1), std::invalid_argument);
  EXPECT_THROW(pattern({{0, 0}, {1, 0}, {1.1, 1}, {0.1, 1}}, Pattern::cross, 1, 1), std::invalid_argument);
  EXPECT_THROW(pattern({{0, 0}, {1, 0}, {1, 1}, {0, NAN}}, Pattern::cross, 1, 1), std::invalid_argument);
  EXPECT_THROW(pattern(rectangle(0, 0, 1, 1), Pattern::cross, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace talus
