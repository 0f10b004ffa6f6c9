#pragma once
// Models made by hand, without build(): two unit squares side by side, one joint, one contact.
#include <algorithm>
#include <cmath>

#include "model/fragments.h"
#include "model/model.h"

namespace talus::test {

inline Polyline rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

// A block of the outline, whose centroid is the mean of its corners (rectangles).
inline void add_block(Model& model, const Polyline& outline, int dofs, int region) {
  BlockShape shape;
  shape.dofs = dofs;
  shape.region = region;
  for (const Vec2& p : outline) shape.reference_centroid += p / static_cast<double>(outline.size());
  shape.vertex_begin = static_cast<int>(model.reference_vertex.size());
  for (const Vec2& p : outline) model.reference_vertex.push_back(p - shape.reference_centroid);
  shape.vertex_end = static_cast<int>(model.reference_vertex.size());
  const Vec2 size = outline[2] - outline[0];
  shape.area = size.x() * size.y();
  shape.length = std::sqrt(shape.area);
  shape.radius = size.norm() / 2;
  BlockState state;
  state.centroid = shape.reference_centroid;
  if (dofs == 0) model.held_blocks.push_back(int(model.shapes.size()));
  model.shapes.push_back(shape);
  model.blocks.push_back(state);
  model.held_by.push_back(-1);
  model.fragment.push_back(int(model.fragment.size()));
}

// Block 0 (first order, region "left") on [0, 1] × [0, 1]; block 1 (held, region "right") on [1, 2] × [0, 1].
// The origin is (100, 50): what is user coordinates must show it.
inline Model two_squares() {
  Model model;
  model.origin = {100, 50};
  Material rock;
  rock.name = "rock";
  rock.density = 2000;
  rock.young = 1e9;
  rock.poisson = 0.25;
  rock.plane = Plane::strain;
  model.scene.materials = {rock};
  JointProperty bond;
  bond.name = "bond <1>";
  model.scene.properties = {bond};
  model.scene.regions.resize(2);
  model.scene.regions[0].name = "left";
  model.scene.regions[1].name = "right";
  add_block(model, rectangle(0, 0, 1, 1), 6, 0);
  add_block(model, rectangle(1, 0, 1, 1), 0, 1);
  model.shapes[1].dof_begin = model.dofs = 6;

  Joint joint;  // along x = 1, upwards: block 0 on its left
  joint.a = 0;
  joint.b = 1;
  joint.length = 1;
  joint.normal = {1, 0};
  joint.in_a = {Vec2(0.5, -0.5), Vec2(0.5, 0.5)};
  joint.in_b = {Vec2(-0.5, -0.5), Vec2(-0.5, 0.5)};
  joint.points[0] = {.at = 0.25, .weight = 0.75, .normal = 400, .shear = -8, .opening = 0.004, .slip = 0.04};
  joint.points[1] = {.at = 0.75, .weight = 0.25, .normal = 800, .shear = 16, .opening = 0.008, .slip = 0.08};
  model.joints = {joint};
  model.fragment = find_fragments(model);

  Contact contact;  // vertex 1 = (1, 0) of block 0 on edge 3 of block 1, which runs from (1, 1) down to (1, 0)
  contact.i = 0;
  contact.vertex = contact.global_vertex = 1;
  contact.j = 1;
  contact.edge = 3;
  contact.global_edge = 7;
  contact.kind = ContactKind::edge_edge;
  contact.state = ContactState::slip;
  contact.length = 0.5;
  contact.gap = -1e-4;
  contact.stretch = 2e-5;
  contact.slip = 3e-3;
  contact.normal_force = 1000;
  contact.shear_force = 250;
  model.contacts = {contact};

  model.scene.probes.resize(1);
  model.scene.probes[0].name = "tip";
  model.probes = {{.probe = 0, .block = 0, .in_block = {0.5, 0.5}}};
  model.place_vertices();
  return model;
}

// Block 0 shifted by (0.1, 0.2), turned by 90°, strained in its own axes.
inline Model moved_squares() {
  Model model = two_squares();
  BlockState& state = model.blocks[0];
  state.centroid += Vec2(0.1, 0.2);
  state.angle = std::acos(0.0);
  state.strain = {0.001, -0.002, 0.0004};
  state.velocity = {3, 4, 0.5, 0, 0, 0};
  model.place_vertices();
  return model;
}

}  // namespace talus::test
