#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "geometry/grain_sites.h"
#include "geometry/grain_walls.h"
#include "geometry/tidy.h"

namespace talus {
namespace {

// Lloyd's rounds: after four the thinnest grain of a thousand is 0.4 of the size wide and edges differ less; many
// more would make a honeycomb.
constexpr int rounds = 4;
constexpr double farthest_move = 0.5;  // a round, of the size
// Of the size: what the grains are tidied to, see tessellation.h.
constexpr double thin_grain = 0.25, short_edge = 0.2;
// A frame around all sites, of the region's extent: closes the outermost cells.
constexpr double far_away = 20;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

constexpr int no_site = -1;  // of the frame

Triangulation triangulated(const std::vector<GrainSite>& sites, const GrainDomain& domain) {
  std::vector<std::pair<Kernel::Point_2, int>> points;
  for (std::size_t i = 0; i < sites.size(); ++i)
    points.emplace_back(Kernel::Point_2(sites[i].at.x(), sites[i].at.y()), static_cast<int>(i));
  const Bounds box = bounds(domain.outline);
  for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
    const Vec2 at = box.centre() + far_away * box.extent() * corner;
    points.emplace_back(Kernel::Point_2(at.x(), at.y()), no_site);
  }
  return {points.begin(), points.end()};
}

Vec2 circumcentre(const Triangulation& triangulation, Face face) {
  const Kernel::Point_2 p = triangulation.circumcenter(face);
  return {p.x(), p.y()};
}

// Of the Voronoi cell; nothing where it is open.
std::optional<Vec2> centroid_of_cell(const Triangulation& triangulation, Vertex v) {
  Polyline cell;
  auto face = triangulation.incident_faces(v);
  const auto first = face;
  do {
    if (triangulation.is_infinite(face)) return std::nullopt;
    cell.push_back(circumcentre(triangulation, face));
  } while (++face != first);
  return integrate(cell).centroid;
}

// One round of Lloyd's method for the sites that are not fixed. None moves through a wall.
void relax(std::vector<GrainSite>& sites, const GrainDomain& domain, const GrainWalls& walls) {
  const Triangulation triangulation = triangulated(sites, domain);
  for (const Vertex v : triangulation.finite_vertex_handles()) {
    if (v->info() == no_site || sites[v->info()].fixed) continue;
    GrainSite& site = sites[v->info()];
    const auto centroid = centroid_of_cell(triangulation, v);
    if (!centroid || !centroid->allFinite()) continue;
    Vec2 move = *centroid - site.at;
    const double most = std::min(farthest_move * site.size, walls.reach());
    if (move.norm() > most) move *= most / move.norm();
    if (!walls.cross(site.at, site.at + move)) site.at += move;
  }
}

// The edges between grains; beside the boundary they run on to the outside, so that it alone ends the grains
// there.
std::vector<Polyline> borders(std::vector<GrainSite> sites, const GrainDomain& domain) {
  std::erase_if(sites, [](const GrainSite& site) { return site.ghost; });
  const Triangulation triangulation = triangulated(sites, domain);
  std::vector<Polyline> list;
  for (const auto& [face, i] : triangulation.finite_edges()) {
    const Face other = face->neighbor(i);
    if (triangulation.is_infinite(face) || triangulation.is_infinite(other)) continue;
    const Vec2 a = circumcentre(triangulation, face), b = circumcentre(triangulation, other);
    const auto before = [](const Vec2& p, const Vec2& q) { return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y()); };
    if (a.allFinite() && b.allFinite() && a != b) list.push_back(before(a, b) ? Polyline{a, b} : Polyline{b, a});
  }
  // CGAL lists edges by the addresses of their faces: sorted, they are the same in every run.
  std::sort(list.begin(), list.end(), [](const Polyline& l, const Polyline& m) {
    return std::tuple(l[0].x(), l[0].y(), l[1].x(), l[1].y()) < std::tuple(m[0].x(), m[0].y(), m[1].x(), m[1].y());
  });
  return list;
}

GrainDomain domain_of(const TessellationInput& input, const MeshFrame& frame) {
  const auto local = [&frame](const Polyline& line) {
    Polyline points;
    for (const Vec2& p : line) points.push_back(frame.local(p));
    return points;
  };
  TessellationInput turned{local(input.outline), {}, {}};
  for (const Polyline& hole : input.holes) turned.holes.push_back(local(hole));
  for (const Polyline& trace : input.traces) turned.traces.push_back(local(trace));
  Network network = make_network(turned);
  return {std::move(turned.outline), std::move(turned.holes), std::move(network)};
}

double longest_edge(const GrainDomain& domain, const std::vector<GrainSite>& sites) {
  double most = 0;
  for (const GrainSite& site : sites) most = std::max(most, site.size);
  return std::min(most, bounds(domain.outline).extent());
}

}  // namespace

Tessellation voronoi(const TessellationInput& input, const std::function<double(Vec2)>& size_at, unsigned seed,
                     long most) {
  const MeshFrame frame = MeshFrame::about_first_point(input.outline);
  const SizeField size(frame, size_at);
  const GrainDomain domain = domain_of(input, frame);
  std::vector<GrainSite> sites = grain_sites(domain, size, seed, most);
  const GrainWalls walls(domain.network, farthest_move * longest_edge(domain, sites));
  for (int round = 0; round < rounds; ++round) relax(sites, domain, walls);

  TessellationInput with_borders = input;
  for (const auto& border : borders(sites, domain))
    with_borders.traces.push_back({frame.world(border[0]), frame.world(border[1])});
  Tessellation t = cut(with_borders);
  const int given = static_cast<int>(input.traces.size());
  for (Tessellation::Interface& i : t.interfaces)
    if (i.trace >= given) i.trace = -1;

  std::vector<Polyline> kept = input.holes;
  kept.push_back(input.outline);
  merge_slivers(
      t, [&](const Vec2& p) { return thin_grain * size_at(p); }, false);
  close_short_edges(
      t, [&](const Vec2& p) { return short_edge * size_at(p); }, kept);
  return t;
}

}  // namespace talus
