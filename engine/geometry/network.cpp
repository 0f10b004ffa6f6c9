#include "geometry/network.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>

#include "geometry/polygon.h"
#include "geometry/segment_grid.h"

namespace talus {
namespace {

constexpr double least_tolerance = 1e-9;  // of the outline's extent
constexpr int most_rounds = 12;           // of splitting; two or three are the rule

// Points, of which those nearer to each other than the tolerance are one.
class WeldedPoints {
 public:
  WeldedPoints(const Vec2& origin, double tolerance) : origin_(origin), tolerance_(tolerance) {}

  const std::vector<Vec2>& all() const { return points_; }

  int add(const Vec2& p) {
    const int index = static_cast<int>(points_.size());
    points_.push_back(p);
    const auto [x, y] = bin(p);
    bins_[key(x, y)].push_back(index);
    return index;
  }

  // The nearest point within the tolerance that `accept(index)` agrees to, or -1.
  template <class Accept>
  int find(const Vec2& p, const Accept& accept) const {
    int nearest = -1;
    double least = tolerance_;
    const auto [x, y] = bin(p);
    for (std::int64_t i = x - 1; i <= x + 1; ++i)
      for (std::int64_t j = y - 1; j <= y + 1; ++j) {
        const auto found = bins_.find(key(i, j));
        if (found == bins_.end()) continue;
        for (int candidate : found->second) {
          const double distance = (points_[candidate] - p).norm();
          if (distance > least || (distance == least && nearest >= 0) || !accept(candidate)) continue;
          least = distance;
          nearest = candidate;
        }
      }
    return nearest;
  }
  int find(const Vec2& p) const {
    return find(p, [](int) { return true; });
  }

 private:
  std::pair<std::int64_t, std::int64_t> bin(const Vec2& p) const {
    const Vec2 scaled = (p - origin_) / tolerance_;
    return {std::llround(scaled.x()), std::llround(scaled.y())};
  }
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fu;
  }

  Vec2 origin_;
  double tolerance_;
  std::vector<Vec2> points_;
  std::unordered_map<std::uint64_t, std::vector<int>> bins_;  // two bins of one key share a list: harmless
};

double round_off_of(const Bounds& box) {
  const double largest = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
  return 4 * std::numeric_limits<double>::epsilon() * largest;
}

class NetworkMaker {
 public:
  NetworkMaker(const TessellationInput& input, double tolerance);
  std::optional<Network> make();

 private:
  using Edge = Network::Edge;
  struct Split {
    int edge;
    double t;
    int point;
  };

  void add_boundary(const Polyline& loop);
  void add_trace(const Polyline& trace, int id);
  std::vector<SegmentGrid::Segment> segments() const;
  Vec2 moved_onto_boundary(const Vec2& p) const;
  int place(const Vec2& p);
  int place_on_boundary(const Vec2& p, const Edge& edge);
  bool passes_through(const Edge& e, int p) const;
  bool split_once();
  void split_at_points(const SegmentGrid& grid, std::vector<Split>& splits) const;
  void split_at_crossings(const SegmentGrid& grid, std::vector<Split>& splits);
  void split_edges(std::vector<Split>& splits);
  void drop_doubles();
  void drop_outside();
  void drop_unused_points(Network& network) const;

  const Vec2& point(int i) const { return points_.all()[i]; }
  double distance(const Edge& e, const Vec2& p) const { return distance_to_segment(point(e.p), point(e.q), p); }

