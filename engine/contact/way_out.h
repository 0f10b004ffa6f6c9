#pragma once
// By which face two blocks that lie in each other part the shortest way: of convex polygons one of all faces has the
// other in front of it, or the one that it is least deep below is the way out (separating axes, Gottschalk 1996).
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/convex_parts.h"
#include "geometry/vec2.h"

namespace talus {

struct WayOut {
  int of = 0, face = 0;                                   // a face of the first block or of the second
  int corner = 0;                                         // of the other one, the deepest below it
  double gap = -std::numeric_limits<double>::infinity();  // m, negative
};

// `corners`: how many each block has. gap(of, face, corner), m, of a corner of the other block in front of a face.
// Nothing where a face shows that they lie in each other by no more than `enough`, m.
template <class Gap>
std::optional<WayOut> way_out(const std::array<int, 2>& corners, double enough, const Gap& gap) {
  WayOut least;
  for (const int of : {1, 0})
    for (int face = 0; face < corners[size_t(of)]; ++face) {
      WayOut below{of, face, 0, std::numeric_limits<double>::infinity()};
      for (int v = 0; v < corners[size_t(1 - of)]; ++v)
        if (const double g = gap(of, face, v); g < below.gap) below.corner = v, below.gap = g;
      if (below.gap >= -enough) return {};
      if (below.gap > least.gap) least = below;
    }
  return least;
}

// A convex part of a block, or, without one, all of it.
struct PartOf {
  const ConvexPart* part;
  int corners;  // of the block
  int size() const { return part ? int(part->size()) : corners; }
  int corner(int k) const { return part ? (*part)[size_t(k) % part->size()] : k % corners; }
  // a side of the block, not one within it
  bool own(int side) const { return corner(side + 1) == (corner(side) + 1) % corners; }
};

// Of blocks that are not both convex, by the parts of them that lie in each other the deepest. A side of a part that
// lies within its block leads out of nothing: where that is the least deep one, the part beside it tells. `parts`: none
// of a convex block. place(of, corner), m.
template <class Place>
std::optional<WayOut> way_out(const std::array<const std::vector<ConvexPart>*, 2>& parts,
                              const std::array<int, 2>& corners, double enough, const Place& place) {
  const auto part = [&](int of, size_t k) {
    return PartOf{parts[size_t(of)] ? &(*parts[size_t(of)])[k] : nullptr, corners[size_t(of)]};
  };
  const auto count = [&](int of) { return parts[size_t(of)] ? parts[size_t(of)]->size() : 1; };
  const auto box = [&](int of, size_t k) {
    const PartOf at = part(of, k);
    std::pair<Vec2, Vec2> ends(place(of, at.corner(0)), place(of, at.corner(0)));
    for (int v = 1; v < at.size(); ++v) {
      ends.first = ends.first.cwiseMin(place(of, at.corner(v)));
      ends.second = ends.second.cwiseMax(place(of, at.corner(v)));
    }
    return ends;
  };
  std::optional<WayOut> deepest;
  for (size_t a = 0; a < count(0); ++a) {
    const auto [low, high] = box(0, a);
    for (size_t b = 0; b < count(1); ++b) {
      if (const auto [from, to] = box(1, b);
          (from.array() > high.array() - enough).any() || (low.array() > to.array() - enough).any())
        continue;
      const std::array both{part(0, a), part(1, b)};
      auto out = way_out({both[0].size(), both[1].size()}, enough, [&](int of, int face, int v) {
        const Vec2 from = place(of, both[size_t(of)].corner(face)),
                   side = place(of, both[size_t(of)].corner(face + 1)) - from;
        return cross(place(1 - of, both[size_t(1 - of)].corner(v)) - from, side) / side.norm();
      });
      if (!out || (deepest && deepest->gap <= out->gap) || !both[size_t(out->of)].own(out->face)) continue;
      out->face = both[size_t(out->of)].corner(out->face);
      out->corner = both[size_t(1 - out->of)].corner(out->corner);
      deepest = out;
    }
  }
  return deepest;
}

}  // namespace talus
