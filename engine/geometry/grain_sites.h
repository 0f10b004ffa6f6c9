#pragma once
// Where grains grow from: the sites of a Voronoi mesh. Internal to engine/geometry.
#include <vector>

#include "geometry/network.h"
#include "geometry/size_field.h"

namespace talus {

struct GrainSite {
  Vec2 at;             // of the frame
  double size;         // wanted, of the frame
  bool fixed = false;  // of a pair beside the boundary or a trace: the grains' border lies on it
  bool ghost = false;  // mirrored to the outside: grows no grain
};

// The region in the mesh's frame.
struct GrainDomain {
  Polyline outline;
  std::vector<Polyline> holes;
  Network network;

  bool holds(const Vec2& point) const;
};

// Along the boundary and the traces sites in pairs, mirrored at them, so that grains end there by themselves;
// round their corners, ends and crossings rings of sites, whose grains meet in that point. In between at random,
// none closer to another than 0.79 of the size (dart throwing till no place is left). The mean area of a grain is
// the square of the size but for some per cent. Throws std::length_error where more than `most` would be made.
std::vector<GrainSite> grain_sites(const GrainDomain& domain, const SizeField& size, unsigned seed, long most);

}  // namespace talus