  const TessellationInput& input_;
  Bounds box_;
  double round_off_, tolerance_;
  WeldedPoints points_;
  int boundary_points_ = 0;
  std::vector<Edge> edges_;
  std::vector<SegmentGrid::Segment> boundary_;
  SegmentGrid boundary_grid_;
};

NetworkMaker::NetworkMaker(const TessellationInput& input, double tolerance)
    : input_(input),
      box_(bounds(input.outline)),
      round_off_(round_off_of(box_)),
      tolerance_(tolerance),
      points_(box_.min, tolerance_),
      boundary_grid_({}, tolerance_) {
  add_boundary(input.outline);
  for (const Polyline& hole : input.holes) add_boundary(hole);
  boundary_points_ = static_cast<int>(points_.all().size());
  boundary_ = segments();
  boundary_grid_ = SegmentGrid(boundary_, tolerance_);
  for (std::size_t id = 0; id < input.traces.size(); ++id) add_trace(input.traces[id], static_cast<int>(id));
}

void NetworkMaker::add_boundary(const Polyline& loop) {
  const int first = static_cast<int>(points_.all().size()), size = static_cast<int>(loop.size());
  for (const Vec2& p : loop) points_.add(p);
  for (int i = 0; i < size; ++i) edges_.push_back({first + i, first + (i + 1) % size, -1});
}

// Far parts of a trace are clipped away first: they would coarsen every grid.
void NetworkMaker::add_trace(const Polyline& trace, int id) {
  for (const Vec2& p : trace)
    if (!p.allFinite())
      throw std::invalid_argument("trace " + std::to_string(id + 1) + " has a point that is not finite");
  Bounds wide = box_;
  wide.min.array() -= box_.extent();
  wide.max.array() += box_.extent();
  for (std::size_t i = 0; i + 1 < trace.size(); ++i) {
    const Vec2 along = trace[i + 1] - trace[i];
    const auto part = clip_to_box(trace[i], along, 0, 1, wide);
    if (!part) continue;
    const Vec2 from = part->first > 0 ? Vec2(trace[i] + part->first * along) : trace[i];
    const Vec2 to = part->second < 1 ? Vec2(trace[i] + part->second * along) : trace[i + 1];
    const int p = place(from), q = place(to);
    if (p != q) edges_.push_back({p, q, id});
  }
}

std::vector<SegmentGrid::Segment> NetworkMaker::segments() const {
  std::vector<SegmentGrid::Segment> list;
  list.reserve(edges_.size());
  for (const Edge& e : edges_) list.push_back({point(e.p), point(e.q)});
  return list;
}

// A point on the boundary but for the tolerance is moved onto it; one that is there but for round-off stays.
Vec2 NetworkMaker::moved_onto_boundary(const Vec2& p) const {
  double least = tolerance_;
  Vec2 nearest = p;
  for (int i : boundary_grid_.near(p)) {
    const auto& [a, b] = boundary_[i];
    const double distance = distance_to_segment(a, b, p);
    if (distance > least) continue;
    least = distance;
    const Vec2 along = b - a;
    nearest = distance <= round_off_ ? p : Vec2(a + along * ((p - a).dot(along) / along.squaredNorm()));
  }
  return nearest;
}

int NetworkMaker::place(const Vec2& p) {
  if (const int known = points_.find(p); known >= 0) return known;
  const Vec2 moved = moved_onto_boundary(p);
  if (const int known = points_.find(moved); known >= 0) return known;
  return points_.add(moved);
}

// The boundary takes up only points that are on it, or it would be bent.
int NetworkMaker::place_on_boundary(const Vec2& p, const Edge& edge) {
  const int known = points_.find(p, [&](int i) { return distance(edge, point(i)) <= round_off_; });
  return known >= 0 ? known : points_.add(p);
}

// Whether edge e is to be led through point p. A trace is not bent to a point beside its end: the two were
// kept apart because they lie on different edges of the boundary, and it would be bent to and fro for ever.
bool NetworkMaker::passes_through(const Edge& e, int p) const {
  const double off = distance(e, point(p));
  if (off <= round_off_) return true;
  if (e.trace < 0 || off > tolerance_) return false;
  return (point(p) - point(e.p)).norm() > tolerance_ && (point(p) - point(e.q)).norm() > tolerance_;
}

void NetworkMaker::split_at_points(const SegmentGrid& grid, std::vector<Split>& splits) const {
  for (int i = 0; i < static_cast<int>(points_.all().size()); ++i)
    for (int index : grid.near(point(i))) {
      const Edge& e = edges_[index];
      const bool boundary_on_boundary = e.trace < 0 && i < boundary_points_;
      if (i == e.p || i == e.q || boundary_on_boundary || !passes_through(e, i)) continue;
      const Vec2 along = point(e.q) - point(e.p);
      const double t = (point(i) - point(e.p)).dot(along) / along.squaredNorm();
      if (t > 0 && t < 1) splits.push_back({index, t, i});
    }
}

// Proper crossings. A pair where one edge ends on the other is split there by split_at_points. The point is
// taken on the first edge of a pair, the one of the boundary if any, so that it lies on the boundary.
void NetworkMaker::split_at_crossings(const SegmentGrid& grid, std::vector<Split>& splits) {
  for (const auto& [i, j] : grid.pairs()) {
    const Edge e = edges_[i], f = edges_[j];
    if ((e.trace < 0 && f.trace < 0) || e.p == f.p || e.p == f.q || e.q == f.p || e.q == f.q) continue;
    const Vec2 a = point(e.p), along_e = point(e.q) - a, c = point(f.p), along_f = point(f.q) - c;
    const double c_side = cross(along_e, c - a), d_side = cross(along_e, c + along_f - a);
    const double a_side = cross(along_f, a - c), b_side = cross(along_f, a + along_e - c);
    if ((c_side > 0) == (d_side > 0) || (a_side > 0) == (b_side > 0)) continue;
    if (passes_through(e, f.p) || passes_through(e, f.q) || passes_through(f, e.p) || passes_through(f, e.q)) continue;
    const double t_e = a_side / (a_side - b_side), t_f = c_side / (c_side - d_side);
    const Vec2 at = a + t_e * along_e;
    if (distance(f, at) > tolerance_) continue;  // on one line, beside each other: the sides are round-off
    const int crossing = e.trace < 0 ? place_on_boundary(at, e) : place(at);
    splits.push_back({i, t_e, crossing});
    splits.push_back({j, t_f, crossing});
  }
}

void NetworkMaker::split_edges(std::vector<Split>& splits) {
  std::sort(splits.begin(), splits.end(), [](const Split& s, const Split& t) {
    return std::tie(s.edge, s.t, s.point) < std::tie(t.edge, t.t, t.point);
  });
  std::vector<Edge> parts;
  auto split = splits.begin();
  for (int i = 0; i < static_cast<int>(edges_.size()); ++i) {
    int from = edges_[i].p;
    const auto step_to = [&](int to) {
      if (from != to) parts.push_back({from, to, edges_[i].trace});
      from = to;
    };
    for (; split != splits.end() && split->edge == i; ++split) step_to(split->point);
    step_to(edges_[i].q);
  }
  edges_ = std::move(parts);
}

// Splits every edge where another ends on it or crosses it. Bending an edge to a point can, rarely, make it
// meet a further one: the caller repeats until nothing is split.
bool NetworkMaker::split_once() {
  const SegmentGrid grid(segments(), 2 * tolerance_);
  std::vector<Split> splits;
  split_at_points(grid, splits);
  split_at_crossings(grid, splits);
  if (splits.empty()) return false;
  split_edges(splits);
  drop_doubles();
  return true;
}

// Of edges that coincide the one of the boundary or of the lowest trace stays; the order is kept. Two edges of
// the boundary, the sides of a crack that is closed but for round-off, bound nothing.
void NetworkMaker::drop_doubles() {
  struct Key {
    int low, high, trace, index;
  };
  std::vector<Key> keys;
  for (int i = 0; i < static_cast<int>(edges_.size()); ++i) {
    const Edge& e = edges_[i];
    keys.push_back({std::min(e.p, e.q), std::max(e.p, e.q), e.trace, i});
  }
  std::sort(keys.begin(), keys.end(), [](const Key& k, const Key& l) {
    return std::tie(k.low, k.high, k.trace, k.index) < std::tie(l.low, l.high, l.trace, l.index);
  });
  std::vector<bool> keep(edges_.size(), false);
  for (auto first = keys.begin(), last = first; first != keys.end(); first = last) {
    last = std::find_if(first, keys.end(), [&](const Key& k) { return k.low != first->low || k.high != first->high; });
    const auto first_trace = std::find_if(first, last, [](const Key& k) { return k.trace >= 0; });
    const bool on_boundary = (first_trace - first) % 2 == 1;
    if (on_boundary) keep[first->index] = true;
    if (!on_boundary && first_trace != last) keep[first_trace->index] = true;
  }
  std::vector<Edge> kept;
  for (std::size_t i = 0; i < edges_.size(); ++i)
    if (keep[i]) kept.push_back(edges_[i]);
  edges_ = std::move(kept);
}

void NetworkMaker::drop_outside() {
  std::erase_if(edges_, [&](const Edge& e) {
    if (e.trace < 0) return false;
    const Vec2 middle = point(e.p) + (point(e.q) - point(e.p)) / 2;
    return !contains(input_.outline, middle) ||
           std::any_of(input_.holes.begin(), input_.holes.end(),
                       [&](const Polyline& hole) { return contains(hole, middle); });
  });
}

void NetworkMaker::drop_unused_points(Network& network) const {
  std::vector<int> index(points_.all().size(), -1);
  for (int i = 0; i < boundary_points_; ++i) index[i] = 0;
  for (const Edge& e : edges_) index[e.p] = index[e.q] = 0;
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (index[i] < 0) continue;
    index[i] = static_cast<int>(network.points.size());
    network.points.push_back(points_.all()[i]);
  }
  for (const Edge& e : edges_) network.edges.push_back({index[e.p], index[e.q], e.trace});
}

