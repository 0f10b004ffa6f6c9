// What can be wrong with regions, said before any block is made.
#include <algorithm>
#include <cstdio>
#include <numeric>

#include "geometry/polygon.h"
#include "scene/build_parts.h"

namespace talus {

namespace {

struct Box {
  Vec2 low, high;
};

Box box_of(const Polyline& polygon) {
  Box box{polygon[0], polygon[0]};
  for (const Vec2& p : polygon) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string pair_text(const Vec2& p) { return "(" + number(p.x()) + ", " + number(p.y()) + ")"; }

void check_outline(Polyline& outline, const Place& place, const std::string& field) {
  if (const auto reason = defect(outline)) throw InputError(place, field, "a simple polygon", *reason);
  if (signed_area(outline) < 0) std::reverse(outline.begin(), outline.end());
}

void check_holes(Region& region) {
  const std::string owner = "region \"" + region.name + "\"";
  for (size_t h = 0; h < region.holes.size(); ++h) {
    Hole& hole = region.holes[h];
    const Place& place = hole.place.file.empty() ? region.place : hole.place;
    const std::string field = "hole \"" + hole.name + "\" of " + owner;
    check_outline(hole.outline, place, field);
    for (const Vec2& p : hole.outline)
      if (!contains(region.outlines[0], p))
        throw InputError(place, field, "a hole inside the region's outline", "a corner at " + pair_text(p) + " outside");
    const double shared = overlap_area(region.outlines[0], hole.outline), own = signed_area(hole.outline);
    if (shared < own * (1 - 1e-9))
      throw InputError(place, field, "a hole inside the region's outline",
                       number(100 * (1 - shared / own)) + " % of its area outside");
    for (size_t other = 0; other < h; ++other)
      if (overlap_area(region.holes[other].outline, hole.outline) > 0)
        throw InputError(place, field, "holes that do not overlap", "an overlap with hole \"" + region.holes[other].name + "\"");
  }
}

// Two outlines may share an edge, not area: an overlap of 1e-6 of the smaller one is taken for rounding of
// coordinates typed by hand. Sorted by their left ends, so that only near neighbours are compared.
void check_overlaps(const Scene& scene) {
  struct Piece {
    const Region* region;
    const Polyline* outline;
    Box box;
  };
  std::vector<Piece> pieces;
  for (const Region& region : scene.regions)
    for (const Polyline& outline : region.outlines) pieces.push_back({&region, &outline, box_of(outline)});
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.box.low.x() < b.box.low.x(); });
  for (size_t a = 0; a < pieces.size(); ++a) {
    for (size_t b = a + 1; b < pieces.size() && pieces[b].box.low.x() < pieces[a].box.high.x(); ++b) {
      const Vec2 shared = pieces[a].box.high.cwiseMin(pieces[b].box.high) - pieces[a].box.low.cwiseMax(pieces[b].box.low);
      const double smaller = std::min(signed_area(*pieces[a].outline), signed_area(*pieces[b].outline));
      if (shared.minCoeff() <= 0 || shared.prod() < 1e-6 * smaller) continue;
      const double area = overlap_area(*pieces[a].outline, *pieces[b].outline);
      if (area <= 1e-6 * smaller) continue;
      const bool later = pieces[a].region < pieces[b].region;
      const Region& second = later ? *pieces[b].region : *pieces[a].region;
      const Region& first = later ? *pieces[a].region : *pieces[b].region;
      throw InputError(second.place, "region \"" + second.name + "\"", "regions that do not overlap",
                       &first == &second ? "two of its own blocks overlapping by " + number(area) + " m2"
                                         : "an overlap of " + number(area) + " m2 with region \"" + first.name + "\"");
    }
  }
}

}  // namespace

void check_regions(Scene& scene) {
  if (scene.regions.empty()) throw InputError(scene.time.place, "regions", "at least one region", "none");
  for (Region& region : scene.regions) {
    const std::string field = "outline of region \"" + region.name + "\"";
    for (size_t i = 0; i < region.outlines.size(); ++i)
      check_outline(region.outlines[i], region.place, region.outlines.size() == 1 ? field : field + ", block " + std::to_string(i + 1));
    check_holes(region);
  }
  check_overlaps(scene);
}

}  // namespace talus
