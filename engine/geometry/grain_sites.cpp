#include "geometry/grain_sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "geometry/grain_chains.h"
#include "geometry/grain_walls.h"
#include "geometry/random.h"

namespace talus {
namespace {

// Of the size. Dart throwing till no place is left covers 0.547 of the plane with discs of the least distance:
// 0.79 would give 1.12 grains per size², less what the finite number of darts and the rows along boundary and
// traces leave.
constexpr double least_distance = 0.79;
constexpr double least_fixed_distance = 0.5;  // between pairs and rings, where traces come close to each other
// Side of the squares that darts are thrown into, of the size. Not a round part, so that no square of a region
// with round numbers hangs on round-off.
constexpr double dart_square = 0.4123;
constexpr double darts_each = 30;  // a square of the size: 4 % fewer grains than if they were thrown for ever

// Sites by place, in one grid for each power of two of their sizes.
class SiteGrid {
 public:
  void add(const Vec2& at, double size) {
    const int level = std::ilogb(size);
    const auto [x, y] = bin(at, level);
    levels_[level][key(x, y)].push_back({at, size});
  }
  // Whether no site is closer than `part` of its size or of the size given, the smaller.
  bool is_free(const Vec2& at, double size, double part) const {
    for (const auto& [level, bins] : levels_) {
      const double reach = part * std::min(size, std::ldexp(2.0, level));
      const auto [x0, y0] = bin(at - Vec2(reach, reach), level);
      const auto [x1, y1] = bin(at + Vec2(reach, reach), level);
      for (std::int64_t x = x0; x <= x1; ++x)
        for (std::int64_t y = y0; y <= y1; ++y)
          if (const auto found = bins.find(key(x, y)); found != bins.end())
            for (const auto& [place, other] : found->second)
              if ((place - at).norm() < part * std::min(size, other)) return false;
    }
    return true;
  }

 private:
  struct Entry {
    Vec2 at;
    double size;
  };
  static std::pair<std::int64_t, std::int64_t> bin(const Vec2& p, int level) {
    return {static_cast<std::int64_t>(std::floor(std::ldexp(p.x(), -level))),
            static_cast<std::int64_t>(std::floor(std::ldexp(p.y(), -level)))};
  }
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fu;
  }

  std::map<int, std::unordered_map<std::uint64_t, std::vector<Entry>>> levels_;
};

Vec2 mirrored(const Vec2& p, const Vec2& on, const Vec2& along) {
  const Vec2 off = p - on;
  return on + 2 * off.dot(along) * along - off;
}

class SiteMaker {
 public:
  SiteMaker(const GrainDomain& domain, const SizeField& size, unsigned seed, long most);
  std::vector<GrainSite> make();

 private:
  struct Ray {
    double angle, length;  // of the first interval of its chain
    bool boundary;
  };
  struct Dart {
    std::uint64_t rank;
    Vec2 at;
    double size;
  };

  void add_ring(int point, std::vector<Ray>& rays);
  void add_pair(const ChainStation& station, bool boundary);
  bool may_stand(const Vec2& from, const Vec2& at, double size) const;
  void add_fixed(const Vec2& at, double size, bool ghost = false);
  Vec2 nearest_on_boundary(const Vec2& p) const;
  void throw_darts(const Vec2& centre, double half, bool inside, std::uint64_t path);
  void add_darts();

  const GrainDomain& domain_;
  const SizeField& size_;
  unsigned seed_;
  long most_;
  std::vector<GrainChain> chains_;
  std::vector<std::vector<ChainStation>> stations_;
  GrainWalls walls_;
  SiteGrid grid_;
  std::vector<Dart> darts_;
  std::vector<GrainSite> sites_;
};

double longest(const std::vector<std::vector<ChainStation>>& stations) {
  double most = 0;
  for (const auto& list : stations)
    for (const ChainStation& s : list) most = std::max(most, s.length);
  return most;
}

[[noreturn]] void refuse(long most) {
  throw std::length_error("more than " + std::to_string(most) + " grains");
}

// Every interval will have a grain on one side at least.
std::vector<std::vector<ChainStation>> all_stations(const std::vector<GrainChain>& chains, const Network& network,
                                                    const SizeField& size, long most) {
  double intervals = 0;
  for (const auto& [p, q, trace] : network.edges) intervals += size.edges_along(network.points[p], network.points[q]);
  if (intervals > 2 * static_cast<double>(most) + 1000) refuse(most);
  std::vector<std::vector<ChainStation>> list;
  for (const GrainChain& chain : chains) list.push_back(stations(chain, network.points, size));
  return list;
}

SiteMaker::SiteMaker(const GrainDomain& domain, const SizeField& size, unsigned seed, long most)
    : domain_(domain),
      size_(size),
      seed_(seed),
      most_(most),
      chains_(grain_chains(domain.network)),
      stations_(all_stations(chains_, domain.network, size, most)),
      walls_(domain.network, longest(stations_)) {}

bool SiteMaker::may_stand(const Vec2& from, const Vec2& at, double size) const {
  return domain_.holds(at) && !walls_.cross(from + 0.05 * (at - from), at) &&
         grid_.is_free(at, size, least_fixed_distance);
}

// A mirror image may fall into the region again where that is thin: there it would keep room from the grains.
void SiteMaker::add_fixed(const Vec2& at, double size, bool ghost) {
  if (ghost && domain_.holds(at)) return;
  sites_.push_back({at, size, true, ghost});
  if (!ghost) grid_.add(at, size);
}

// Sites at one distance from a point where chains end, so that grains meet there: one for each 90° of a sector
// between two chains, evenly.
void SiteMaker::add_ring(int point, std::vector<Ray>& rays) {
  std::sort(rays.begin(), rays.end(), [](const Ray& r, const Ray& s) { return r.angle < s.angle; });
  const Vec2 centre = domain_.network.points[point];
  double least = rays[0].length;
  for (const Ray& ray : rays) least = std::min(least, ray.length);
  const double radius = least / std::sqrt(2.0);
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const Ray &ray = rays[r], &next = rays[(r + 1) % rays.size()];
    const double sector = next.angle - ray.angle + (r + 1 < rays.size() ? 0 : 2 * M_PI);
    const long count = std::max<long>(1, std::lround(sector / (M_PI / 2) - 1e-3));  // 135° is not decided by round-off
    for (long k = 0; k < count; ++k) {
      const double angle = ray.angle + sector * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
      const Vec2 at = centre + radius * Vec2(std::cos(angle), std::sin(angle));
      if (!may_stand(centre, at, least)) continue;
      add_fixed(at, least);
      const auto mirror = [&](const Ray& side) {
        const Vec2 along(std::cos(side.angle), std::sin(side.angle));
        if (side.boundary) add_fixed(mirrored(at, centre, along), least, true);
      };
      if (k == 0) mirror(ray);
      if (k + 1 == count) mirror(next);
    }
  }
}