std::optional<Network> NetworkMaker::make() {
  drop_doubles();
  int round = 0;
  while (split_once())
    if (++round == most_rounds) return std::nullopt;
  drop_outside();
  Network network;
  network.boundary_points = boundary_points_;
  network.tolerance = tolerance_;
  drop_unused_points(network);
  return network;
}

}  // namespace

double boundary_clearance(const TessellationInput& input, double most) {
  struct Edge {
    const Polyline* loop;
    std::size_t from, to;
  };
  std::vector<Edge> edges;
  std::vector<SegmentGrid::Segment> segments;
  const auto add = [&](const Polyline& loop) {
    for (std::size_t to = 0, from = loop.size() - 1; to < loop.size(); from = to++) {
      edges.push_back({&loop, from, to});
      segments.push_back({loop[from], loop[to]});
    }
  };
  add(input.outline);
  for (const Polyline& hole : input.holes) add(hole);
  const SegmentGrid grid(segments, most);
  for (const auto& [loop, from, to] : edges)  // each point once, as the start of its edge
    for (int i : grid.near((*loop)[from])) {
      const bool ends_here = edges[i].loop == loop && (edges[i].from == from || edges[i].to == from);
      if (!ends_here) most = std::min(most, distance_to_segment(segments[i].a, segments[i].b, (*loop)[from]));
    }
  return most;
}

Network make_network(const TessellationInput& input, double tolerance) {
  const Bounds box = bounds(input.outline);
  const double fine = least_tolerance * box.extent();
  tolerance = std::max(tolerance, fine);
  const double clearance = boundary_clearance(input, 3 * tolerance), round_off = round_off_of(box);
  if (clearance < 8 * round_off)
    throw std::invalid_argument("the boundary comes closer to itself than round-off allows");
  const double bound = clearance / 3;
  for (double attempt : {tolerance, fine, 8 * fine, 64 * fine, 512 * fine})
    if (auto network = NetworkMaker(input, std::min(attempt, bound)).make()) return *std::move(network);
  throw std::invalid_argument("the traces lie too close to each other to be told apart");
}

}  // namespace talus
