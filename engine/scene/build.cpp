#include "scene/build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

#include "model/fragments.h"
#include "scene/build_parts.h"

namespace talus {

namespace {

Polyline outline_points(const Scene& scene) {
  Polyline points;
  for (const Region& region : scene.regions)
    for (const Polyline& outline : region.outlines) points.insert(points.end(), outline.begin(), outline.end());
  return points;
}

double extent_along(const Polyline& points, const Vec2& direction) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Vec2& p : points) {
    least = std::min(least, p.dot(direction));
    most = std::max(most, p.dot(direction));
  }
  return most - least;
}

// Along gravity; without it along the narrowest extent: either turns with the scene, as its y need not.
double half_height(const Polyline& points, const Vec2& gravity) {
  const Polyline hull = convex_hull(points);
  Vec2 along = gravity.normalized();
  if (gravity.isZero(0)) {
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < hull.size(); ++i) {  // narrowest across one of the hull's edges
      const Vec2 across = perp(Vec2(hull[(i + 1) % hull.size()] - hull[i])).normalized();
      const double extent = extent_along(hull, across);
      if (extent < least) least = extent, along = across;
    }
  }
  const double height = extent_along(hull, along), width = extent_along(hull, perp(along));
  const bool flat = std::min(height, width) <= 1e-3 * std::max(height, width);
  return (flat ? std::max(height, width) : height) / 2;
}

// Everything geometric moves to the model's origin, so that a scene 10 km away keeps its digits.
void shift(Scene& scene, const Vec2& origin) {
  const auto move = [&origin](Polyline& line) {
    for (Vec2& p : line) p -= origin;
  };
  for (Region& region : scene.regions) {
    for (Polyline& outline : region.outlines) move(outline);
    for (Hole& hole : region.holes) move(hole.outline);
    for (Trace& trace : region.traces) move(trace.points);
    for (JointSet& set : region.joint_sets)
      if (set.through) *set.through -= origin;
    if (region.mesh.size_at)
      region.mesh.size_at = [inner = region.mesh.size_at, origin](Vec2 p) { return inner(p + origin); };
    if (region.order_at) region.order_at = [inner = region.order_at, origin](Vec2 p) { return inner(p + origin); };
  }
  const auto move_on = [&origin](On& on) {
    on.from -= origin;
    on.to -= origin;
  };
  for (Fixity& fixity : scene.fixities) move_on(fixity.on);
  for (EdgeLoad& load : scene.edge_loads) move_on(load.on);
  for (ViscousBoundary& boundary : scene.viscous_boundaries) move_on(boundary.on);
  for (PointLoad& load : scene.point_loads) load.at -= origin;
  for (Probe& probe : scene.probes) probe.at -= origin;
}

// Regions that name no contact property touch with a friction angle of 30°, a usual value for clean rock joints.
void default_contact(Scene& scene) {
  if (scene.contact >= 0) return;
  JointProperty property;
  property.name = "default contact";
  property.friction = std::numbers::pi / 6;
  scene.properties.push_back(property);
  scene.contact = int(scene.properties.size()) - 1;
}

void number_unknowns(Model& model) {
  model.dofs = 0;
  model.held_blocks.clear();
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    BlockShape& shape = model.shapes[b];
    shape.dof_begin = model.dofs;
    model.dofs += shape.dofs;
    if (shape.dofs == 0) model.held_blocks.push_back(int(b));
  }
}

// The flux of a bond is taken from the softer side more than from the stiffer: w_a = E_b / (E_a + E_b);
// a rigid block has no stress, so its share is 0.
void share_fluxes(Model& model) {
  for (Joint& joint : model.joints) {
    const bool soft_a = model.shapes[joint.a].dofs > rigid_dofs, soft_b = model.shapes[joint.b].dofs > rigid_dofs;
    const double young_a = model.material(joint.a).young, young_b = model.material(joint.b).young;
    joint.weight_a = !soft_a ? 0 : !soft_b ? 1 : young_b / (young_a + young_b);
    joint.weight_b = !soft_b ? 0 : 1 - joint.weight_a;
  }
}

