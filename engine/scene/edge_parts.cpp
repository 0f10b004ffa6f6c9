#include "scene/edge_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace talus {

namespace {

// length over thickness; triangles of a mesh come to 10.6, between angles of 20.7°
constexpr double slender_block = 8, slender_triangle = 12;

int parts_of_edge(double length, double area, double slender) {
  const double ratio = length * length / area;
  return ratio <= slender ? 2 : 2 * int(std::ceil(std::sqrt(20 * ratio / 8) / 2));
}

using Ends = std::pair<int, int>;  // of an edge of a tessellation, in order

}  // namespace

Polyline divided(const Polyline& outline) {
  const double area = signed_area(outline);
  Polyline result;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2 from = outline[i], span = outline[(i + 1) % outline.size()] - from;
    const int parts = parts_of_edge(span.norm(), area, slender_block);
    for (int k = 0; k < parts; ++k) result.emplace_back(from + double(k) / parts * span);
  }
  return result;
}

std::vector<DividedCell> divided(const Tessellation& t, const std::vector<char>& bends) {
  std::map<Ends, int> parts;
  for (size_t c = 0; c < bends.size(); ++c) {
    if (!bends[c]) continue;
    const std::vector<int>& cell = t.cells[c];
    const Polyline outline = t.outline(cell);
    const double area = signed_area(outline), slender = cell.size() == 3 ? slender_triangle : slender_block;
    for (size_t i = 0, next = 1; i < cell.size(); ++i, next = (i + 1) % cell.size()) {
      int& count = parts[std::minmax(cell[i], cell[next])];
      count = std::max(count, parts_of_edge((outline[next] - outline[i]).norm(), area, slender));
    }
  }
  // Of both cells the same place, to the last bit.
  const auto on_edge = [&t](const Ends& ends, double at) {
    return Vec2(t.points[size_t(ends.first)] + at * (t.points[size_t(ends.second)] - t.points[size_t(ends.first)]));
  };
  std::vector<DividedCell> result(t.cells.size());
  for (size_t c = 0; c < t.cells.size(); ++c) {
    const std::vector<int>& cell = t.cells[c];
    auto& [outline, corner] = result[c];
    for (size_t i = 0, next = 1; i < cell.size(); ++i, next = (i + 1) % cell.size()) {
      corner.push_back(int(outline.size()));
      outline.push_back(t.points[size_t(cell[i])]);
      const Ends ends = std::minmax(cell[i], cell[next]);
      const auto found = parts.find(ends);
      const int count = found == parts.end() ? 1 : found->second;
      for (int k = 1; k < count; ++k)
        outline.push_back(on_edge(ends, double(cell[i] == ends.first ? k : count - k) / count));
    }
    corner.push_back(int(outline.size()));
  }
  return result;
}

}  // namespace talus
