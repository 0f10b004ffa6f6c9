#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "geometry/grain_chains.h"
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

struct Quality {
  double thinnest = 1e9, shortest = 1e9, mean_area = 0;  // of the size
  double not_convex = 0;                                 // share of the cells
};
Quality quality(const Tessellation& t, const std::function<double(Vec2)>& size_at) {
  Quality q;
  for (std::size_t c = 0; c < t.cells.size(); ++c) {
    const Polyline cell = cell_outline(t, c);
    const double size = size_at(integrate(cell).centroid), area = signed_area(cell);
    q.thinnest = std::min(q.thinnest, thickness(cell) / size);
    q.mean_area += area / (size * size) / double(t.cells.size());
    bool convex = true;
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const Vec2 a = cell[k], b = cell[(k + 1) % cell.size()], d = cell[(k + 2) % cell.size()];
      q.shortest = std::min(q.shortest, (b - a).norm() / size);
      const double turn = std::atan2(cross(b - a, d - b), (b - a).dot(d - b));
      convex = convex && turn > -1e-6;
    }
    q.not_convex += (convex ? 0 : 1) / double(t.cells.size());
  }
  return q;
}

double length_of_trace(const Tessellation& t, int trace) {
  double sum = 0;
  for (const auto& i : t.interfaces)
    if (i.trace == trace) sum += test::edge_length(t, i.p, i.q);
  return sum;
}

TEST(Voronoi, GrainsOfARectangle) {
  for (unsigned seed : {1u, 2u, 3u}) {
    const Tessellation t = voronoi({rectangle(0, 0, 4, 2), {}, {}}, uniform(0.1), seed, plenty);
    expect_tessellation(t, 8);
    const Quality q = quality(t, uniform(0.1));
    EXPECT_NEAR(q.mean_area, 1, 0.05) << seed;
    EXPECT_GT(q.thinnest, 0.25);
    EXPECT_GT(q.shortest, 0.15);
    EXPECT_EQ(q.not_convex, 0);
  }
}

TEST(Voronoi, HolesAreLeftOut) {
  const Polyline outline = rectangle(-2, -2, 4, 4), hole = polygon_of_circle({0.3, 0.1}, 0.8, 40);
  const Tessellation t = voronoi({outline, {hole}, {}}, uniform(0.12), 1, plenty);
  expect_tessellation(t, 16 - signed_area(hole));
  const Quality q = quality(t, uniform(0.12));
  EXPECT_NEAR(q.mean_area, 1, 0.06);
  EXPECT_GT(q.thinnest, 0.25);
  for (const Vec2& p : hole) EXPECT_EQ(std::count(t.points.begin(), t.points.end(), p), 1);
}

// A trace that ends in the rock is there over its whole length but for 0.2 of a grain, with its number.
TEST(Voronoi, TracesAreEdges) {
  const std::vector<Polyline> traces = {{{0.5, 0.5}, {1.6, 0.9}}, {{1, -1}, {1.2, 3}}, {{0, 1.2}, {2, 1.3}}};
  const Tessellation t = voronoi({rectangle(0, 0, 2, 1.5), {}, traces}, uniform(0.1), 1, plenty);
  expect_tessellation(t, 3);
  EXPECT_NEAR(length_of_trace(t, 0), Vec2(1.1, 0.4).norm(), 0.021);
  EXPECT_NEAR(length_of_trace(t, 1), 1.5 * Vec2(0.2, 4).norm() / 4, 0.01);
  EXPECT_NEAR(length_of_trace(t, 2), Vec2(2, 0.1).norm(), 0.01);
  const Quality q = quality(t, uniform(0.1));
  EXPECT_GT(q.thinnest, 0.25);
  EXPECT_GT(q.shortest, 0.15);
  EXPECT_LT(q.not_convex, 0.02);
}

TEST(Voronoi, SizeIsGraded) {
  const auto size_at = [](Vec2 p) { return std::clamp(0.05 + 0.15 * p.norm(), 0.05, 0.4); };
  const Tessellation t = voronoi({rectangle(-4, -4, 8, 8), {}, {}}, size_at, 1, plenty);
  expect_tessellation(t, 64);
  const Quality q = quality(t, size_at);
  EXPECT_NEAR(q.mean_area, 1, 0.1);
  double near = 0, far = 0;
  long near_count = 0, far_count = 0;
  for (std::size_t c = 0; c < t.cells.size(); ++c) {
    const PolygonIntegrals i = integrate(cell_outline(t, c));
    const double relative = i.area / std::pow(size_at(i.centroid), 2);
    (i.centroid.norm() < 0.5 ? near : far) += relative;
    ++(i.centroid.norm() < 0.5 ? near_count : far_count);
  }
  EXPECT_NEAR(near / double(near_count), 1, 0.2);
  EXPECT_NEAR(far / double(far_count), 1, 0.1);
}

