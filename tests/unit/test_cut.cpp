#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>

#include "geometry/joint_set.h"
#include "hand_model.h"
#include "tessellation_checks.h"

namespace talus {
namespace {

using test::cell_outline;
using test::expect_tessellation;
using test::rectangle;

Tessellation cut_square(const std::vector<Polyline>& traces) {
  return cut({rectangle(0, 0, 1, 1), {}, traces});
}

std::vector<double> areas(const Tessellation& t) {
  std::vector<double> list;
  for (std::size_t c = 0; c < t.cells.size(); ++c) list.push_back(signed_area(cell_outline(t, c)));
  std::sort(list.begin(), list.end());
  return list;
}

std::multiset<int> traces_of(const Tessellation& t) {
  std::multiset<int> traces;
  for (const auto& i : t.interfaces) traces.insert(i.trace);
  return traces;
}

TEST(Cut, NothingLeavesTheRegion) {
  const Tessellation t = cut_square({});
  expect_tessellation(t, 1);
  EXPECT_EQ(t.cells.size(), 1u);
  EXPECT_TRUE(t.interfaces.empty());
}

TEST(Cut, CrossingLines) {
  const Tessellation t = cut_square({{{-1, 0.25}, {2, 0.25}}, {{0.5, 0}, {0.5, 1}}});
  expect_tessellation(t, 1);
  EXPECT_EQ(areas(t), (std::vector<double>{0.125, 0.125, 0.375, 0.375}));
  EXPECT_EQ(traces_of(t), (std::multiset<int>{0, 0, 1, 1}));
}

TEST(Cut, DanglingEndsAreDropped) {
  const Tessellation alone = cut_square({{{0, 0.5}, {0.7, 0.5}}, {{0.2, 0.1}, {0.4, 0.3}}});
  expect_tessellation(alone, 1);
  EXPECT_EQ(alone.cells.size(), 1u);
  EXPECT_EQ(alone.cells[0].size(), 4u);  // no point where the joint ended on the outline
  const Tessellation crossed = cut_square({{{0, 0.5}, {0.7, 0.5}}, {{0.5, 0}, {0.5, 1}}});
  expect_tessellation(crossed, 1);
  EXPECT_EQ(areas(crossed), (std::vector<double>{0.25, 0.25, 0.5}));  // the tail beyond x = 0.5 bounds nothing
}

TEST(Cut, BentTraceKeepsItsBend) {
  const Tessellation t = cut_square({{{0, 0.25}, {0.5, 0.75}, {1, 0.25}}});
  expect_tessellation(t, 1);
  EXPECT_EQ(areas(t), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(traces_of(t), (std::multiset<int>{0, 0}));
}

TEST(Cut, OfOverlappingTracesTheLowestCounts) {
  const Tessellation t = cut_square({{{0.25, 0.5}, {0.75, 0.5}}, {{0, 0.5}, {1, 0.5}}, {{0.5, 0.5}, {2, 0.5}}});
  expect_tessellation(t, 1);
  EXPECT_EQ(t.cells.size(), 2u);
  double length[3] = {0, 0, 0};
  for (const auto& i : t.interfaces) length[i.trace] += test::edge_length(t, i.p, i.q);
  EXPECT_DOUBLE_EQ(length[0], 0.5);
  EXPECT_DOUBLE_EQ(length[1], 0.5);
  EXPECT_EQ(length[2], 0);
}

// Three lines that pass one point but for 1e-12 make six blocks, not six and a speck; 1e-4 apart there is a
// seventh.
TEST(Cut, ThreeLinesThroughOnePoint) {
  const auto t = [](double off) {
    return cut_square({{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}, {{0.5 + off, 0}, {0.5 + off, 1}}});
  };
  expect_tessellation(t(1e-12), 1);
  EXPECT_EQ(t(1e-12).cells.size(), 6u);
  for (const auto& i : t(1e-12).interfaces) EXPECT_GT(test::edge_length(t(1e-12), i.p, i.q), 0.1);
  EXPECT_EQ(t(1e-4).cells.size(), 7u);
}

TEST(Cut, ATraceThatAllButReachesTheOutlineDoes) {
  EXPECT_EQ(cut_square({{{1e-13, 0.5}, {1 - 1e-13, 0.4}}}).cells.size(), 2u);
  EXPECT_EQ(cut_square({{{1e-6, 0.5}, {1 - 1e-6, 0.4}}}).cells.size(), 1u);
}

TEST(Cut, ATraceThatAllButReachesAnotherDoes) {
  const auto t = [](double gap) { return cut_square({{{0, 0.5}, {1, 0.6}}, {{0.5, 0}, {0.5, 0.55 - gap}}}); };
  for (double gap : {1e-13, -1e-13}) {
    expect_tessellation(t(gap), 1);
    EXPECT_EQ(t(gap).cells.size(), 3u) << gap;
  }
  EXPECT_EQ(t(1e-6).cells.size(), 2u);
}

TEST(Cut, HoleIsLeftOut) {
  const Polyline hole = rectangle(0.4, 0.4, 0.2, 0.3);
  const Tessellation t = cut({rectangle(0, 0, 1, 1), {hole}, {{{0, 0.5}, {1, 0.5}}}});
  expect_tessellation(t, 1 - 0.06);
  EXPECT_EQ(t.cells.size(), 2u);
  EXPECT_EQ(t.interfaces.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) EXPECT_EQ(overlap_area(cell_outline(t, c), hole), 0);
}

TEST(Cut, RefusesBlocksWithHoles) {
  EXPECT_THROW(cut({rectangle(0, 0, 1, 1), {rectangle(0.4, 0.4, 0.2, 0.2)}, {}}), std::invalid_argument);
  EXPECT_THROW(cut_square({{{0.2, 0.2}, {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.2}}}), std::invalid_argument);
  EXPECT_THROW(cut_square({{{0, 0.5}, {NAN, 0.5}}}), std::invalid_argument);
}

struct Chords {
  std::vector<Polyline> lines;
  int crossings = 0;  // inside the circle
};

Chords random_chords(int count, unsigned seed, const Vec2& centre) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi), offset(-0.9, 0.9);
  Chords chords;
  std::vector<std::pair<Vec2, double>> made;  // unit normal, offset
  for (int k = 0; k < count; ++k) {
    const double a = angle(random), d = offset(random);
    const Vec2 n(std::cos(a), std::sin(a));
    for (const auto& [m, e] : made) {
      const double det = cross(n, m);
      const Vec2 at((d * m.y() - e * n.y()) / det, (e * n.x() - d * m.x()) / det);
      chords.crossings += at.norm() < 0.99998;  // in the outline of 400 corners below
    }
    made.emplace_back(n, d);
    chords.lines.push_back({centre + d * n - 2 * perp(n), centre + d * n + 2 * perp(n)});
  }
  return chords;
}

// n lines across a convex region make 1 + n + (their crossings inside) blocks, whose areas add up.
TEST(Cut, RandomLinesMakeTheBlocksThatEulerSays) {
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const Vec2& centre : {Vec2(0, 0), Vec2(5e3, -2e3)}) {
      const Chords chords = random_chords(40, seed, centre);
      Polyline outline;
      for (int k = 0; k < 400; ++k)
        outline.push_back(centre + Vec2(std::cos(k * std::numbers::pi / 200), std::sin(k * std::numbers::pi / 200)));
      const Tessellation t = cut({outline, {}, chords.lines});
      EXPECT_EQ(t.cells.size(), std::size_t(1 + 40 + chords.crossings)) << seed;
      expect_tessellation(t, signed_area(outline));
    }
}

