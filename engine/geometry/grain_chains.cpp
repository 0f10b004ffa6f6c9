#include "geometry/grain_chains.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

// rad. Circles are drawn with twelve sides: corners of 30° are not left to round-off.
constexpr double smooth = 31 * M_PI / 180;
// Of an interval: a station so near a corner is at it, and between its edges. Those of regular polygons often are.
constexpr double at_corner = 1e-6;

class ChainMaker {
 public:
  explicit ChainMaker(const Network& network);
  std::vector<GrainChain> make();

 private:
  int other_end(int edge, int point) const {
    return network_.edges[edge].p == point ? network_.edges[edge].q : network_.edges[edge].p;
  }
  bool passes(int point) const;
  void walk(int start, int edge);

  const Network& network_;
  std::vector<std::vector<int>> edges_at_;
  std::vector<char> taken_;
  std::vector<GrainChain> chains_;
};

ChainMaker::ChainMaker(const Network& network)
    : network_(network), edges_at_(network.points.size()), taken_(network.edges.size(), false) {
  for (std::size_t e = 0; e < network.edges.size(); ++e)
    for (int p : {network.edges[e].p, network.edges[e].q}) edges_at_[p].push_back(static_cast<int>(e));
}

// Whether a chain goes on through this point.
bool ChainMaker::passes(int point) const {
  const std::vector<int>& edges = edges_at_[point];
  if (edges.size() != 2) return false;
  if ((network_.edges[edges[0]].trace < 0) != (network_.edges[edges[1]].trace < 0)) return false;
  const Vec2 in = network_.points[point] - network_.points[other_end(edges[0], point)];
  const Vec2 out = network_.points[other_end(edges[1], point)] - network_.points[point];
  return std::abs(std::atan2(cross(in, out), in.dot(out))) < smooth;
}

void ChainMaker::walk(int start, int edge) {
  GrainChain& chain = chains_.emplace_back();
  chain.boundary = network_.edges[edge].trace < 0;
  chain.points.push_back(start);
  for (int at = start;;) {
    taken_[edge] = true;
    at = other_end(edge, at);
    chain.points.push_back(at);
    chain.cornerless = at == start && passes(at);
    if (at == start || !passes(at)) return;
    edge = edges_at_[at][0] == edge ? edges_at_[at][1] : edges_at_[at][0];
  }
}

std::vector<GrainChain> ChainMaker::make() {
  for (int p = 0; p < static_cast<int>(edges_at_.size()); ++p)
    for (int e : edges_at_[p])
      if (!taken_[e] && !passes(p)) walk(p, e);
  for (std::size_t e = 0; e < taken_.size(); ++e)  // closed curves without a corner
    if (!taken_[e]) walk(network_.edges[e].p, static_cast<int>(e));
  return std::move(chains_);
}

}  // namespace

std::vector<GrainChain> grain_chains(const Network& network) {
  return ChainMaker(network).make();
}

std::vector<ChainStation> stations(const GrainChain& chain, const std::vector<Vec2>& points, const SizeField& size) {
  const std::size_t edges = chain.points.size() - 1;
  std::vector<double> sum{0};  // wanted intervals up to each point
  for (std::size_t i = 0; i < edges; ++i)
    sum.push_back(sum.back() + size.edges_along(points[chain.points[i]], points[chain.points[i + 1]]));
  // A length of so many sizes and a half shall not be decided by round-off.
  const long count = std::max<long>(chain.cornerless ? 3 : 1, std::lround(sum.back() - 1e-3));
  std::vector<ChainStation> list;
  std::size_t i = 0;
  for (long k = 0; k < count; ++k) {
    const double wanted = sum.back() * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    while (i + 1 < edges && sum[i + 1] < wanted - at_corner) ++i;
    const Vec2 a = points[chain.points[i]], b = points[chain.points[i + 1]];
    const Vec2 at = a + size.where(a, b, wanted - sum[i]) * (b - a);
    Vec2 along = (b - a).normalized();
    if (i + 1 < edges && sum[i + 1] < wanted + at_corner)
      along = (along + (points[chain.points[i + 2]] - b).normalized()).normalized();
    list.push_back({at, along, size.at(at) * sum.back() / static_cast<double>(count)});
  }
  return list;
}

}  // namespace talus
