#include "scene/edge_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace talus {

namespace {

int parts_of_edge(double length, double area) {
  constexpr double slender = 8;  // length over thickness
  const double ratio = length * length / area;
  return ratio <= slender ? 2 : 2 * int(std::ceil(std::sqrt(20 * ratio / 8) / 2));
}

// Of the edges of a tessellation, by their ends in order.
class EdgeParts {
 public:
  EdgeParts(Tessellation& t, const std::vector<char>& bends) : points_(t.points) {
    for (size_t c = 0; c < t.cells.size(); ++c) {
      const std::vector<int>& cell = t.cells[c];
      const Polyline outline = t.outline(cell);
      const double area = signed_area(outline);
      for (size_t i = 0; i < cell.size(); ++i) {
        int& count = parts_[std::minmax(cell[i], cell[(i + 1) % cell.size()])].count;
        if (bends[c]) count = std::max(count, parts_of_edge((outline[(i + 1) % cell.size()] - outline[i]).norm(), area));
      }
    }
    for (auto& [ends, edge] : parts_) {
      edge.first = int(points_.size());
      const Vec2 from = points_[size_t(ends.first)], span = points_[size_t(ends.second)] - from;
      for (int k = 1; k < edge.count; ++k) points_.emplace_back(from + double(k) / edge.count * span);
    }
  }
  // From p to what is before q.
  std::vector<int> from(int p, int q) const {
    const auto& [count, first] = parts_.at(std::minmax(p, q));
    std::vector<int> way{p};
    for (int k = 0; k < count - 1; ++k) way.push_back(p < q ? first + k : first + count - 2 - k);
    return way;
  }

 private:
  struct Part {
    int count = 1, first = 0;  // first: of the points between the ends
  };
  std::vector<Vec2>& points_;
  std::map<std::pair<int, int>, Part> parts_;
};

}  // namespace

Polyline divided(const Polyline& outline) {
  const double area = signed_area(outline);
  Polyline result;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2 from = outline[i], span = outline[(i + 1) % outline.size()] - from;
    const int parts = parts_of_edge(span.norm(), area);
    for (int k = 0; k < parts; ++k) result.emplace_back(from + double(k) / parts * span);
  }
  return result;
}

void divide_edges(Tessellation& t, const std::vector<char>& bends) {
  const EdgeParts parts(t, bends);
  for (std::vector<int>& cell : t.cells) {
    std::vector<int> corners;
    for (size_t i = 0; i < cell.size(); ++i) {
      const std::vector<int> way = parts.from(cell[i], cell[(i + 1) % cell.size()]);
      corners.insert(corners.end(), way.begin(), way.end());
    }
    cell = std::move(corners);
  }
  std::vector<Tessellation::Interface> interfaces;
  for (const Tessellation::Interface& face : t.interfaces) {
    std::vector<int> way = parts.from(face.p, face.q);
    way.push_back(face.q);
    for (size_t k = 0; k + 1 < way.size(); ++k) interfaces.push_back({face.a, face.b, way[k], way[k + 1], face.trace});
  }
  std::ranges::sort(interfaces, {}, [](const Tessellation::Interface& face) { return std::tuple(face.a, face.b, face.p); });
  t.interfaces = std::move(interfaces);
}

}  // namespace talus