TEST(Voronoi, TheSeedDecides) {
  const TessellationInput input{rectangle(0, 0, 1, 1), {}, {{{0, 0.3}, {1, 0.6}}}};
  EXPECT_TRUE(test::same(voronoi(input, uniform(0.1), 7, plenty), voronoi(input, uniform(0.1), 7, plenty)));
  EXPECT_NE(voronoi(input, uniform(0.1), 7, plenty).points, voronoi(input, uniform(0.1), 8, plenty).points);
}

// Shifted, turned and scaled: the same grains. A turn reorders the cells: each is compared with the nearest.
TEST(Voronoi, DoesNotDependOnOriginTurnAndUnit) {
  int sides = 0;  // of the hole
  const auto made = [&sides](const Vec2& shift, double turn, double unit) {
    const auto move = [&](Polyline line) {
      for (Vec2& p : line)
        p = shift + unit * Vec2(std::cos(turn) * p.x() - std::sin(turn) * p.y(),
                                std::sin(turn) * p.x() + std::cos(turn) * p.y());
      return line;
    };
    const TessellationInput input{move(rectangle(0, 0, 3, 2)),
                                  {move(polygon_of_circle({1, 1}, 0.3, sides))},
                                  {move({{0, 0.3}, {2, 1.7}}), move({{0.5, 1.9}, {2.5, 0.2}})}};
    const Tessellation t = voronoi(input, uniform(0.1 * unit), 1, plenty);
    std::vector<std::array<double, 3>> cells;  // in the coordinates of the first
    for (std::size_t c = 0; c < t.cells.size(); ++c) {
      const PolygonIntegrals i = integrate(cell_outline(t, c));
      const Vec2 p = (i.centroid - shift) / unit;
      cells.push_back({std::cos(turn) * p.x() + std::sin(turn) * p.y(),
                       -std::sin(turn) * p.x() + std::cos(turn) * p.y(), i.area / (unit * unit)});
    }
    return cells;
  };
  for (const int each : {12, 20}) {  // corners of 30° too
    sides = each;
    const auto near = made({0, 0}, 0, 1);
    for (const auto& other :
         {made({1e4, -3e4}, 0, 1), made({0, 0}, 0, 1000), made({0, 0}, 0.7, 1), made({1e4, 1e4}, 2, 1)}) {
      ASSERT_EQ(other.size(), near.size()) << sides << " sides";
      double most = 0;
      for (const auto& cell : other) {
        double least = 1;
        for (const auto& n : near)
          least =
              std::min(least, std::max({std::abs(cell[0] - n[0]), std::abs(cell[1] - n[1]), std::abs(cell[2] - n[2])}));
        most = std::max(most, least);
      }
      EXPECT_LT(most, 1e-6) << sides << " sides";
    }
  }
}

// A station at a corner is between its edges: which one is not left to round-off.
TEST(Voronoi, StationsAtCornersFaceTheirBisector) {
  for (const Vec2& centre : {Vec2(0, 0), Vec2(1e4, -3e4)}) {
    const TessellationInput input{polygon_of_circle(centre, 1, 12), {}, {}};
    const Network network = make_network(input);
    const std::vector<GrainChain> chains = grain_chains(network);
    ASSERT_EQ(chains.size(), 1u);
    const MeshFrame frame = MeshFrame::about_first_point(input.outline);
    const std::function<double(Vec2)> unit = uniform(frame.unit());
    const SizeField size(frame, unit);  // six stations
    for (const ChainStation& station : stations(chains[0], network.points, size)) {
      const Vec2 out = station.at - centre;
      EXPECT_NEAR(out.norm(), 1, 1e-9);
      EXPECT_NEAR(station.along.dot(out), 0, 1e-9);
    }
  }
}

TEST(Voronoi, TooManyGrainsAreRefused) {
  EXPECT_THROW(voronoi({rectangle(0, 0, 1, 1), {}, {}}, uniform(1e-3), 1, 1000), std::length_error);
  EXPECT_THROW(voronoi({rectangle(0, 0, 1, 1), {}, {}}, uniform(1e-9), 1, 1000), std::length_error);
}

TEST(Voronoi, SizeMustBePositiveAndFinite) {
  for (double size : {0.0, -1.0, double(NAN), double(INFINITY)})
    EXPECT_THROW(voronoi({rectangle(0, 0, 1, 1), {}, {}}, uniform(size), 1, plenty), std::invalid_argument) << size;
}

TEST(Voronoi, CoarserThanTheRegion) {
  const Tessellation t = voronoi({rectangle(0, 0, 1, 1), {}, {}}, uniform(10), 1, plenty);
  expect_tessellation(t, 1);
  EXPECT_LE(t.cells.size(), 4u);
}

}  // namespace
}  // namespace talus
