// Fixities, loads, viscous boundaries and probes find the blocks they act on.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "geometry/polygon.h"
#include "scene/build_parts.h"

namespace talus {

namespace {

// Coordinates typed by hand meet edges to 1e-9 of the scene's size: far above rounding, far below any block.
constexpr double on_edge = 1e-9;

std::string at_text(const Vec2& p) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.6g, %.6g)", p.x(), p.y());
  return text;
}

class Finder {
 public:
  Finder(const Model& model, const std::vector<FreeEdge>& edges) : model_(model), edges_(edges) {
    tolerance_ = on_edge * model.extent * 2;
  }

  // Blocks of the region (-1: any) whose reference outline holds the point, boundaries included.
  std::vector<int> blocks_at(const Vec2& point, int region) const {
    std::vector<int> found;
    for (size_t b = 0; b < model_.shapes.size(); ++b) {
      const BlockShape& shape = model_.shapes[b];
      if (region >= 0 && shape.region != region) continue;
      if ((point - shape.reference_centroid).norm() > shape.radius + tolerance_) continue;
      Polyline outline;
      for (int v = shape.vertex_begin; v < shape.vertex_end; ++v)
        outline.push_back(shape.reference_centroid + model_.reference_vertex[v]);
      if (contains(outline, point) || distance_to_boundary(outline, point) <= tolerance_) found.push_back(int(b));
    }
    return found;
  }

  struct Part {
    int block, edge;
    Vec2 from, to;
  };
  // Parts of the region's free edges that lie on the segment.
  std::vector<Part> edges_on(const On& on, int region) const {
    std::vector<Part> found;
    const Vec2 along = (on.to - on.from).normalized();
    const double length = (on.to - on.from).norm();
    for (const FreeEdge& edge : edges_) {
      if (edge.region != region) continue;
      const Vec2 a = edge.from - on.from, b = edge.to - on.from;
      if (std::abs(cross(along, a)) > tolerance_ || std::abs(cross(along, b)) > tolerance_) continue;
      const double sa = std::clamp(along.dot(a), 0.0, length), sb = std::clamp(along.dot(b), 0.0, length);
      if (std::abs(sb - sa) <= tolerance_) continue;
      found.push_back({edge.block, edge.edge, on.from + sa * along, on.from + sb * along});
    }
    return found;
  }

  bool meet(const Vec2& a, const Vec2& b) const { return (a - b).norm() <= tolerance_; }
  bool meet(const Part& part, const Vec2& point) const {
    return distance_to_boundary({part.from, part.to}, point) <= tolerance_;
  }

  // Whether two parts are of one edge and share more than a point.
  bool share(const Part& a, const Part& b) const {
    if (a.block != b.block || a.edge != b.edge) return false;
    const double length = (a.to - a.from).norm();
    const Vec2 along = (a.to - a.from) / length;
    const auto [low, high] = std::minmax({along.dot(b.from - a.from), along.dot(b.to - a.from)});
    return std::min(high, length) - std::max(low, 0.0) > tolerance_;
  }
  // One of `parts` that shares more than a point with one of the others.
  std::optional<Part> shared(const std::vector<Part>& parts, const std::vector<Part>& others) const {
    for (const Part& other : others)
      for (const Part& part : parts)
        if (share(part, other)) return part;
    return std::nullopt;
  }

 private:
  const Model& model_;
  const std::vector<FreeEdge>& edges_;
  double tolerance_;
};

std::string edge_text(const Model& model, const Finder::Part& part) {
  return "the edge from " + at_text(part.from + model.origin) + " to " + at_text(part.to + model.origin);
}

std::string line_text(const Model& model, const On& on) {
  return "a free edge of region on the line " + at_text(on.from + model.origin) + " to " +
         at_text(on.to + model.origin);
}

void attach_fixity_points(Model& model, int fixity, const std::vector<int>& blocks, const Vec2& point) {
  for (int block : blocks) {
    PointFixity fixed;
    fixed.fixity = fixity;
    fixed.block = block;
    fixed.in_block = point - model.shapes[block].reference_centroid;
    model.point_fixities.push_back(fixed);
  }
}

bool springs(const Model& model, int region) {
  const int joint = model.scene.regions[region].joint;
  return joint >= 0 && model.scene.properties[joint].bond == BondKind::spring;
}

