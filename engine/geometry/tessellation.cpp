#include "geometry/tessellation.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace talus {
namespace {

// Edge from → to with `cell` on its left.
struct Side {
  int low, high;  // its points, whichever way it runs
  bool rising;    // runs low → high
  int cell;
  int from() const { return rising ? low : high; }
  int to() const { return rising ? high : low; }
};

// All sides of all cells, the two of a shared edge next to each other, the rising one first.
std::vector<Side> sorted_sides(const Tessellation& t) {
  std::vector<Side> sides;
  for (int cell = 0; cell < static_cast<int>(t.cells.size()); ++cell) {
    const std::vector<int>& loop = t.cells[cell];
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
      sides.push_back({std::min(loop[j], loop[i]), std::max(loop[j], loop[i]), loop[j] < loop[i], cell});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return std::tuple(s.low, s.high, !s.rising) < std::tuple(t.low, t.high, !t.rising);
  });
  return sides;
}

bool same_edge(const Side& s, const Side& t) {
  return s.low == t.low && s.high == t.high;
}

}  // namespace

void connect(Tessellation& t) {
  const std::vector<Side> sides = sorted_sides(t);
  t.interfaces.clear();
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &s = sides[i], &o = sides[i + 1];
    if (!same_edge(s, o)) continue;
    if (s.rising == o.rising) throw std::logic_error("tessellation: two cells on the same side of an edge");
    const Side& a = s.cell < o.cell ? s : o;
    const Side& b = s.cell < o.cell ? o : s;
    t.interfaces.push_back({a.cell, b.cell, a.from(), a.to(), -1});
  }
  std::sort(t.interfaces.begin(), t.interfaces.end(),
            [](const Tessellation::Interface& i, const Tessellation::Interface& j) {
              return std::tie(i.a, i.b, i.p) < std::tie(j.a, j.b, j.p);
            });
}

void drop_unused_points(Tessellation& t) {
  std::vector<int> index(t.points.size(), -1);
  for (const auto& loop : t.cells)
    for (int p : loop) index[p] = 0;
  std::vector<Vec2> used;
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (index[i] < 0) continue;
    index[i] = static_cast<int>(used.size());
    used.push_back(t.points[i]);
  }
  t.points = std::move(used);
  for (auto& loop : t.cells)
    for (int& p : loop) p = index[p];
  for (Tessellation::Interface& i : t.interfaces) {
    i.p = index[i.p];
    i.q = index[i.q];
  }
}

std::vector<BoundaryEdge> boundary_edges(const Tessellation& t) {
  const std::vector<Side> sides = sorted_sides(t);
  std::vector<BoundaryEdge> edges;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const bool paired =
        (i > 0 && same_edge(sides[i - 1], sides[i])) || (i + 1 < sides.size() && same_edge(sides[i], sides[i + 1]));
    if (!paired) edges.push_back({sides[i].cell, sides[i].from(), sides[i].to()});
  }
  std::sort(edges.begin(), edges.end(),
            [](const BoundaryEdge& e, const BoundaryEdge& f) { return std::tie(e.cell, e.p) < std::tie(f.cell, f.p); });
  return edges;
}

}  // namespace talus
