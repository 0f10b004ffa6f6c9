#include <algorithm>
#include <set>
#include <unordered_set>

#include "geometry/loops.h"
#include "geometry/polygon.h"
#include "geometry/tidy.h"

namespace talus {
namespace {

class EdgeCloser {
 public:
  EdgeCloser(Loops& loops, const LengthAt& least, const std::vector<Polyline>& kept);
  long run();

 private:
  enum Rank { free_point, on_trace, on_side, kept_point };

  struct Short {
    double length;
    int p, q;
    auto operator<=>(const Short&) const = default;
  };

  void add_if_short(int p, int q);
  bool is_edge(int p, int q) const;
  bool is_side(int p, int q) const { return sides_.contains(directed(p, q)) || sides_.contains(directed(q, p)); }
  bool close(int p, int q);
  bool replace(int gone, int stays, const Vec2& at);

  Loops& loops_;
  const LengthAt& least_;
  std::vector<Rank> rank_;
  std::vector<std::vector<int>> cells_;  // by point
  std::unordered_set<std::uint64_t> sides_;
  std::set<Short> short_;
};

EdgeCloser::EdgeCloser(Loops& loops, const LengthAt& least, const std::vector<Polyline>& kept)
    : loops_(loops), least_(least), rank_(loops.points().size(), free_point), cells_(loops.points().size()) {
  const auto raise = [this](int p, Rank rank) { rank_[p] = std::max(rank_[p], rank); };
  for (int c = 0; c < loops_.size(); ++c) {
    const Loop& loop = loops_[c];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int p = loop[k].point, q = loop[(k + 1) % loop.size()].point;
      cells_[p].push_back(c);
      if (loop[k].trace == on_boundary) sides_.insert(directed(p, q));
      for (int end : {p, q})
        raise(end, loop[k].trace == on_boundary ? on_side : loop[k].trace >= 0 ? on_trace : free_point);
      add_if_short(p, q);
    }
  }
  std::set<std::pair<double, double>> given;
  for (const Polyline& line : kept)
    for (const Vec2& p : line) given.insert({p.x(), p.y()});
  for (std::size_t p = 0; p < rank_.size(); ++p)
    if (given.contains({loops_.points()[p].x(), loops_.points()[p].y()})) rank_[p] = kept_point;
}

void EdgeCloser::add_if_short(int p, int q) {
  const Vec2 a = loops_.points()[p], b = loops_.points()[q];
  if ((b - a).norm() < least_((a + b) / 2)) short_.insert({(b - a).norm(), std::min(p, q), std::max(p, q)});
}

bool EdgeCloser::is_edge(int p, int q) const {
  return std::any_of(cells_[p].begin(), cells_[p].end(), [&](int c) {
    const Loop& loop = loops_[c];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int from = loop[k].point, to = loop[(k + 1) % loop.size()].point;
      if ((from == p && to == q) || (from == q && to == p)) return true;
    }
    return false;
  });
}

// Two points of the boundary may become one only along it, or a block would be pinched.
bool EdgeCloser::close(int p, int q) {
  if (rank_[p] < rank_[q]) std::swap(p, q);
  if (rank_[q] == kept_point || (rank_[q] == on_side && !is_side(p, q))) return false;
  const Vec2 a = loops_.points()[p], b = loops_.points()[q];
  if (rank_[p] == free_point && replace(q, p, (a + b) / 2)) return true;
  return replace(q, p, a) || (rank_[p] == rank_[q] && replace(p, q, b));
}

// Puts `stays` at a place and `gone` onto it, if all cells round the two stay simple.
bool EdgeCloser::replace(int gone, int stays, const Vec2& at) {
  std::vector<int> round = cells_[gone];
  round.insert(round.end(), cells_[stays].begin(), cells_[stays].end());
  std::sort(round.begin(), round.end());
  round.erase(std::unique(round.begin(), round.end()), round.end());
  const Vec2 before = loops_.points()[stays];
  loops_.points()[stays] = at;
  std::vector<Loop> changed;
  bool good = true;
  for (int c : round) {
    Loop loop = loops_[c];
    for (std::size_t k = 0; k < loop.size(); ++k) {  // of the closed edge the corner goes that it leaves
      const int next = loop[(k + 1) % loop.size()].point;
      const bool closed = (loop[k].point == gone && next == stays) || (loop[k].point == stays && next == gone);
      if (!closed) continue;
      loop.erase(loop.begin() + static_cast<long>(k));
      break;
    }
    int times = 0;
    for (Corner& corner : loop) {
      if (corner.point == gone) corner.point = stays;
      times += corner.point == stays;
    }
    good = good && loop.size() >= 3 && times <= 1 && !defect(loops_.outline(loop));
    changed.push_back(std::move(loop));
  }
  if (!good) {
    loops_.points()[stays] = before;
    return false;
  }
  for (std::size_t i = 0; i < round.size(); ++i) {
    loops_[round[i]] = std::move(changed[i]);
    const Loop& loop = loops_[round[i]];
    for (std::size_t k = 0; k < loop.size(); ++k)
      if (loop[k].trace == on_boundary) sides_.insert(directed(loop[k].point, loop[(k + 1) % loop.size()].point));
  }
  for (int c : round)
    for (std::size_t k = 0; k < loops_[c].size(); ++k) {
      const int p = loops_[c][k].point, q = loops_[c][(k + 1) % loops_[c].size()].point;
      if (p == stays || q == stays) add_if_short(p, q);
    }
  cells_[stays] = std::move(round);
  cells_[gone].clear();
  return true;
}

// Entries whose points have moved since are out of date: what is short now has an entry of its own.
long EdgeCloser::run() {
  long closed = 0;
  while (!short_.empty()) {
    const auto [length, p, q] = *short_.begin();
    short_.erase(short_.begin());
    if ((loops_.points()[p] - loops_.points()[q]).norm() == length && is_edge(p, q)) closed += close(p, q);
  }
  return closed;
}

}  // namespace

long close_short_edges(Tessellation& t, const LengthAt& least, const std::vector<Polyline>& kept) {
  Loops loops(t);
  const long closed = EdgeCloser(loops, least, kept).run();
  if (closed > 0) t = loops.tessellation();
  return closed;
}

}  // namespace talus