TEST(Cut, IsTheSameEveryTime) {
  const TessellationInput input{rectangle(-2, -2, 4, 4), {}, random_chords(30, 7, {0, 0}).lines};
  EXPECT_TRUE(test::same(cut(input), cut(input)));
}

TEST(Cut, GivenPointsAreKeptToTheBit) {
  const Polyline outline = {{0.1, 0.2}, {1.7, 0.3}, {1.1, 1.9}};
  const Tessellation t = cut({outline, {}, {{{0.1, 0.2}, {1.4, 1.1}}}});
  for (const Vec2& p : outline) EXPECT_EQ(std::count(t.points.begin(), t.points.end(), p), 1);
}

TEST(Cut, SliversGoToTheirNeighbour) {
  const std::vector<Polyline> lines = {{{0, 0.5}, {1, 0.5}}, {{0, 0.5 + 1e-5}, {1, 0.5 + 1e-5}}};
  EXPECT_EQ(cut_square(lines).cells.size(), 3u);
  const Tessellation t = cut({rectangle(0, 0, 1, 1), {}, lines}, 1e-4);
  expect_tessellation(t, 1);
  EXPECT_EQ(t.cells.size(), 2u);
}

// Bridges join blocks: the less persistent, the fewer; none is left of a set that nothing crosses.
TEST(Cut, RockBridgesJoinBlocks) {
  const auto lines = [](double dip, double persistence) {
    JointSet set;
    set.dip = dip;
    set.spacing = 0.1;
    set.persistence = persistence;
    set.trace_length = 0.3;
    set.through = Vec2(0.05, 0.05);
    return joint_lines(set, {0, 0}, {1, 1});
  };
  const auto blocks = [&](double persistence) {
    std::vector<Polyline> all = lines(0, 1);
    for (const Polyline& line : lines(std::numbers::pi / 2, persistence)) all.push_back(line);
    const Tessellation t = cut_square(all);
    expect_tessellation(t, 1);
    return t.cells.size();
  };
  EXPECT_EQ(blocks(1), 121u);
  EXPECT_LT(blocks(0.8), 121u);
  EXPECT_LT(blocks(0.5), blocks(0.8));
  EXPECT_GT(blocks(0.5), 11u);
  EXPECT_EQ(cut_square(lines(0, 0.5)).cells.size(), 1u);
}

}  // namespace
}  // namespace talus
