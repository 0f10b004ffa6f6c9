#include "equations/boundary_terms.h"

namespace talus {

void each_load(const Model& model, const Poses& poses, double time, const LoadVisitor& visit) {
  for (const PointForce& point : model.point_forces) {
    if (model.sleeps(point.block)) continue;
    const PointLoad& load = model.scene.point_loads[point.load];
    visit(point.block, poses.blocks[point.block].place(point.in_block),
          point.share * Vec2(load.force[0].at(time), load.force[1].at(time)));
  }
  for (const EdgeForce& edge : model.edge_forces) {
    if (model.sleeps(edge.block)) continue;
    const EdgeLoad& load = model.scene.edge_loads[edge.load];
    const Pose& pose = poses.blocks[edge.block];
    const Vec2 from = pose.place(edge.in_block[0]), to = pose.place(edge.in_block[1]);
    const Vec2 force = load.is_pressure ? Vec2(load.traction[0].at(time) * perp(to - from))
                                        : Vec2((edge.in_block[1] - edge.in_block[0]).norm() *
                                               Vec2(load.traction[0].at(time), load.traction[1].at(time)));
    visit(edge.block, (from + to) / 2, force);
  }
}

void each_gas_load(const Model& model, const Poses& poses, const LoadVisitor& visit) {
  for (const GasFace& face : model.gas_faces) {
    const Pose& pose = poses.blocks[face.block];
    const Vec2 from = pose.place(face.in_block[0]), to = pose.place(face.in_block[1]);
    visit(face.block, (from + to) / 2, model.gas_pressure[face.chamber] * perp(to - from));
  }
}

void move_held_blocks(Model& model, double dt) {
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    if (model.shapes[b].dofs > 0) continue;
    model.blocks[b].velocity = held_velocity(model, int(b), dt);
  }
}

std::array<double, max_dofs> held_velocity(const Model& model, int block, double dt) {
  if (model.held_by[block] < 0 || dt == 0) return {};
  const Fixity& fixity = model.scene.fixities[model.held_by[block]];
  const Vec2 v = (fixity_displacement(fixity, model.time + dt) - model.blocks[block].shift) / dt;
  return {v.x(), v.y(), fixity.spin * model.shapes[block].length};
}

void place_held_blocks(Model& model) {
  for (size_t b = 0; b < model.shapes.size(); ++b)
    if (model.shapes[b].dofs == 0 && model.held_by[b] >= 0) {
      model.blocks[b].shift = fixity_displacement(model.scene.fixities[model.held_by[b]], model.time);
      model.blocks[b].centroid = model.shapes[b].reference_centroid + model.blocks[b].shift;
    }
  model.place_vertices();
}

void add_loads(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  each_load(model, poses, model.time + scheme.load_time, [&](int block, const Vec2& at, const Vec2& force) {
    system.add_force(model.shapes[block], block, poses.blocks[block].rows(at).transpose() * force);
  });
  each_gas_load(model, poses, [&](int block, const Vec2& at, const Vec2& force) {
    system.add_force(model.shapes[block], block, poses.blocks[block].rows(at).transpose() * force);
  });
}

}  // namespace talus
