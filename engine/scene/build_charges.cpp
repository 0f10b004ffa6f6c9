// Charges find the walls of their holes, and the gas the free surfaces where it vents.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <set>

#include "geometry/polygon.h"
#include "scene/build_parts.h"

namespace talus {

namespace {

constexpr double on_outline = 1e-9;  // of the scene's size, as for fixities: far above rounding, far below any block

std::pair<double, double> key(const Vec2& p) {
  return {p.x(), p.y()};
}

// Outlines of blocks, or of blocks that hang together, which lie in the hole with nothing of them outside. Returns
// their part of its area.
double add_loose(const Model& model, const Hole& hole, const std::vector<FreeEdge>& edges, HoleWall& wall) {
  std::multimap<std::pair<double, double>, const FreeEdge*> from;
  const auto lies_in = [&](int block) {
    const BlockShape& shape = model.shapes[block];
    for (int v = shape.vertex_begin; v < shape.vertex_end; ++v)
      if (!contains(hole.outline, model.reference_place(block, model.reference_vertex[v]))) return false;
    return true;
  };
  for (const FreeEdge& edge : edges)
    if (lies_in(edge.block)) from.emplace(key(edge.from), &edge);
  double taken = 0;
  while (!from.empty()) {
    const FreeEdge* edge = from.begin()->second;
    const Vec2 start = edge->from;
    wall.outlines.push_back(wall.edges.size());
    while (edge) {
      wall.edges.push_back({edge->block, edge->edge});
      taken += cross(edge->from - wall.centre, edge->to - wall.centre) / 2;
      const auto erased = [&](const auto& entry) { return entry.second == edge; };
      const auto own = from.equal_range(key(edge->from));
      from.erase(std::find_if(own.first, own.second, erased));
      const auto [begin, end] = from.equal_range(key(edge->to));
      // At a corner that two blocks share the same one goes on, where it can.
      const auto same = std::find_if(begin, end, [&](const auto& entry) { return entry.second->block == edge->block; });
      const auto next = same != end ? same : begin;
      edge = edge->to == start || next == end ? nullptr : next->second;
    }
  }
  return taken / (std::numbers::pi * wall.radius * wall.radius);
}

HoleWall wall_of(const Model& model, int id, const std::vector<FreeEdge>& edges) {
  const Charge& charge = model.scene.charges[id];
  const Region& region = model.scene.regions[charge.region];
  const Hole& hole = region.holes[charge.hole];
  const double tolerance = on_outline * model.extent;
  std::map<std::pair<double, double>, const FreeEdge*> from;
  for (const FreeEdge& edge : edges)
    if (edge.region == charge.region && distance_to_boundary(hole.outline, edge.from) <= tolerance &&
        distance_to_boundary(hole.outline, Vec2((edge.from + edge.to) / 2)) <= tolerance)
      from[key(edge.from)] = &edge;
  HoleWall wall;
  wall.charge = id;
  const PolygonIntegrals integrals = integrate(hole.outline);
  wall.centre = integrals.centroid;
  wall.radius = std::sqrt(integrals.area / std::numbers::pi);
  const size_t count = from.size();
  const FreeEdge* const first = count ? from.begin()->second : nullptr;
  bool closed = false;
  for (const FreeEdge* edge = first; edge;) {
    wall.edges.push_back({edge->block, edge->edge});
    closed = key(edge->to) == key(first->from);
    from.erase(key(edge->from));
    const auto next = from.find(key(edge->to));
    edge = next == from.end() ? nullptr : next->second;
  }
  if (wall.edges.size() < 3 || wall.edges.size() != count || !closed)
    throw InputError(charge.place, "charge.hole", "a hole with a closed wall of free edges",
                     "\"" + hole.name + "\", whose wall has " + std::to_string(wall.edges.size()) + " of " +
                         std::to_string(count) + " edges in a row" + (closed ? "" : ", which do not close"));
  if (!(add_loose(model, hole, edges, wall) < 1 - on_outline))
    throw InputError(charge.place, "charge.hole", "a hole with room for gas",
                     "\"" + hole.name + "\", which is filled with blocks");
  return wall;
}

// Gas would blow through what lets waves out.
void refuse_dashpots(const Model& model, const HoleWall& wall) {
  const Charge& charge = model.scene.charges[wall.charge];
  for (const ViscousEdge& viscous : model.viscous_edges)
    for (const BlockEdge& edge : wall.edges)
      if (viscous.block == edge.block && viscous.edge == edge.edge)
        throw InputError(charge.place, "charge.hole", "a hole whose wall is rock",
                         "\"" + model.scene.regions[charge.region].holes[charge.hole].name +
                             "\", part of which is a viscous boundary");
}

// A delay in seconds that was meant in milliseconds, for one.
void note_late(Model& model, const Charge& charge) {
  const TimeControl& time = model.scene.time;
  if (time.mode != Mode::dynamic || charge.delay < time.t_end) return;
  char text[100];
  std::snprintf(text, sizeof text, "its delay of %g s does not end before t_end = %g s", charge.delay, time.t_end);
  model.notes.push_back("charge \"" + charge.name + "\" does not go off: " + text);
}

// Block and edge, of those that a fixity holds from end to end; rigid blocks, and those that springs hold, it holds at
// points.
std::set<std::pair<int, int>> held_edges(const Model& model, const std::vector<FreeEdge>& edges) {
  std::map<std::pair<int, int>, std::vector<Vec2>> pinned;  // by block and fixity
  for (const PointFixity& point : model.point_fixities)
    pinned[{point.block, point.fixity}].push_back(model.reference_place(point.block, point.in_block));
  const auto same = [&](const Vec2& a, const Vec2& b) { return (a - b).norm() <= on_outline * model.extent; };
  const auto holds = [&](const std::vector<Vec2>& points, const Vec2& end) {
    return std::any_of(points.begin(), points.end(), [&](const Vec2& point) { return same(point, end); });
  };
  std::set<std::pair<int, int>> held;
  for (const FreeEdge& edge : edges) {
    const auto by_edge = [&](const EdgeFixity& fixity) {
      return fixity.block == edge.block && same(edge.from, model.reference_place(edge.block, fixity.in_block[0])) &&
             same(edge.to, model.reference_place(edge.block, fixity.in_block[1]));
    };
    bool whole = std::any_of(model.edge_fixities.begin(), model.edge_fixities.end(), by_edge);
    for (auto of = pinned.lower_bound({edge.block, 0}); !whole && of != pinned.end() && of->first.first == edge.block;
         ++of)
      whole = holds(of->second, edge.from) && holds(of->second, edge.to);
    if (whole) held.insert({edge.block, edge.edge});
  }
  return held;
}

}  // namespace

void attach_charges(Model& model, const std::vector<FreeEdge>& edges) {
  if (model.scene.charges.empty()) return;
  std::set<std::pair<int, int>> closed;  // edges where nothing vents: walls of charges, and what is held
  for (size_t c = 0; c < model.scene.charges.size(); ++c) {
    model.hole_walls.push_back(wall_of(model, int(c), edges));
    refuse_dashpots(model, model.hole_walls.back());
    note_late(model, model.scene.charges[c]);
    for (const BlockEdge& edge : model.hole_walls.back().edges) closed.insert({edge.block, edge.edge});
  }
  std::vector<int> node_of(model.reference_vertex.size(), -1);
  Nodes& nodes = model.nodes;
  for (size_t n = 0; n + 1 < nodes.begin.size(); ++n)
    for (int k = nodes.begin[n]; k < nodes.begin[n + 1]; ++k)
      node_of[model.shapes[nodes.blocks[k]].vertex_begin + nodes.corners[k]] = int(n);
  std::set<std::pair<int, int>> held = held_edges(model, edges);
  for (const ViscousEdge& viscous : model.viscous_edges) held.insert({viscous.block, viscous.edge});
  nodes.free.assign(nodes.position.size(), 0);
  for (const FreeEdge& edge : edges) {
    const int own = edge.edge;
    if (closed.contains({edge.block, own}) || held.contains({edge.block, own})) continue;
    for (const int v : {own, model.next_vertex(edge.block, own)}) {
      const int node = node_of[model.shapes[edge.block].vertex_begin + v];
      if (node >= 0) nodes.free[node] = 1;
    }
  }
}

}  // namespace talus
