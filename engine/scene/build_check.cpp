// What can be wrong with regions and their weight, said before any block is made.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>

#include "geometry/polygon.h"
#include "scene/build_parts.h"

namespace talus {

namespace {

Eigen::AlignedBox2d box_of(const Polyline& polygon) {
  Eigen::AlignedBox2d box;
  for (const Vec2& p : polygon) box.extend(p);
  return box;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string pair_text(const Vec2& p) {
  return "(" + number(p.x()) + ", " + number(p.y()) + ")";
}

// A scene may list corners either way round. Those that run clockwise are turned, the first one staying the first;
// where an outline has another defect it is told of the corners as they were given.
void check_outline(Polyline& outline, const Place& place, const std::string& field) {
  const auto reason = defect(outline);
  if (!reason) return;
  Polyline turned = outline;
  if (!turned.empty()) std::reverse(turned.begin() + 1, turned.end());
  if (defect(turned)) throw InputError(place, field, "a simple polygon", *reason);
  outline = std::move(turned);
}

// Where a corner of one lies on the other, to the round-off of what divides a region, which needs a gap between its
// boundaries.
std::optional<Vec2> touch(const Polyline& a, const Polyline& b) {
  constexpr double round_off = 1e-14;
  const auto box_a = box_of(a), box_b = box_of(b);
  const double near = round_off * std::max(box_a.merged(box_b).min().cwiseAbs().maxCoeff(),
                                           box_a.merged(box_b).max().cwiseAbs().maxCoeff());
  if (box_a.exteriorDistance(box_b) > near) return std::nullopt;
  for (const auto& [corners, boundary] : {std::pair{&a, &b}, {&b, &a}})
    for (const Vec2& p : *corners)
      if (distance_to_boundary(*boundary, p) <= near) return p;
  return std::nullopt;
}

void check_touch(const Region& region, size_t h, const Place& place, const std::string& field) {
  const Polyline& own = region.holes[h].outline;
  if (const auto at = touch(own, region.outlines[0]))
    throw InputError(place, field, "a hole that keeps off the region's outline",
                     "one that touches it at " + pair_text(*at));
  for (size_t other = 0; other < h; ++other)
    if (const auto at = touch(own, region.holes[other].outline))
      throw InputError(place, field, "holes that keep off each other",
                       "one that touches hole \"" + region.holes[other].name + "\" at " + pair_text(*at));
}

void check_inside(const Region& region, const Hole& hole, const Place& place, const std::string& field) {
  for (const Vec2& p : hole.outline)
    if (!contains(region.outlines[0], p))
      throw InputError(place, field, "a hole inside the region's outline", "a corner at " + pair_text(p) + " outside");
  const double shared = overlap_area(region.outlines[0], hole.outline), own = signed_area(hole.outline);
  if (shared < own * (1 - 1e-9))
    throw InputError(place, field, "a hole inside the region's outline",
                     number(100 * (1 - shared / own)) + " % of its area outside");
}

// Of ready blocks a hole is what they leave.
void check_left(const Region& region, const Hole& hole, const Place& place, const std::string& field) {
  const auto box = box_of(hole.outline);
  for (size_t b = 0; b < region.outlines.size(); ++b)
    if (box.intersects(box_of(region.outlines[b])) && overlap_area(region.outlines[b], hole.outline) > 0)
      throw InputError(place, field, "a hole that the region's blocks leave",
                       "one that block " + std::to_string(b + 1) + " lies in");
}

void check_holes(Region& region) {
  const std::string owner = "region \"" + region.name + "\"";
  for (size_t h = 0; h < region.holes.size(); ++h) {
    Hole& hole = region.holes[h];
    const Place& place = hole.place.file.empty() ? region.place : hole.place;
    const std::string field = "hole \"" + hole.name + "\" of " + owner;
    check_outline(hole.outline, place, field);
    const bool ready = region.mesh.kind == MeshKind::given;
    ready ? check_left(region, hole, place, field) : check_inside(region, hole, place, field);
    for (size_t other = 0; other < h; ++other)
      if (overlap_area(region.holes[other].outline, hole.outline) > 0)
        throw InputError(place, field, "holes that do not overlap",
                         "an overlap with hole \"" + region.holes[other].name + "\"");
    if (!ready) check_touch(region, h, place, field);
  }
}

// An overlap up to this part of the smaller outline is taken for the inaccuracy of drawings and surveys: contacts
// met overlapping do not press (theory, § 5). More is a mistake.
constexpr double slight_overlap = 5e-3;

double area_of(const Region& region) {
  double area = signed_area(region.outlines[0]);
  for (const Hole& hole : region.holes) area -= signed_area(hole.outline);
  return area;
}

struct Piece {
  const Region* region;
  const Polyline* outline;
  Eigen::AlignedBox2d box;
  // Those of its region lie in its first outline, but for ready blocks.
  bool has_holes() const { return outline == &region->outlines[0] && region->mesh.kind != MeshKind::given; }
  double area() const { return has_holes() ? area_of(*region) : signed_area(*outline); }
};

// What the holes of `a` take away from its overlap with the outline of `b`.
double overlap_of_holes(const Piece& a, const Polyline& b) {
  double area = 0;
  if (a.has_holes())
    for (const Hole& hole : a.region->holes) area += overlap_area(hole.outline, b);
  return area;
}

// The area of rock that two pieces share. Holes lie in their outlines and apart from each other, so what two holes
// share has been taken away twice.
double shared_rock(const Piece& a, const Piece& b) {
  double area =
      overlap_area(*a.outline, *b.outline) - overlap_of_holes(a, *b.outline) - overlap_of_holes(b, *a.outline);
  if (b.has_holes())
    for (const Hole& hole : b.region->holes) area += overlap_of_holes(a, hole.outline);
  return area;
}

// Sorted by their left ends, so that only near neighbours are compared.
void check_overlaps(const Scene& scene) {
  std::vector<Piece> pieces;
  for (const Region& region : scene.regions)
    for (const Polyline& outline : region.outlines) pieces.push_back({&region, &outline, box_of(outline)});
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.box.min().x() < b.box.min().x(); });
  for (size_t a = 0; a < pieces.size(); ++a) {
    for (size_t b = a + 1; b < pieces.size() && pieces[b].box.min().x() < pieces[a].box.max().x(); ++b) {
      const Vec2 shared = pieces[a].box.intersection(pieces[b].box).sizes();  // negative where they are apart
      const double smaller = std::min(pieces[a].area(), pieces[b].area());
      if (shared.minCoeff() <= 0 || shared.prod() < slight_overlap * smaller) continue;
      const double area = shared_rock(pieces[a], pieces[b]);
      if (area <= slight_overlap * smaller) continue;
      const bool later = pieces[a].region < pieces[b].region;
      const Region& second = later ? *pieces[b].region : *pieces[a].region;
      const Region& first = later ? *pieces[a].region : *pieces[b].region;
      throw InputError(second.place, "region \"" + second.name + "\"", "regions that do not overlap",
                       &first == &second ? "two of its own blocks overlapping by " + number(area) + " m2"
                                         : "an overlap of " + number(area) + " m2 with region \"" + first.name + "\"");
    }
  }
}

// --- How many blocks a scene asks for. What follows refuses only what is certainly too much; the mesher and build
// count exactly.

std::string count_text(double count) {
  char text[32];
  std::snprintf(text, sizeof text, count < 1e9 ? "%.0f" : "%.2g", count);
  return text;
}

std::string limit_text(long most) {
  return "at most " + std::to_string(most) + " blocks (max_blocks)";
}

// Two digits, away from zero, after a twentieth for the estimate's sake.
std::string enough(double value) {
  value *= 1.05;
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return number(std::ceil(value / unit) * unit);
}

double lines_of(const JointSet& set, const Polyline& outline) {
  const Vec2 normal(-std::sin(set.dip), std::cos(set.dip));
  double low = normal.dot(outline[0]), high = low;
  for (const Vec2& p : outline) {
    low = std::min(low, normal.dot(p));
    high = std::max(high, normal.dot(p));
  }
  return (high - low) / set.spacing;
}

// Blocks that joint sets make: by Euler's formula one for each crossing, and one for each line from boundary to
// boundary; a part that ends in the rock takes one away. Scatter changes nothing in the mean.
double blocks_of(const Region& region, const std::vector<JointSet>& sets) {
  const double area = area_of(region);
  double blocks = 1;
  for (size_t k = 0; k < sets.size(); ++k) {
    const JointSet& set = sets[k];
    if (set.persistence >= 1)
      blocks += lines_of(set, region.outlines[0]);
    else
      blocks -= area / set.spacing * set.persistence / (set.trace_length > 0 ? set.trace_length : 5 * set.spacing);
    for (size_t other = 0; other < k; ++other)
      blocks += area * std::abs(std::sin(set.dip - sets[other].dip)) / (set.spacing * sets[other].spacing) *
                std::min(1.0, set.persistence) * std::min(1.0, sets[other].persistence);
  }
  return blocks;
}

// All sets would have to be this much wider apart.
double widening(const Region& region, double most) {
  double low = 1, high = 2;
  const auto blocks = [&region](double factor) {
    std::vector<JointSet> sets = region.joint_sets;
    for (JointSet& set : sets) set.spacing *= factor;
    return blocks_of(region, sets);
  };
  while (blocks(high) > most && high < 1e12) high *= 2;
  for (int k = 0; k < 40; ++k) (blocks((low + high) / 2) > most ? low : high) = (low + high) / 2;
  return high;
}

void check_joint_sets(const Region& region, long most) {
  if (region.joint_sets.empty()) return;
  const double blocks = blocks_of(region, region.joint_sets);
  if (!(blocks > 1.1 * static_cast<double>(most))) return;
  const auto finest = std::min_element(region.joint_sets.begin(), region.joint_sets.end(),
                                       [](const JointSet& a, const JointSet& b) { return a.spacing < b.spacing; });
  const double factor = widening(region, static_cast<double>(most));
  const bool alone = region.joint_sets.size() == 1;
  throw InputError(finest->place.file.empty() ? region.place : finest->place,
                   "joint_set.spacing in region \"" + region.name + "\"",
                   limit_text(most) + ", so a spacing of " + enough(factor * finest->spacing) + " m or more" +
                       (alone ? "" : " here and as many times more in the other sets"),
                   "about " + count_text(blocks) + " from " + number(finest->spacing) + " m");
}

// 1 / size² over the region, in m²/m²: from below. Each of the samples takes the largest size of its neighbourhood,
// so that one fine spot between coarse ones does not count for all of its cell.
double squares_of(const Region& region) {
  const Mesh& mesh = region.mesh;
  if (!mesh.size_at) return area_of(region) / (mesh.size * mesh.size);
  constexpr int samples = 48;
  const Eigen::AlignedBox2d box = box_of(region.outlines[0]);
  const Vec2 step = box.sizes() / samples;
  std::vector<double> size(samples * samples, 0);
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const Vec2 p = box.min() + Vec2((i + 0.5) * step.x(), (j + 0.5) * step.y());
      const auto in_hole = [&p](const Hole& hole) { return contains(hole.outline, p); };
      if (!contains(region.outlines[0], p) || std::any_of(region.holes.begin(), region.holes.end(), in_hole)) continue;
      size[i * samples + j] = mesh.size_at(p);
    }
  double sum = 0;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      if (size[i * samples + j] <= 0) continue;
      double largest = 0;
      for (int m = std::max(0, i - 1); m <= std::min(samples - 1, i + 1); ++m)
        for (int n = std::max(0, j - 1); n <= std::min(samples - 1, j + 1); ++n)
          largest = std::max(largest, size[m * samples + n]);
      sum += step.prod() / (largest * largest);
    }
  return sum;
}

