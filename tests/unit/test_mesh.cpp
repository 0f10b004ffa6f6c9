#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <unordered_set>

#include "hand_model.h"
#include "tessellation_checks.h"

namespace talus {
namespace {

using test::cell_outline;
using test::expect_tessellation;
using test::plenty;
using test::polygon_of_circle;
using test::rectangle;
using test::uniform;

double least_angle(const Tessellation& t) {
  double least = std::numbers::pi;
  for (const auto& cell : t.cells)
    for (int k = 0; k < 3; ++k) {
      const Vec2 p = t.points[cell[k]], a = t.points[cell[(k + 1) % 3]] - p, b = t.points[cell[(k + 2) % 3]] - p;
      least = std::min(least, std::atan2(cross(a, b), a.dot(b)));
    }
  return least * 180 / std::numbers::pi;
}

struct EdgeRatios {  // edge length / wanted size at the edge's middle
  double least = 1e9, most = 0, mean = 0;
};
EdgeRatios edge_ratios(const Tessellation& t, const std::function<double(Vec2)>& size_at) {
  EdgeRatios r;
  std::size_t count = 0;
  const auto look = [&](int p, int q) {
    const double ratio = test::edge_length(t, p, q) / size_at((t.points[p] + t.points[q]) / 2);
    r.least = std::min(r.least, ratio);
    r.most = std::max(r.most, ratio);
    r.mean += ratio;
    ++count;
  };
  for (const auto& i : t.interfaces) look(i.p, i.q);
  for (const auto& e : boundary_edges(t)) look(e.p, e.q);
  r.mean /= double(count);
  return r;
}

// The factors that geometry/tessellation.h states.
void expect_quality(const Tessellation& t, const std::function<double(Vec2)>& size_at, double squares) {
  for (const auto& cell : t.cells) ASSERT_EQ(cell.size(), 3u);
  const EdgeRatios r = edge_ratios(t, size_at);
  EXPECT_GT(r.least, 0.5);
  EXPECT_LT(r.most, 1.45);
  EXPECT_NEAR(r.mean, 1.015, 0.035);
  EXPECT_GT(least_angle(t), 20.7);
  const double per_square = double(t.cells.size()) / squares;
  EXPECT_GT(per_square, 2.2);
  EXPECT_LT(per_square, 2.5);
}

TEST(Mesh, OfARectangle) {
  const Tessellation t = mesh({rectangle(0, 0, 8, 2), {}, {}}, uniform(0.1), plenty);
  expect_tessellation(t, 16);
  expect_quality(t, uniform(0.1), 1600);
}

TEST(Mesh, StraightSidesAreDividedEvenly) {
  const Tessellation t = mesh({rectangle(0, 0, 2, 1), {}, {}}, uniform(0.145), plenty);
  for (const BoundaryEdge& e : boundary_edges(t)) {
    const bool level = t.points[e.p].y() == t.points[e.q].y();
    EXPECT_NEAR(test::edge_length(t, e.p, e.q), level ? 2.0 / 14 : 1.0 / 7, 1e-9);
  }
}

TEST(Mesh, HolesAreLeftOut) {
  const Polyline outline = rectangle(-2, -2, 4, 4), hole = polygon_of_circle({0.3, 0.1}, 0.8, 40);
  const Tessellation t = mesh({outline, {hole}, {}}, uniform(0.12), plenty);
  const double area = 16 - signed_area(hole);
  expect_tessellation(t, area);
  expect_quality(t, uniform(0.12), area / (0.12 * 0.12));
  for (const Vec2& p : hole) EXPECT_EQ(std::count(t.points.begin(), t.points.end(), p), 1);
  for (std::size_t c = 0; c < t.cells.size(); ++c) EXPECT_FALSE(contains(hole, integrate(cell_outline(t, c)).centroid));
}

// From 0.05 at the hole to 0.5 far away, by 0.15 a metre: each edge has the size that its place asks for.
TEST(Mesh, SizeIsGraded) {
  const Polyline hole = polygon_of_circle({0, 0}, 0.5, 64);
  const auto size_at = [](Vec2 p) { return std::clamp(0.05 + 0.15 * (p.norm() - 0.5), 0.05, 0.5); };
  const Tessellation t = mesh({rectangle(-5, -5, 10, 10), {hole}, {}}, size_at, plenty);
  double squares = 0;  // ∫ dA / size², on a fine grid
  constexpr int n = 1000;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec2 p(-5 + 10 * (i + 0.5) / n, -5 + 10 * (j + 0.5) / n);
      if (p.norm() > 0.5) squares += 1e-4 / (size_at(p) * size_at(p));
    }
  expect_tessellation(t, 100 - signed_area(hole));
  expect_quality(t, size_at, squares);
}

// The trace that ends in the rock is there over its whole length, as interfaces that bear its number.
TEST(Mesh, TracesAreEdges) {
  const std::vector<Polyline> traces = {{{0.5, 0.5}, {1.6, 0.9}}, {{1, -1}, {1.2, 3}}};
  const Tessellation t = mesh({rectangle(0, 0, 2, 1.5), {}, traces}, uniform(0.1), plenty);
  expect_tessellation(t, 3);
  double length[2] = {0, 0};
  for (const auto& i : t.interfaces) {
    if (i.trace < 0) continue;
    length[i.trace] += test::edge_length(t, i.p, i.q);
    for (int p : {i.p, i.q}) EXPECT_LT(distance_to_segment(traces[i.trace][0], traces[i.trace][1], t.points[p]), 1e-9);
  }
  EXPECT_NEAR(length[0], Vec2(1.1, 0.4).norm(), 1e-9);
  EXPECT_NEAR(length[1], 1.5 * Vec2(0.2, 4).norm() / 4, 1e-9);
}

TEST(Mesh, NarrowCornersOfTheRegionMayBeNarrow) {
  const Polyline wedge = {{0, 0}, {4, 0}, {4, 0.6}};
  const Tessellation t = mesh({wedge, {}, {}}, uniform(0.2), plenty);
  expect_tessellation(t, 1.2);
  EXPECT_NEAR(least_angle(t), std::atan2(0.6, 4) * 180 / std::numbers::pi, 1e-6);
}

TEST(Mesh, IsTheSameEveryTime) {
  const TessellationInput input{rectangle(0, 0, 3, 2), {polygon_of_circle({1, 1}, 0.3, 20)}, {{{0, 0}, {3, 2}}}};
  EXPECT_TRUE(test::same(mesh(input, uniform(0.1), plenty), mesh(input, uniform(0.1), plenty)));
}

// Far away, turned and larger: the same triangles, their places moved but for round-off.
TEST(Mesh, DoesNotDependOnOriginTurnAndUnit) {
  const auto moved = [](const Vec2& p, const Vec2& shift, double turn, double unit) -> Vec2 {
    return shift + unit * (std::cos(turn) * p + std::sin(turn) * perp(p));
  };
  const auto made = [&](const Vec2& shift, double turn, double unit) {
    TessellationInput input{rectangle(0, 0, 3, 2), {polygon_of_circle({1, 1}, 0.3, 20)}, {{{0, 0.3}, {2, 1.7}}}};
    for (Polyline* line : {&input.outline, &input.holes[0], &input.traces[0]})
      for (Vec2& p : *line) p = moved(p, shift, turn, unit);
    return mesh(input, uniform(0.1 * unit), plenty);
  };
  const Tessellation near = made({0, 0}, 0, 1);
  for (const auto& [shift, turn, unit] :
       {std::tuple(Vec2(1e4, -3e4), 0.0, 1.0), std::tuple(Vec2(0, 0), 0.0, 1000.0), std::tuple(Vec2(0, 0), 0.7, 1.0),
        std::tuple(Vec2(1, 2), 2.0, 30.0), std::tuple(Vec2(1e4, 1e4), -1.9, 1.0)}) {
    const Tessellation t = made(shift, turn, unit);
    ASSERT_EQ(t.cells, near.cells) << turn;
    for (std::size_t p = 0; p < t.points.size(); ++p)
      EXPECT_NEAR((t.points[p] - moved(near.points[p], shift, turn, unit)).norm(), 0, 1e-9 * unit);
  }
}

// The mesher may ask for the size at some thousand places, but not at the millions that the mesh would have.
TEST(Mesh, TooManyTrianglesAreRefusedBeforehand) {
  long calls = 0;
  const auto size_at = [&calls](Vec2) {
    ++calls;
    return 1e-4;
  };
  try {
    mesh({rectangle(0, 0, 1, 1), {}, {}}, size_at, 200000);
    FAIL() << "240 million triangles";
  } catch (const std::length_error& error) {
    EXPECT_NE(std::string(error.what()).find("about 2.4e+08"), std::string::npos) << error.what();
  }
  EXPECT_LT(calls, 100000);
}

// The size is coarse; the many corners of a hole make the mesh fine, and that shows only on the way.
TEST(Mesh, TooManyTrianglesAreRefusedOnTheWay) {
  const Polyline fine = polygon_of_circle({0.5, 0.5}, 0.4, 3000);
  EXPECT_THROW(mesh({rectangle(0, 0, 1, 1), {fine}, {}}, uniform(0.5), 500), std::length_error);
}

TEST(Mesh, SizeMustBePositiveAndFinite) {
  for (double size : {0.0, -1.0, double(NAN), double(INFINITY)})
    EXPECT_THROW(mesh({rectangle(0, 0, 1, 1), {}, {}}, uniform(size), plenty), std::invalid_argument) << size;
}

// Coarser than the region: as few triangles as its corners allow.
TEST(Mesh, CoarserThanTheRegion) {
  const Tessellation t = mesh({rectangle(0, 0, 1, 1), {}, {}}, uniform(10), plenty);
  expect_tessellation(t, 1);
  EXPECT_EQ(t.cells.size(), 2u);
}

}  // namespace
}  // namespace talus
