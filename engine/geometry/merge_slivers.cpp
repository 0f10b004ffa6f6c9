#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "geometry/loops.h"
#include "geometry/polygon.h"
#include "geometry/tidy.h"

namespace talus {
namespace {

// Points this part of an edge beside it lie on it: those of a cut do but for its tolerance.
constexpr double straight = 1e-6;

class Merger {
 public:
  Merger(Loops& loops, const LengthAt& least, bool across_traces);
  long run();

 private:
  struct Neighbour {
    bool across;
    double length;
    int cell;
  };

  void look_at(int cell);
  std::vector<Neighbour> neighbours(int cell) const;
  bool merge(int sliver, int into);
  void drop_needless_points();
  void drop_if_needless(int point, const std::vector<int>& cells);

  Loops& loops_;
  const LengthAt& least_;
  bool across_traces_;
  std::unordered_map<std::uint64_t, int> cell_at_;  // of directed edges
  std::set<std::pair<double, int>> thin_;           // thickness / least, cell
  std::vector<double> ratio_;
  std::set<int> touched_;  // points where merged cells end
};

Merger::Merger(Loops& loops, const LengthAt& least, bool across_traces)
    : loops_(loops), least_(least), across_traces_(across_traces), ratio_(loops.size(), 1) {
  for (int c = 0; c < loops_.size(); ++c) {
    const Loop& loop = loops_[c];
    for (std::size_t k = 0; k < loop.size(); ++k)
      cell_at_[directed(loop[k].point, loop[(k + 1) % loop.size()].point)] = c;
    look_at(c);
  }
}

void Merger::look_at(int cell) {
  thin_.erase({ratio_[cell], cell});
  const Polyline outline = loops_.outline(loops_[cell]);
  ratio_[cell] = thickness(outline) / least_(integrate(outline).centroid);
  if (ratio_[cell] < 1) thin_.insert({ratio_[cell], cell});
}

// The best first.
std::vector<Merger::Neighbour> Merger::neighbours(int cell) const {
  std::map<int, Neighbour> by_cell;
  const Loop& loop = loops_[cell];
  for (std::size_t k = 0; k < loop.size(); ++k) {
    if (loop[k].trace == on_boundary || (loop[k].trace >= 0 && !across_traces_)) continue;
    const int p = loop[k].point, q = loop[(k + 1) % loop.size()].point;
    const int other = cell_at_.at(directed(q, p));
    Neighbour& n = by_cell.try_emplace(other, Neighbour{false, 0, other}).first->second;
    n.across |= loop[k].trace >= 0;
    n.length += (loops_.points()[q] - loops_.points()[p]).norm();
  }
  std::vector<Neighbour> list;
  for (const auto& [other, n] : by_cell) list.push_back(n);
  std::sort(list.begin(), list.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::tuple(a.across, -a.length, a.cell) < std::tuple(b.across, -b.length, b.cell);
  });
  return list;
}

// False where the two meet in more than one stretch, or the union would touch itself.
bool Merger::merge(int sliver, int into) {
  Loop loop = loops_[sliver], other = loops_[into];
  const auto shared = [&](std::size_t k) {
    const auto twin = cell_at_.find(directed(loop[(k + 1) % loop.size()].point, loop[k].point));
    return twin != cell_at_.end() && twin->second == into;
  };
  std::size_t starts = 0, start = 0, count = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    count += shared(k);
    if (!shared(k) || shared((k + loop.size() - 1) % loop.size())) continue;
    ++starts;
    start = k;
  }
  if (starts != 1) return false;
  std::rotate(loop.begin(), loop.begin() + static_cast<long>(start), loop.end());
  const int from = loop[0].point, to = loop[count].point;
  const auto at = [&](int point) {
    return std::find_if(other.begin(), other.end(), [point](const Corner& c) { return c.point == point; });
  };
  std::rotate(other.begin(), at(from), other.end());
  Loop whole(loop.begin() + static_cast<long>(count), loop.end());
  whole.insert(whole.end(), other.begin(), at(to));
  std::unordered_set<int> seen;
  for (const Corner& c : whole)
    if (!seen.insert(c.point).second) return false;
  for (std::size_t k = 0; k < count; ++k) {
    cell_at_.erase(directed(loop[k].point, loop[k + 1].point));
    cell_at_.erase(directed(loop[k + 1].point, loop[k].point));
  }
  for (std::size_t k = count; k < loop.size(); ++k)
    cell_at_[directed(loop[k].point, loop[(k + 1) % loop.size()].point)] = into;
  loops_[sliver].clear();
  loops_[into] = std::move(whole);
  touched_.insert({from, to});
  return true;
}

// Where a sliver ended, its neighbours may have a corner in a straight edge, left for nothing.
void Merger::drop_needless_points() {
  std::unordered_map<int, std::vector<int>> cells;
  for (int c = 0; c < loops_.size(); ++c)
    for (const Corner& corner : loops_[c])
      if (touched_.contains(corner.point)) cells[corner.point].push_back(c);
  for (int point : touched_) drop_if_needless(point, cells[point]);
}

void Merger::drop_if_needless(int point, const std::vector<int>& cells) {
  if (cells.empty() || cells.size() > 2) return;
  const auto place = [&](const Loop& loop) {
    return std::find_if(loop.begin(), loop.end(), [point](const Corner& c) { return c.point == point; }) - loop.begin();
  };
  for (int c : cells) {
    const Loop& loop = loops_[c];
    const long size = static_cast<long>(loop.size()), k = place(loop);
    const Corner &before = loop[(k + size - 1) % size], &here = loop[k], &after = loop[(k + 1) % size];
    const bool whole_boundary = cells.size() == 1 && here.trace == on_boundary;
    if (size < 4 || before.trace != here.trace || (here.trace == on_boundary) != whole_boundary) return;
    const Vec2 a = loops_.points()[before.point], b = loops_.points()[after.point];
    if (distance_to_segment(a, b, loops_.points()[point]) > straight * (b - a).norm()) return;
  }
  for (int c : cells) loops_[c].erase(loops_[c].begin() + place(loops_[c]));
}

long Merger::run() {
  long merged = 0;
  while (!thin_.empty()) {
    const int sliver = thin_.begin()->second;
    thin_.erase(thin_.begin());
    for (const Neighbour& n : neighbours(sliver)) {
      if (!merge(sliver, n.cell)) continue;
      look_at(n.cell);
      ++merged;
      break;
    }
  }
  drop_needless_points();
  return merged;
}

}  // namespace

SliverCount count_slivers(const Tessellation& t, const LengthAt& least) {
  SliverCount count;
  double thinnest = 1;
  for (const std::vector<int>& cell : t.cells) {
    const Polyline outline = t.outline(cell);
    const Vec2 centroid = integrate(outline).centroid;
    const double thick = thickness(outline), ratio = thick / least(centroid);
    if (ratio >= 1) continue;
    ++count.cells;
    if (ratio >= thinnest) continue;
    thinnest = ratio;
    count.where = centroid;
    count.thickness = thick;
  }
  return count;
}

long merge_slivers(Tessellation& t, const LengthAt& least, bool across_traces) {
  Loops loops(t);
  const long merged = Merger(loops, least, across_traces).run();
  if (merged > 0) t = loops.tessellation();
  return merged;
}

}  // namespace talus
