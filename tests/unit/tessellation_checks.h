#pragma once
// What every tessellation must be, whoever made it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/tessellation.h"

namespace talus::test {

constexpr long plenty = 100000;  // cells

inline std::function<double(Vec2)> uniform(double size) {
  return [size](Vec2) { return size; };
}

inline Polyline polygon_of_circle(const Vec2& at, double radius, int sides) {
  Polyline points;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    points.push_back(at + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

inline Polyline cell_outline(const Tessellation& t, std::size_t cell) {
  Polyline outline;
  for (int p : t.cells[cell]) outline.push_back(t.points[p]);
  return outline;
}

inline double total_area(const Tessellation& t) {
  double area = 0;
  for (std::size_t c = 0; c < t.cells.size(); ++c) area += signed_area(cell_outline(t, c));
  return area;
}

inline bool has_edge(const std::vector<int>& cell, int p, int q) {
  for (std::size_t k = 0; k < cell.size(); ++k)
    if (cell[k] == p && cell[(k + 1) % cell.size()] == q) return true;
  return false;
}

inline double edge_length(const Tessellation& t, int p, int q) {
  return (t.points[p] - t.points[q]).norm();
}

// Simple counter-clockwise cells that fill `area`; each inner edge is an interface, once, a on its left, sorted.
inline void expect_tessellation(const Tessellation& t, double area) {
  std::size_t sides = 0;
  double perimeters = 0, inner = 0, outer = 0;
  for (std::size_t c = 0; c < t.cells.size(); ++c) {
    const Polyline outline = cell_outline(t, c);
    EXPECT_EQ(defect(outline).value_or("none"), "none") << "cell " << c;
    sides += outline.size();
    for (std::size_t k = 0; k < outline.size(); ++k)
      perimeters += (outline[k] - outline[(k + 1) % outline.size()]).norm();
  }
  EXPECT_NEAR(total_area(t), area, 1e-12 * area);
  for (const auto& i : t.interfaces) {
    EXPECT_LT(i.a, i.b);
    EXPECT_TRUE(has_edge(t.cells[i.a], i.p, i.q) && has_edge(t.cells[i.b], i.q, i.p));
    inner += edge_length(t, i.p, i.q);
  }
  const auto before = [](const auto& i, const auto& j) { return std::tie(i.a, i.b, i.p) < std::tie(j.a, j.b, j.p); };
  EXPECT_TRUE(std::is_sorted(t.interfaces.begin(), t.interfaces.end(), before));
  const auto boundary = boundary_edges(t);
  for (const BoundaryEdge& e : boundary) outer += edge_length(t, e.p, e.q);
  EXPECT_EQ(sides, 2 * t.interfaces.size() + boundary.size());
  EXPECT_NEAR(perimeters, 2 * inner + outer, 1e-12 * perimeters);
}

inline bool same(const Tessellation& s, const Tessellation& t) {
  const auto key = [](const auto& i) { return std::tie(i.a, i.b, i.p, i.q, i.trace); };
  return s.points == t.points && s.cells == t.cells &&
         std::equal(s.interfaces.begin(), s.interfaces.end(), t.interfaces.begin(), t.interfaces.end(),
                    [&](const auto& i, const auto& j) { return key(i) == key(j); });
}

}  // namespace talus::test
