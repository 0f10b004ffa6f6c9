#include "equations/boundary_terms.h"

#include <cmath>

namespace talus {

namespace {

void add_point_fixities(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  const double time = model.time + scheme.hold_time;
  for (const PointFixity& point : model.point_fixities) {
    const BlockShape& shape = model.shapes[point.block];
    if (shape.dofs == 0) continue;
    const Fixity& fixity = model.scene.fixities[point.fixity];
    const Pose& pose = poses.blocks[point.block];
    const Vec2 place = pose.place(point.in_block);
    const DofRows t = pose.rows(place);
    const DofColumn velocity = Eigen::Map<const DofColumn>(pose.velocity.data());
    const Mat2 stiffness = point.stiffness * Vec2(fixity.held[0], fixity.held[1]).asDiagonal().toDenseMatrix();
    const Vec2 gap =
        fixity_displacement(fixity, time) - pose.displacement(point.in_block) - scheme.bond_v * t * velocity;
    system.add_force(shape, point.block, t.transpose() * stiffness * gap);
    system.matrix.add(system.matrix.slot(point.block, point.block), false,
                      DofMatrix(scheme.bond_d * t.transpose() * stiffness * t));
  }
}

void add_point_loads(const Model& model, const Poses& poses, double time, System& system) {
  for (const PointForce& point : model.point_forces) {
    const PointLoad& load = model.scene.point_loads[point.load];
    const Vec2 force = point.share * Vec2(load.force[0].at(time), load.force[1].at(time));
    const Pose& pose = poses.blocks[point.block];
    system.add_force(model.shapes[point.block], point.block,
                     pose.rows(pose.place(point.in_block)).transpose() * force);
  }
}

// A pressure follows its edge: it pushes along the inward normal of the edge as it lies now.
void add_edge_loads(const Model& model, const Poses& poses, double time, System& system) {
  for (const EdgeForce& edge : model.edge_forces) {
    const EdgeLoad& load = model.scene.edge_loads[edge.load];
    const Pose& pose = poses.blocks[edge.block];
    const Vec2 from = pose.place(edge.in_block[0]), to = pose.place(edge.in_block[1]);
    const Vec2 force = load.is_pressure ? Vec2(load.traction[0].at(time) * perp(to - from))
                                        : Vec2((edge.in_block[1] - edge.in_block[0]).norm() *
                                               Vec2(load.traction[0].at(time), load.traction[1].at(time)));
    system.add_force(model.shapes[edge.block], edge.block, pose.rows((from + to) / 2).transpose() * force);
  }
}

}  // namespace

Vec2 fixity_displacement(const Fixity& fixity, double t) {
  if (fixity.motion == Fixity::none || t <= 0) return Vec2::Zero();
  if (fixity.motion == Fixity::displacement) return {fixity.value[0].at(t), fixity.value[1].at(t)};
  return {fixity.value[0].integral(t), fixity.value[1].integral(t)};
}

void move_held_blocks(Model& model, double dt) {
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    if (model.shapes[b].dofs > 0) continue;
    BlockState& state = model.blocks[b];
    state.velocity.fill(0);
    if (model.held_by[b] < 0 || dt == 0) continue;
    const Fixity& fixity = model.scene.fixities[model.held_by[b]];
    const Vec2 v = (fixity_displacement(fixity, model.time + dt) - state.shift) / dt;
    state.velocity = {v.x(), v.y(), fixity.spin * model.shapes[b].length};
  }
}

void place_held_blocks(Model& model) {
  for (size_t b = 0; b < model.shapes.size(); ++b)
    if (model.shapes[b].dofs == 0 && model.held_by[b] >= 0) {
      model.blocks[b].shift = fixity_displacement(model.scene.fixities[model.held_by[b]], model.time);
      model.blocks[b].centroid = model.shapes[b].reference_centroid + model.blocks[b].shift;
    }
  model.place_vertices();
}

void add_boundary_terms(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  const double time = model.time + scheme.load_time;
  add_point_fixities(model, poses, scheme, system);
  add_point_loads(model, poses, time, system);
  add_edge_loads(model, poses, time, system);
}

}  // namespace talus
