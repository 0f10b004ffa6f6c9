#include "scene/slivers.h"

#include <cmath>
#include <cstdio>

#include "geometry/polygon.h"
#include "geometry/tidy.h"

namespace talus {

namespace {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string counted(long count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// The wanted size of a mesh; of blocks cut by joints alone, that of the mean block.
LengthAt size_of(const Region& region, const Tessellation& t) {
  const Mesh& mesh = region.mesh;
  if (mesh.size_at) return mesh.size_at;
  if (mesh.kind != MeshKind::none) return [size = mesh.size](const Vec2&) { return size; };
  double area = signed_area(region.outlines[0]);
  for (const Hole& hole : region.holes) area -= signed_area(hole.outline);
  return [size = std::sqrt(area / double(t.cells.size()))](const Vec2&) { return size; };
}

std::string thinnest_text(const SliverCount& count, const Vec2& origin) {
  const Vec2 at = count.where + origin;
  char text[96];
  std::snprintf(text, sizeof text, "the thinnest %.3g m at (%.6g, %.6g)", count.thickness, at.x(), at.y());
  return text;
}

void merge(const Region& region, const LengthAt& least, const std::string& limit, Tessellation& t,
           std::vector<std::string>& notes) {
  std::vector<Polyline> kept{region.outlines[0]};
  for (const Hole& hole : region.holes) kept.push_back(hole.outline);
  constexpr int most_rounds = 4;  // closing an edge can make a block thin: two rounds are the rule
  long merged = 0, closed = 0;
  for (long before = -1, round = 0; round < most_rounds && merged + closed != before; ++round) {
    before = merged + closed;
    merged += merge_slivers(t, least, true);
    closed += close_short_edges(t, least, kept);
  }
  if (merged + closed == 0) return;
  notes.push_back("region \"" + region.name + "\": " + counted(merged, "sliver") + " thinner than " + limit +
                  " merged into a neighbour, " + counted(closed, "shorter edge") + " closed");
}

}  // namespace

void treat_slivers(const Region& region, const Vec2& origin, Tessellation& t, std::vector<std::string>& notes) {
  const MeshKind kind = region.mesh.kind;
  const bool pattern = kind == MeshKind::cross || kind == MeshKind::diagonal || kind == MeshKind::alternating;
  if (pattern || region.sliver_part <= 0 || t.cells.size() < 2) return;
  const LengthAt size = size_of(region, t);
  const LengthAt least = [&](const Vec2& p) { return region.sliver_part * size(p); };
  const std::string part =
      short_number(region.sliver_part) + (kind == MeshKind::none ? " of the mean block size" : " of the mesh size");
  const std::string limit =
      region.mesh.size_at ? part : short_number(least(region.outlines[0][0])) + " m (" + part + ")";
  if (region.slivers == Slivers::merge && kind != MeshKind::triangles) merge(region, least, limit, t, notes);
  const SliverCount left = count_slivers(t, least);
  if (left.cells == 0) return;
  if (region.slivers == Slivers::refuse)
    throw InputError(region.place, "region \"" + region.name + "\"", "no block thinner than " + limit,
                     counted(left.cells, "sliver") + ", " + thinnest_text(left, origin) +
                         (kind == MeshKind::triangles ? "" : "; slivers = \"merge\" joins them to a neighbour"));
  notes.push_back("region \"" + region.name + "\": " + counted(left.cells, "sliver") + " thinner than " + limit +
                  " left, " + thinnest_text(left, origin));
}

}  // namespace talus
