#include <gtest/gtest.h>

#include "geometry/tidy.h"
#include "hand_model.h"
#include "tessellation_checks.h"

namespace talus {
namespace {

using test::cell_outline;
using test::expect_tessellation;
using test::rectangle;

LengthAt everywhere(double length) {
  return [length](const Vec2&) { return length; };
}

const Polyline square = rectangle(0, 0, 1, 1);

double shortest_edge(const Tessellation& t) {
  double least = 1e9;
  for (const auto& cell : t.cells)
    for (std::size_t k = 0; k < cell.size(); ++k)
      least = std::min(least, test::edge_length(t, cell[k], cell[(k + 1) % cell.size()]));
  return least;
}

TEST(Tidy, ThicknessIsTheRadiusOfAnInscribedCircle) {
  EXPECT_DOUBLE_EQ(thickness({{0, 0}, {3, 0}, {0, 4}}), 1);  // of the 3-4-5 triangle
  EXPECT_DOUBLE_EQ(thickness(rectangle(5, 5, 2, 2)), 1);
  EXPECT_NEAR(thickness(rectangle(0, 0, 1000, 1)), 1, 1e-3);  // the width of a strip
}

TEST(Tidy, CountsSliversAndNamesTheThinnest) {
  const Tessellation t = cut({square, {}, {{{0, 0.5}, {1, 0.5}}, {{0, 0.51}, {1, 0.51}}, {{0, 0.8}, {1, 0.804}}}});
  const SliverCount count = count_slivers(t, everywhere(0.05));
  EXPECT_EQ(count.cells, 1);
  EXPECT_NEAR(count.where.y(), 0.505, 1e-9);
  EXPECT_NEAR(count.thickness, 2 * 0.01 / 2.02, 1e-9);
  EXPECT_EQ(count_slivers(t, everywhere(0.005)).cells, 0);
}

// Two joints that run into each other at half a degree leave a wedge; it goes to one side, whole, and takes its
// needless corners with it.
TEST(Tidy, AWedgeBetweenTwoJointsIsMerged) {
  Tessellation t = cut({square, {}, {{{0, 0.5}, {1, 0.5}}, {{0, 0.5}, {1, 0.51}}}});
  ASSERT_EQ(t.cells.size(), 3u);
  EXPECT_EQ(merge_slivers(t, everywhere(0.02), true), 1);
  expect_tessellation(t, 1);
  EXPECT_EQ(t.cells.size(), 2u);
  for (const auto& cell : t.cells) EXPECT_EQ(cell.size(), 4u);
  EXPECT_EQ(t.interfaces.size(), 1u);
}

TEST(Tidy, AcrossTracesOnlyWhereAllowed) {
  const std::vector<Polyline> lines = {{{0, 0.5}, {1, 0.5}}, {{0, 0.51}, {1, 0.51}}};
  Tessellation t = cut({square, {}, lines});
  EXPECT_EQ(merge_slivers(t, everywhere(0.1), false), 0);
  EXPECT_EQ(t.cells.size(), 3u);
  t.interfaces[0].trace = -1;  // now the lower one, or the upper one, is no joint
  EXPECT_EQ(merge_slivers(t, everywhere(0.1), false), 1);
  expect_tessellation(t, 1);
  EXPECT_EQ(t.interfaces.size(), 1u);
  EXPECT_GE(t.interfaces[0].trace, 0);
}

// Three joints that all but pass one point: the speck between them goes, and they meet in one point.
TEST(Tidy, ThreeJointsAllButThroughOnePoint) {
  Tessellation t = cut({square, {}, {{{0, 0}, {1, 1}}, {{0, 1}, {1, 0}}, {{0.505, 0}, {0.505, 1}}}});
  ASSERT_EQ(t.cells.size(), 7u);
  EXPECT_EQ(merge_slivers(t, everywhere(0.02), true), 1);
  EXPECT_GE(close_short_edges(t, everywhere(0.02), {square}), 1);
  expect_tessellation(t, 1);
  EXPECT_EQ(t.cells.size(), 6u);
  EXPECT_GT(shortest_edge(t), 0.4);
}

// A point on a side slides along it; corners that were given stay.
TEST(Tidy, TheBoundaryKeepsItsShape) {
  Tessellation t = cut({square, {}, {{{0.01, 0}, {0.4, 1}}, {{0.6, 0}, {0.61, 1}}, {{0.605, 0}, {0.9, 1}}}});
  merge_slivers(t, everywhere(0.02), true);
  EXPECT_EQ(close_short_edges(t, everywhere(0.02), {square}), 2);
  expect_tessellation(t, 1);
  EXPECT_GT(shortest_edge(t), 0.02);
  for (const Vec2& p : square) EXPECT_EQ(std::count(t.points.begin(), t.points.end(), p), 1);
}

TEST(Tidy, NothingToDoChangesNothing) {
  const Tessellation before = cut({square, {}, {{{0, 0.3}, {1, 0.4}}, {{0.5, 0}, {0.6, 1}}}});
  Tessellation t = before;
  EXPECT_EQ(merge_slivers(t, everywhere(0.02), true), 0);
  EXPECT_EQ(close_short_edges(t, everywhere(0.02), {square}), 0);
  EXPECT_TRUE(test::same(t, before));
}

}  // namespace
}  // namespace talus