void SiteMaker::add_pair(const ChainStation& station, bool boundary) {
  const Vec2 off = station.length / 2 * perp(station.along);
  Vec2 left = station.at + off, right = station.at - off;
  if (boundary && !domain_.holds(left)) std::swap(left, right);
  if (!may_stand(station.at, left, station.length)) return;
  if (!boundary && !may_stand(station.at, right, station.length)) return;
  add_fixed(left, station.length);
  add_fixed(right, station.length, boundary);
}

Vec2 SiteMaker::nearest_on_boundary(const Vec2& p) const {
  Vec2 nearest = p;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const Polyline& loop) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
      const Vec2 along = loop[i] - loop[j];
      const double t = std::clamp((p - loop[j]).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const Vec2 at = loop[j] + t * along;
      if ((at - p).norm() >= least) continue;
      least = (at - p).norm();
      nearest = at;
    }
  };
  look(domain_.outline);
  for (const Polyline& hole : domain_.holes) look(hole);
  return nearest;
}

// Quarters the square until it is small against the size in it; one dart then. The size is asked for inside only.
void SiteMaker::throw_darts(const Vec2& centre, double half, bool inside, std::uint64_t path) {
  Vec2 at = centre;
  if (!inside) {
    const Vec2 near = nearest_on_boundary(centre);
    const bool holds = domain_.holds(centre), whole = (near - centre).norm() > 1.5 * half;
    if (whole && !holds) return;
    inside = whole;
    if (!holds) at = near;
  }
  const double size = size_.at(at);
  if (2 * half > dart_square * size) {
    for (std::uint64_t k = 0; k < 4; ++k)
      throw_darts(centre + half / 2 * Vec2(k & 1 ? 1 : -1, k & 2 ? 1 : -1), half / 2, inside, 4 * path + k + 1);
    return;
  }
  Random random(Random(seed_).next() ^ path);
  const double wanted = darts_each * 4 * half * half / (size * size);
  for (double thrown = random.unit(); thrown < wanted; ++thrown) {
    const Vec2 dart = centre + half * Vec2(random.symmetric(), random.symmetric());
    const std::uint64_t rank = random.next();
    if (inside || domain_.holds(dart)) darts_.push_back({rank, dart, size});
  }
  if (static_cast<double>(darts_.size()) > 1.2 * darts_each * static_cast<double>(most_)) refuse(most_);
}

void SiteMaker::add_darts() {
  const Bounds box = bounds(domain_.outline);
  throw_darts(box.centre(), 0.5 * box.extent(), false, 0);
  std::sort(darts_.begin(), darts_.end(), [](const Dart& d, const Dart& e) { return d.rank < e.rank; });
  for (const Dart& dart : darts_) {
    if (!grid_.is_free(dart.at, dart.size, least_distance)) continue;
    grid_.add(dart.at, dart.size);
    sites_.push_back({dart.at, dart.size});
  }
}

std::vector<GrainSite> SiteMaker::make() {
  std::map<int, std::vector<Ray>> ends;
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    if (chains_[c].cornerless) continue;
    const std::vector<int>& p = chains_[c].points;
    const auto add = [&](int from, int to, double length) {
      const Vec2 along = domain_.network.points[to] - domain_.network.points[from];
      ends[from].push_back({std::atan2(along.y(), along.x()), length, chains_[c].boundary});
    };
    add(p[0], p[1], stations_[c].front().length);
    add(p[p.size() - 1], p[p.size() - 2], stations_[c].back().length);
  }
  for (auto& [point, rays] : ends) add_ring(point, rays);
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    const std::size_t at_ends = chains_[c].cornerless ? 0 : 1;  // there the rings are
    for (std::size_t k = at_ends; k + at_ends < stations_[c].size(); ++k)
      add_pair(stations_[c][k], chains_[c].boundary);
  }
  add_darts();
  const long grains = std::count_if(sites_.begin(), sites_.end(), [](const GrainSite& s) { return !s.ghost; });
  if (grains > most_) throw std::length_error(std::to_string(grains) + " grains");
  return std::move(sites_);
}

}  // namespace

bool GrainDomain::holds(const Vec2& point) const {
  return contains(outline, point) &&
         std::none_of(holes.begin(), holes.end(), [&](const Polyline& hole) { return contains(hole, point); });
}

std::vector<GrainSite> grain_sites(const GrainDomain& domain, const SizeField& size, unsigned seed, long most) {
  return SiteMaker(domain, size, seed, most).make();
}

}  // namespace talus
