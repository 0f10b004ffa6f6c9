#pragma once
// By which face two convex blocks that lie in each other part the shortest way: of convex polygons one of all faces has the other in front
// of it, or the one that it is least deep below is the way out (separating axes, Gottschalk 1996).
#include <array>
#include <limits>
#include <optional>

namespace talus {

struct WayOut {
  int of = 0, face = 0;  // a face of the first block or of the second
  int corner = 0;        // of the other one, the deepest below it
  double gap = -std::numeric_limits<double>::infinity();  // m, negative
};

// `corners`: how many each block has. gap(of, face, corner), m, of a corner of the other block in front of a face. Nothing where a face
// shows that they lie in each other by no more than `enough`, m.
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

}  // namespace talus
