// Regions -> tessellations -> blocks, joints and mesh nodes.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <stdexcept>

#include "geometry/joint_set.h"
#include "geometry/polygon.h"
#include "model/gauss.h"
#include "scene/build_parts.h"
#include "scene/edge_parts.h"
#include "scene/slivers.h"

namespace talus {

namespace {

struct Cuts {
  TessellationInput input;
  std::vector<int> property;  // per trace
  std::vector<bool> bonded;
  std::vector<int> set;  // per trace: index into Region::joint_sets, or -1 - index into Region::traces
};

Cuts cuts_of(const Region& region) {
  Cuts cuts;
  cuts.input.outline = region.outlines[0];
  for (const Hole& hole : region.holes) cuts.input.holes.push_back(hole.outline);
  const auto add = [&](const Polyline& line, int property, bool bonded, int set) {
    cuts.input.traces.push_back(line);
    cuts.set.push_back(set);
    cuts.property.push_back(property);
    cuts.bonded.push_back(bonded);
  };
  for (size_t k = 0; k < region.traces.size(); ++k)
    add(region.traces[k].points, region.traces[k].property, region.traces[k].bonded, -1 - int(k));
  Vec2 low = region.outlines[0][0], high = low;
  for (const Vec2& p : region.outlines[0]) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (size_t k = 0; k < region.joint_sets.size(); ++k) {
    const JointSet& set = region.joint_sets[k];
    for (const Polyline& line : joint_lines(set, low, high)) add(line, set.property, set.bonded, int(k));
  }
  return cuts;
}

// A trace or a set none of which became an interface was surely meant to do something. Of traces from a file some may
// lie outside: they are counted.
void check_cuts(const Region& region, const Cuts& cuts, const Tessellation& t, std::vector<std::string>& notes) {
  std::vector<char> traces(region.traces.size(), false), sets(region.joint_sets.size(), false);
  for (const Tessellation::Interface& face : t.interfaces) {
    if (face.trace < 0) continue;
    const int set = cuts.set[face.trace];
    (set >= 0 ? sets[set] : traces[-1 - set]) = true;
  }
  const std::string why =
      "outside, on the outline, on another joint or too near to it for blocks between, or ends inside a block";
  const std::string given = "one that cuts nothing off: it lies " + why + " (a mesh keeps such ends)";
  long drawn = 0, idle = 0;
  for (size_t k = 0; k < traces.size(); ++k) {
    drawn += region.traces[k].drawn;
    idle += region.traces[k].drawn && !traces[k];
    if (!traces[k] && !region.traces[k].drawn)
      throw InputError(region.traces[k].place, "trace", "a joint that bounds blocks of its region", given);
  }
  if (idle > 0)
    notes.push_back("region \"" + region.name + "\": " + std::to_string(idle) + " of " + std::to_string(drawn) +
                    " traces from files bound no block: each lies " + why);
  for (size_t k = 0; k < sets.size(); ++k)
    if (!sets[k])
      throw InputError(region.joint_sets[k].place, "joint_set", "joints that bound blocks of their region", given);
}

// Rectangles of a pattern from the wanted size: as square as the sides allow.
std::pair<int, int> pattern_counts(const Polyline& outline, const Mesh& mesh) {
  if (mesh.nx > 0 && mesh.ny > 0) return {mesh.nx, mesh.ny};
  const auto count = [&](double side) { return std::max(1.0, std::round(side / mesh.size)); };
  if (outline.size() != 4) return {1, 1};  // refused as no rectangle
  const Polyline corners = turned_corners(outline);
  const double nx = count((corners[1] - corners[0]).norm()), ny = count((corners[2] - corners[1]).norm());
  if (nx * ny > 1e9) throw std::length_error(std::to_string(nx * ny) + " rectangles");
  return {int(nx), int(ny)};
}

Tessellation tessellate(const Region& region, const Cuts& cuts, long most) {
  const Mesh& mesh = region.mesh;
  if (mesh.kind == MeshKind::none) return cut(cuts.input);
  if (mesh.kind == MeshKind::triangles || mesh.kind == MeshKind::voronoi) {
    const std::function<double(Vec2)> uniform = [&mesh](Vec2) { return mesh.size; };
    const auto& size_at = mesh.size_at ? mesh.size_at : uniform;
    return mesh.kind == MeshKind::voronoi ? voronoi(cuts.input, size_at, mesh.seed, most)
                                          : talus::mesh(cuts.input, size_at, most);
  }
  if (!region.holes.empty() || !cuts.input.traces.empty())
    throw std::invalid_argument("a pattern takes neither holes nor cuts: use kind = \"triangles\"");
  const auto [nx, ny] = pattern_counts(region.outlines[0], mesh);
  const long cells = long(nx) * ny * (mesh.kind == MeshKind::cross ? 4 : 2);
  if (cells > most) throw std::length_error(std::to_string(cells) + " triangles");
  return pattern(region.outlines[0],
                 mesh.kind == MeshKind::cross      ? Pattern::cross
                 : mesh.kind == MeshKind::diagonal ? Pattern::diagonal
                                                   : Pattern::alternating,
                 nx, ny);
}

int unknowns(BlockOrder order) {
  return order == BlockOrder::rigid ? rigid_dofs : order == BlockOrder::first ? first_order_dofs : second_order_dofs;
}

int unknowns(const Region& region, const PolygonIntegrals& integrals) {
  return region.held ? 0 : unknowns(region.order_at ? region.order_at(integrals.centroid) : region.order);
}

int add_block(Model& model, int region_id, const Polyline& outline) {
  const Region& region = model.scene.regions[region_id];
  const PolygonIntegrals integrals = integrate(outline);
  BlockShape shape;
  shape.dofs = unknowns(region, integrals);
  shape.vertex_begin = int(model.reference_vertex.size());
  shape.region = region_id;
  shape.material = region.material;
  shape.area = integrals.area;
  shape.length = std::sqrt(integrals.area);
  shape.xx = integrals.xx;
  shape.yy = integrals.yy;
  shape.xy = integrals.xy;
  shape.reference_centroid = integrals.centroid;
  for (const Vec2& p : outline) {
    model.reference_vertex.push_back(p - integrals.centroid);
    shape.radius = std::max(shape.radius, model.reference_vertex.back().norm());
  }
  shape.vertex_end = int(model.reference_vertex.size());
  if (region.stress && shape.dofs != rigid_dofs) {
    const Vec2 user = integrals.centroid + model.origin;
    shape.initial_stress =
        region.stress->value + region.stress->gradient_x * user.x() + region.stress->gradient_y * user.y();
  }
  if (shape.second_order()) {
    shape.quadratic = int(model.quadratic_shapes.size());
    QuadraticShape& quadratic = model.quadratic_shapes.emplace_back();
    quadratic.moments = integrate_high(outline, integrals.centroid);
    if (region.stress) {
      quadratic.stress_x = region.stress->gradient_x;
      quadratic.stress_y = region.stress->gradient_y;
    }
  }
  BlockState state;
  state.centroid = integrals.centroid;
  if (shape.second_order()) {
    state.velocity.make_second_order();
    state.bend.make() = {};
  }
  model.shapes.push_back(shape);
  model.blocks.push_back(state);
  return int(model.shapes.size()) - 1;
}

// The number of the edge of a cell that starts at point `p`.
size_t edge_from(const std::vector<int>& cell, int p) {
  return size_t(std::find(cell.begin(), cell.end(), p) - cell.begin());
}

// Exact bonds: Gauss's points. Springs: at the ends, as the paper has them; where the jump may be quadratic also in the
// middle, by Simpson's rule.
void place_points(Joint& joint, bool second_order) {
  static constexpr GaussPoint ends[] = {{0, 0.5}, {1, 0.5}}, simpson[] = {{0, 1.0 / 6}, {0.5, 4.0 / 6}, {1, 1.0 / 6}};
  const std::span<const GaussPoint> springs =
      second_order ? std::span<const GaussPoint>(simpson) : std::span<const GaussPoint>(ends);
  const auto points = joint.kind == BondKind::exact ? gauss_points(second_order ? 3 : 2) : springs;
  joint.points.resize(points.size());
  for (size_t k = 0; k < points.size(); ++k) {
    joint.points[k].at = points[k].at;
    joint.points[k].weight = joint.length * points[k].share;
  }
}

void add_joint(Model& model, int first, const Tessellation& t, const std::vector<DividedCell>& cells,
               const Tessellation::Interface& face, int property, bool bonded, const std::vector<int>& node) {
  const int a = first + face.a, b = first + face.b;
  const Vec2 p = t.points[face.p], q = t.points[face.q];
  Joint joint;
  const std::vector<int>& corner_a = cells[size_t(face.a)].corner;
  const size_t edge_a = edge_from(t.cells[face.a], face.p);
  joint.edge_a = corner_a[edge_a];
  joint.edge_b = cells[size_t(face.b)].corner[edge_from(t.cells[face.b], face.q)];
  joint.sides = corner_a[edge_a + 1] - corner_a[edge_a];
  joint.a = a;
  joint.b = b;
  joint.property = property;
  joint.trace = face.trace;
  joint.bonded = bonded;
  if (bonded) model.shapes[a].bonded = model.shapes[b].bonded = true;
  joint.state = bonded ? JointState::intact : JointState::failed;
  joint.node = {node[face.p], node[face.q]};
  joint.kind = model.scene.properties[property].bond;
  joint.length = (q - p).norm();
  joint.normal = -perp(q - p) / joint.length;
  const Vec2 centroid_a = model.shapes[a].reference_centroid, centroid_b = model.shapes[b].reference_centroid;
  joint.in_a = {p - centroid_a, q - centroid_a};
  joint.in_b = {p - centroid_b, q - centroid_b};
  place_points(joint, model.shapes[a].second_order() || model.shapes[b].second_order());
  model.joints.push_back(joint);
}

// Nodes are the tessellation's points; a point where an unbonded trace passes serves both sides, and the
// recovery separates them by the joints' connectivity.
// Returns the number of each point's node.
std::vector<int> add_nodes(Model& model, int region, const Tessellation& t, const std::vector<DividedCell>& cells,
                           int first_block) {
  std::vector<int> node(t.points.size(), -1);
  std::vector<std::vector<std::pair<int, int>>> corners(t.points.size());
  for (size_t c = 0; c < t.cells.size(); ++c)
    for (size_t v = 0; v < t.cells[c].size(); ++v)
      corners[t.cells[c][v]].push_back({first_block + int(c), cells[c].corner[v]});
  Nodes& nodes = model.nodes;
  if (nodes.begin.empty()) nodes.begin.push_back(0);
  for (size_t p = 0; p < t.points.size(); ++p) {
    if (corners[p].empty()) continue;
    node[p] = int(nodes.position.size());
    nodes.position.push_back(t.points[p]);
    nodes.region.push_back(region);
    for (const auto& [block, corner] : corners[p]) {
      nodes.blocks.push_back(block);
      nodes.corners.push_back(corner);
    }
    nodes.begin.push_back(int(nodes.blocks.size()));
  }
  return node;
}

// Whether anything may come to touch: else nothing asks for the middles of edges that bend.
bool may_touch(const Scene& scene) {
  const auto in_pieces = [](const Region& region) {
    return region.outlines.size() > 1 || region.mesh.kind == MeshKind::given || !region.traces.empty() ||
           !region.joint_sets.empty();
  };
  return scene.regions.size() > 1 || std::ranges::any_of(scene.regions, in_pieces) ||
         std::ranges::any_of(scene.properties, [](const JointProperty& property) { return property.breaks; });
}

// Which cells become blocks of second order; empty if none.
std::vector<char> second_order(const Region& region, const Tessellation& t) {
  std::vector<char> bends;
  for (const std::vector<int>& cell : t.cells)
    bends.push_back(unknowns(region, integrate(t.outline(cell))) == second_order_dofs);
  if (std::ranges::none_of(bends, [](char bend) { return bend; })) bends.clear();
  return bends;
}

void add_tessellation(Model& model, int region_id, const Tessellation& t, const Cuts& cuts,
                      std::vector<FreeEdge>& edges) {
  const Region& region = model.scene.regions[region_id];
  const std::vector<DividedCell> cells =
      divided(t, may_touch(model.scene) ? second_order(region, t) : std::vector<char>{});
  const int first = int(model.shapes.size());
  for (const DividedCell& cell : cells) add_block(model, region_id, cell.outline);
  const std::vector<int> node = add_nodes(model, region_id, t, cells, first);
  const int own = region.joint >= 0 ? region.joint : model.scene.contact;
  for (const Tessellation::Interface& face : t.interfaces) {
    const int a = first + face.a, b = first + face.b;
    const int property = face.trace >= 0 && cuts.property[face.trace] >= 0 ? cuts.property[face.trace] : own;
    const bool bonded = face.trace < 0 || cuts.bonded[face.trace];
    add_joint(model, first, t, cells, face, property, bonded, node);
    if (!bonded) model.pair_property[(std::int64_t(std::min(a, b)) << 32) | std::max(a, b)] = property;
  }
  for (const BoundaryEdge& edge : boundary_edges(t)) {
    const auto& [outline, corner] = cells[size_t(edge.cell)];
    const size_t own = edge_from(t.cells[edge.cell], edge.p);
    for (size_t side = size_t(corner[own]); side < size_t(corner[own + 1]); ++side)
      edges.push_back({region_id, first + edge.cell, int(side), outline[side], outline[(side + 1) % outline.size()]});
  }
}

void add_ready_blocks(Model& model, int region_id, std::vector<FreeEdge>& edges) {
  const Region& region = model.scene.regions[region_id];
  for (const Polyline& given : region.outlines) {
    const bool bends = unknowns(region, integrate(given)) == second_order_dofs;
    const Polyline outline = bends && may_touch(model.scene) ? divided(given) : given;
    const int block = add_block(model, region_id, outline);
    for (size_t i = 0; i < outline.size(); ++i)
      edges.push_back({region_id, block, int(i), outline[i], outline[(i + 1) % outline.size()]});
  }
}

// Points that lie within a distance of each other, as one: the first of them.
class Welded {
 public:
  Welded(const Vec2& corner, double distance, std::vector<Vec2>& points)
      : corner_(corner), distance_(distance), points_(points) {}
  int operator()(const Vec2& p) {
    const std::int64_t x = square(p.x() - corner_.x()), y = square(p.y() - corner_.y());
    for (std::int64_t i = x - 1; i <= x + 1; ++i)
      for (std::int64_t j = y - 1; j <= y + 1; ++j)
        if (const auto found = index_.find({i, j});
            found != index_.end() && (points_[found->second] - p).norm() <= distance_)
          return found->second;
    points_.push_back(p);
    return index_[{x, y}] = int(points_.size()) - 1;
  }

