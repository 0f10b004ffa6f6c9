#include "geometry/loops.h"

#include <algorithm>
#include <unordered_map>

namespace talus {

Loops::Loops(const Tessellation& t) : points_(t.points), loops_(t.cells.size()) {
  std::unordered_map<std::uint64_t, int> traces;
  for (const Tessellation::Interface& i : t.interfaces)
    traces[directed(i.p, i.q)] = traces[directed(i.q, i.p)] = i.trace;
  for (std::size_t c = 0; c < t.cells.size(); ++c) {
    const std::vector<int>& cell = t.cells[c];
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const auto trace = traces.find(directed(cell[k], cell[(k + 1) % cell.size()]));
      loops_[c].push_back({cell[k], trace == traces.end() ? on_boundary : trace->second});
    }
  }
}

Tessellation Loops::tessellation() const {
  Tessellation t;
  t.points = points_;
  std::vector<int> kept;
  for (int c = 0; c < size(); ++c) {
    if (loops_[c].empty()) continue;
    kept.push_back(c);
    std::vector<int>& cell = t.cells.emplace_back();
    for (const Corner& corner : loops_[c]) cell.push_back(corner.point);
  }
  connect(t);
  for (Tessellation::Interface& i : t.interfaces) {
    const Loop& loop = loops_[kept[i.a]];
    i.trace = std::find_if(loop.begin(), loop.end(), [&](const Corner& c) { return c.point == i.p; })->trace;
  }
  drop_unused_points(t);
  return t;
}

}  // namespace talus