// Strengths of bonds about that of their property, which is their mean: Weibull's distribution, drawn in order of the
// joints by a generator that is the same on every machine.
void scatter_strengths(Model& model) {
  std::vector<std::mt19937_64> draw;
  for (const JointProperty& property : model.scene.properties) draw.emplace_back(property.seed);
  for (Joint& joint : model.joints) {
    const double modulus = model.scene.properties[joint.property].weibull;
    if (!joint.bonded || modulus == 0) continue;
    const double part = (double(draw[joint.property]() >> 11) + 0.5) * 0x1p-53;  // in (0, 1)
    joint.scatter = std::pow(-std::log(part), 1 / modulus) / std::tgamma(1 + 1 / modulus);
  }
}

// A joint with cohesion that is no joint anywhere: a pile of rock is not glued, but an interface between regions may
// have been meant.
void note_cohesion(Model& model) {
  const Scene& scene = model.scene;
  std::set<int> of_contacts{scene.contact}, of_joints;
  for (const ContactRule& rule : scene.contact_rules) of_contacts.insert(rule.property);
  for (const Region& region : scene.regions)
    if (region.outlines.size() > 1 && region.mesh.kind == MeshKind::none && region.joint >= 0)
      of_contacts.insert(region.joint);
  for (const Joint& joint : model.joints) of_joints.insert(joint.property);
  for (const int p : of_contacts)
    if (p >= 0 && scene.properties[size_t(p)].breaks && !of_joints.contains(p))
      model.notes.push_back(
          "joint \"" + scene.properties[size_t(p)].name +
          "\": contacts between blocks carry its friction alone; cohesion and tension are those of bonds and traces");
}

// A block that does not strain has no stress to press what is beside it with.
void note_rigid_stress(Model& model) {
  std::vector<int> rigid(model.scene.regions.size(), 0);
  for (const BlockShape& shape : model.shapes) rigid[size_t(shape.region)] += shape.dofs == rigid_dofs;
  for (size_t r = 0; r < rigid.size(); ++r)
    if (const Region& region = model.scene.regions[r]; region.stress && rigid[r] > 0)
      model.notes.push_back("region \"" + region.name + "\": " + std::to_string(rigid[r]) +
                            (rigid[r] == 1 ? " rigid block has" : " rigid blocks have") +
                            " no stress: its stress is that of blocks of order 1 and 2");
}

// Automatic steps stop at the rows of a table, but cannot know where a function will change.
void note_functions(Model& model) {
  const Scene& scene = model.scene;
  const TimeControl& time = scene.time;
  if (time.mode != Mode::dynamic || time.dt > 0 || time.dt_max > 0 || time.tolerance > 0) return;
  const auto note = [&](const std::string& what, const std::array<History, 2>& of) {
    if (of[0].is_function() || of[1].is_function())
      model.notes.push_back(
          what +
          ": a function of time, which automatic steps may pass over between the times they stop at; bound them by "
          "time.dt_max, or give a table, at whose rows they stop");
  };
  for (const PointLoad& load : scene.point_loads) note("load \"" + load.name + "\"", load.force);
  for (const EdgeLoad& load : scene.edge_loads) note("load \"" + load.name + "\"", load.traction);
  for (const Region& region : scene.regions) note("region \"" + region.name + "\": body_force", region.body_force);
  for (const Fixity& fixity : scene.fixities) note("fix \"" + fixity.name + "\"", fixity.value);
}

}  // namespace

Model build(Scene scene) {
  check_regions(scene);
  check_contact_rules(scene);
  default_contact(scene);
  Model model;
  doubt_units(scene, model.notes);
  const Polyline points = outline_points(scene);
  const Bounds box = bounds(points);
  // else the user's own coordinates
  if (box.centre().norm() > 10 * (box.max - box.min).norm()) model.origin = box.centre();
  model.extent = half_height(points, scene.gravity);
  shift(scene, model.origin);
  model.scene = std::move(scene);
  const std::vector<FreeEdge> edges = build_blocks(model);
  attach(model, edges);
  attach_charges(model, edges);
  number_unknowns(model);
  share_fluxes(model);
  scatter_strengths(model);
  note_cohesion(model);
  note_rigid_stress(model);
  note_functions(model);
  model.fragment = find_fragments(model);
  model.place_vertices();
  return model;
}

}  // namespace talus