void check_mesh(const Region& region, long most) {
  const Mesh& mesh = region.mesh;
  if (mesh.kind == MeshKind::none || mesh.kind == MeshKind::given) return;
  const double limit = static_cast<double>(most);
  const Place& place = mesh.place.file.empty() ? region.place : mesh.place;
  const std::string field = "mesh of region \"" + region.name + "\"";
  const bool triangles = mesh.kind == MeshKind::triangles, grains = mesh.kind == MeshKind::voronoi;
  // Per square of the size, at least.
  const double each = grains ? 0.9 : triangles ? 2.25 : mesh.kind == MeshKind::cross ? 4 : 2;
  if (mesh.nx > 0 && mesh.ny > 0) {
    const double blocks = each * mesh.nx * mesh.ny;
    if (blocks <= limit) return;
    throw InputError(
        place, field, limit_text(most) + ", so nx*ny of " + count_text(std::floor(limit / each)) + " or less",
        count_text(blocks) + " from nx = " + std::to_string(mesh.nx) + ", ny = " + std::to_string(mesh.ny));
  }
  const double blocks = each * squares_of(region);
  if (!(blocks > limit)) return;
  if (!std::isfinite(blocks)) throw InputError(place, field, limit_text(most), "more than can be counted");
  const double factor = std::sqrt((triangles ? 2.45 / 2.25 : grains ? 1.1 / 0.9 : 1) * blocks / limit);
  if (mesh.size_at)
    throw InputError(place, field, limit_text(most) + ", so sizes " + enough(factor) + " times as large",
                     "about " + count_text(blocks));
  throw InputError(place, field, limit_text(most) + ", so a size of " + enough(factor * mesh.size) + " m or more",
                   "about " + count_text(blocks) + " from " + number(mesh.size) + " m");
}