void attach_fixity_edge(Model& model, int fixity, const Finder::Part& part, bool by_springs) {
  const BlockShape& shape = model.shapes[part.block];
  if (by_springs || shape.dofs == rigid_dofs) {
    attach_fixity_points(model, fixity, {part.block}, part.from);
    attach_fixity_points(model, fixity, {part.block}, part.to);
    return;
  }
  EdgeFixity edge;
  edge.fixity = fixity;
  edge.block = part.block;
  edge.in_block = {part.from - shape.reference_centroid, part.to - shape.reference_centroid};
  edge.length = (part.to - part.from).norm();
  edge.normal = -perp(part.to - part.from) / edge.length;
  model.edge_fixities.push_back(edge);
}

// What both hold and move differently, looked at now and then; empty: nothing.
std::string contradiction(const Fixity& a, const Fixity& b, double end) {
  constexpr int looks = 16;
  constexpr double rounding = 1e-12;
  for (const int way : {0, 1}) {
    if (!a.held[size_t(way)] || !b.held[size_t(way)]) continue;
    for (int k = 1; k <= looks; ++k) {
      const double of_a = a.moved(end * k / looks)[way], of_b = b.moved(end * k / looks)[way];
      if (std::abs(of_a - of_b) > rounding * (std::abs(of_a) + std::abs(of_b)))
        return std::string("holds or moves ") + "xy"[way] + " otherwise";
    }
  }
  return a.spin != b.spin ? "turns it otherwise" : "";
}

// Where both hold the same; empty: nowhere. Edges that meet in a corner do not.
std::string common_place(const Model& model, const Fixity& a, const Fixity& b, const Finder& finder) {
  if (a.region != b.region) return {};
  if (a.on.kind == On::region || b.on.kind == On::region)
    return "region \"" + model.scene.regions[a.region].name + "\"";
  if (a.on.kind == On::point && b.on.kind == On::point)
    return finder.meet(a.on.from, b.on.from) ? at_text(a.on.from + model.origin) : "";
  const Fixity &edge = a.on.kind == On::point ? b : a, &other = a.on.kind == On::point ? a : b;
  const auto parts = finder.edges_on(edge.on, edge.region);
  if (other.on.kind == On::point) {
    const bool meet = std::any_of(parts.begin(), parts.end(),
                                  [&](const Finder::Part& part) { return finder.meet(part, other.on.from); });
    return meet ? at_text(other.on.from + model.origin) : "";
  }
  const auto part = finder.shared(parts, finder.edges_on(other.on, other.region));
  return part ? edge_text(model, *part) : "";
}

// Two that hold the same in one direction and move it differently would come to something between.
void check_agreement(const Model& model, int id, const Finder& finder) {
  const Fixity& fixity = model.scene.fixities[size_t(id)];
  for (int earlier = 0; earlier < id; ++earlier) {
    const Fixity& other = model.scene.fixities[size_t(earlier)];
    const std::string where = common_place(model, fixity, other, finder);
    if (where.empty()) continue;
    const std::string what = contradiction(fixity, other, model.scene.time.t_end);
    if (!what.empty())
      throw InputError(fixity.place, "fix.on", "what no other fix moves differently",
                       where + ", where \"" + other.name + "\" " + what);
  }
}

void attach_fixity(Model& model, int id, const Finder& finder) {
  const Fixity& fixity = model.scene.fixities[id];
  const std::string name = model.scene.regions[fixity.region].name;
  check_agreement(model, id, finder);
  if (fixity.on.kind == On::region) {
    if (!fixity.held[0] || !fixity.held[1])
      throw InputError(fixity.place, "fix", "x and y both held where a whole region is held", "one direction");
    for (size_t b = 0; b < model.shapes.size(); ++b) {
      if (model.shapes[b].region != fixity.region) continue;
      model.hold(int(b));
      model.held_by[b] = id;
    }
  } else if (fixity.on.kind == On::point) {
    const std::vector<int> blocks = finder.blocks_at(fixity.on.from, fixity.region);
    if (blocks.empty())
      throw InputError(fixity.place, "fix.on", "a point of region \"" + name + "\"",
                       at_text(fixity.on.from + model.origin) + ", which is outside it");
    attach_fixity_points(model, id, blocks, fixity.on.from);
  } else {
    const auto parts = finder.edges_on(fixity.on, fixity.region);
    if (parts.empty())
      throw InputError(fixity.place, "fix.on", line_text(model, fixity.on), "none of region \"" + name + "\" there");
    for (const Finder::Part& part : parts) attach_fixity_edge(model, id, part, springs(model, fixity.region));
  }
}