 private:
  std::int64_t square(double x) const { return std::int64_t(std::floor(x / distance_)); }
  Vec2 corner_;      // of all points
  double distance_;  // m
  std::vector<Vec2>& points_;
  std::map<std::pair<std::int64_t, std::int64_t>, int> index_;
};

// Ready blocks that are bonded where they share a whole edge. Corners are in one place that differ by the rounding of
// what a script works out, far from the origin too.
Tessellation given_cells(const Region& region) {
  constexpr double one_place = 1e-9;  // of the region's box
  Tessellation t;
  Eigen::AlignedBox2d box;
  for (const Polyline& outline : region.outlines)
    for (const Vec2& p : outline) box.extend(p);
  Welded weld(box.min(), one_place * box.diagonal().norm(), t.points);
  for (const Polyline& outline : region.outlines) {
    std::vector<int>& cell = t.cells.emplace_back();
    for (const Vec2& p : outline) cell.push_back(weld(p));
  }
  try {
    connect(t);
  } catch (const std::logic_error&) {
    throw std::invalid_argument("bonded blocks that overlap: two of them lie on the same side of an edge");
  }
  return t;
}

void add_region(Model& model, int region_id, std::vector<FreeEdge>& edges) {
  const Region& region = model.scene.regions[region_id];
  const std::string field = "region \"" + region.name + "\"";
  const bool ready =
      region.mesh.kind == MeshKind::none && region.traces.empty() && region.joint_sets.empty() && region.holes.empty();
  const long left = model.scene.max_blocks - long(model.shapes.size());
  try {
    if (ready) return add_ready_blocks(model, region_id, edges);
    if (region.mesh.kind == MeshKind::given) return add_tessellation(model, region_id, given_cells(region), {}, edges);
    const Cuts cuts = cuts_of(region);
    Tessellation t = tessellate(region, cuts, left);
    if (long(t.cells.size()) > left) throw std::length_error(std::to_string(t.cells.size()) + " blocks");
    check_cuts(region, cuts, t, model.notes);
    treat_slivers(region, model.origin, t, model.notes);
    add_tessellation(model, region_id, t, cuts, edges);
  } catch (const std::length_error& error) {
    const Place& place = region.mesh.place.file.empty() ? region.place : region.mesh.place;
    throw InputError(
        place, "mesh of " + field,
        "at most " + std::to_string(model.scene.max_blocks) + " blocks (raise max_blocks or the mesh size)",
        error.what());
  } catch (const std::invalid_argument& error) {
    throw InputError(region.place, field, "a region that can be divided into blocks", error.what());
  }
}

void give_velocities(Model& model, int region_id, int first) {
  const Region& region = model.scene.regions[region_id];
  double area = 0;
  Vec2 centre = Vec2::Zero();
  for (size_t b = first; b < model.shapes.size(); ++b) {
    area += model.shapes[b].area;
    centre += model.shapes[b].area * model.shapes[b].reference_centroid;
  }
  centre = region.spin_centre ? *region.spin_centre - model.origin : Vec2(centre / area);
  for (size_t b = first; b < model.shapes.size(); ++b) {
    const Vec2 v = region.velocity + region.spin * perp(model.blocks[b].centroid - centre);
    model.blocks[b].velocity = {v.x(), v.y(), region.spin * model.shapes[b].length};
  }
}

}  // namespace

std::vector<FreeEdge> build_blocks(Model& model) {
  std::vector<FreeEdge> edges;
  for (size_t r = 0; r < model.scene.regions.size(); ++r) {
    const int first = int(model.shapes.size());
    add_region(model, int(r), edges);
    give_velocities(model, int(r), first);
  }
  return edges;
}

}  // namespace talus