// Sums of squares of forces are still numbers.
void check_weight(const Scene& scene, const Region& region) {
  constexpr double most = 1e100;  // N/m
  const double weight = scene.materials[region.material].density * area_of(region) * scene.gravity.norm();
  if (weight < most) return;
  throw InputError(
      scene.time.place, "simulation.gravity", "less than " + number(most) + " N/m for the weight of a region",
      number(weight) + " N/m for region \"" + region.name + "\" under " + pair_text(scene.gravity) + " m/s2");
}

}  // namespace

void check_contact_rules(const Scene& scene) {
  const auto pair_of = [](const ContactRule& rule) { return std::minmax(rule.region_a, rule.region_b); };
  for (auto rule = scene.contact_rules.begin(); rule != scene.contact_rules.end(); ++rule)
    for (auto other = scene.contact_rules.begin(); other != rule; ++other)
      if (pair_of(*rule) == pair_of(*other) && rule->property != other->property)
        throw InputError(rule->place, "contact.between", "a pair of regions that no other rule is for",
                         "\"" + scene.regions[rule->region_a].name + "\" and \"" + scene.regions[rule->region_b].name +
                             "\", which have another joint already");
}

void check_regions(Scene& scene) {
  if (scene.regions.empty()) throw InputError(scene.time.place, "regions", "at least one region", "none");
  for (Region& region : scene.regions) {
    const std::string field = "outline of region \"" + region.name + "\"";
    for (size_t i = 0; i < region.outlines.size(); ++i)
      check_outline(region.outlines[i], region.place,
                    region.outlines.size() == 1 ? field : field + ", block " + std::to_string(i + 1));
    check_holes(region);
    check_weight(scene, region);
    check_joint_sets(region, scene.max_blocks);
    check_mesh(region, scene.max_blocks);
  }
  check_overlaps(scene);
}

}  // namespace talus