// What is held bears a load, or stays, without a word: where it meets what is not, that is meant.
std::vector<int> free_first(const Model& model, std::vector<int> blocks) {
  const auto held = [&](int block) { return model.shapes[size_t(block)].dofs == 0; };
  if (!std::all_of(blocks.begin(), blocks.end(), held)) std::erase_if(blocks, held);
  return blocks;
}

void attach_point_load(Model& model, int id, const Finder& finder) {
  const PointLoad& load = model.scene.point_loads[id];
  const std::vector<int> blocks = free_first(model, finder.blocks_at(load.at, load.region));
  if (blocks.empty())
    throw InputError(load.place, "point_load.at", "a point inside a block",
                     at_text(load.at + model.origin) + ", which is outside every block");
  for (int block : blocks)
    model.point_forces.push_back(
        {id, block, load.at - model.shapes[block].reference_centroid, 1.0 / double(blocks.size())});
}

void attach_edge_load(Model& model, int id, const Finder& finder) {
  const EdgeLoad& load = model.scene.edge_loads[id];
  const auto parts = finder.edges_on(load.on, load.region);
  if (parts.empty())
    throw InputError(load.place, "edge_load.on", line_text(model, load.on),
                     "none of region \"" + model.scene.regions[load.region].name + "\" there");
  for (const Finder::Part& part : parts) {
    const Vec2 centroid = model.shapes[part.block].reference_centroid;
    model.edge_forces.push_back({id, part.block, {part.from - centroid, part.to - centroid}});
  }
}

// Throws where a fixity or an earlier viscous boundary has some of these edges.
void check_alone(const Model& model, int id, const std::vector<Finder::Part>& parts, const Finder& finder) {
  const ViscousBoundary& boundary = model.scene.viscous_boundaries[id];
  const auto check = [&](const On& on, int region, const std::string& whose) {
    if (region != boundary.region || on.kind != On::line) return;
    if (const auto part = finder.shared(parts, finder.edges_on(on, region)))
      throw InputError(boundary.place, "viscous.on", "edges of its own", edge_text(model, *part) + ", which " + whose);
  };
  for (const Fixity& fixity : model.scene.fixities) check(fixity.on, fixity.region, "\"" + fixity.name + "\" holds");
  for (int earlier = 0; earlier < id; ++earlier) {
    const ViscousBoundary& other = model.scene.viscous_boundaries[earlier];
    check(other.on, other.region, "is viscous already");
  }
}

void attach_viscous(Model& model, int id, const Finder& finder) {
  const ViscousBoundary& boundary = model.scene.viscous_boundaries[id];
  const std::string name = model.scene.regions[boundary.region].name;
  const auto parts = finder.edges_on(boundary.on, boundary.region);
  if (parts.empty())
    throw InputError(boundary.place, "viscous.on", line_text(model, boundary.on),
                     "none of region \"" + name + "\" there");
  if (model.shapes[parts[0].block].dofs == 0)
    throw InputError(boundary.place, "viscous.region", "a region that can move", "\"" + name + "\", which is held");
  check_alone(model, id, parts, finder);
  for (const Finder::Part& part : parts) {
    const Vec2 centroid = model.shapes[part.block].reference_centroid;
    ViscousEdge edge;
    edge.block = part.block;
    edge.edge = part.edge;
    edge.in_block = {part.from - centroid, part.to - centroid};
    edge.length = (part.to - part.from).norm();
    edge.normal = -perp(part.to - part.from) / edge.length;
    model.viscous_edges.push_back(edge);
  }
}

void attach_probe(Model& model, int id, const Finder& finder) {
  const Probe& probe = model.scene.probes[id];
  const std::vector<int> blocks = free_first(model, finder.blocks_at(probe.at, probe.region));
  if (blocks.empty())
    throw InputError(probe.place, "probes." + probe.name, "a point inside a block",
                     at_text(probe.at + model.origin) + ", which is outside every block");
  model.probes.push_back({id, blocks[0], probe.at - model.shapes[blocks[0]].reference_centroid});
}

}  // namespace

void attach(Model& model, const std::vector<FreeEdge>& edges) {
  const Finder finder(model, edges);
  model.held_by.assign(model.shapes.size(), -1);
  const auto each = [&](size_t count, void (*attach_one)(Model&, int, const Finder&)) {
    for (size_t id = 0; id < count; ++id) attach_one(model, int(id), finder);
  };
  each(model.scene.fixities.size(), attach_fixity);
  each(model.scene.point_loads.size(), attach_point_load);
  each(model.scene.edge_loads.size(), attach_edge_load);
  each(model.scene.viscous_boundaries.size(), attach_viscous);
  each(model.scene.probes.size(), attach_probe);
}

}  // namespace talus
