#include "equations/boundary_terms.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "equations/side.h"
#include "model/gauss.h"

namespace talus {

namespace {

// A traction that is the same all along an edge: its sum in the middle of a first-order block's edge, of a second-order
// one at two of Gauss's points, which are exact for what is quadratic along it.
void spread(const BlockShape& shape, const Pose& pose, int block, const std::array<Vec2, 2>& edge, const Vec2& middle,
            const Vec2& force, const LoadVisitor& visit) {
  if (!shape.second_order()) return visit(block, {(edge[0] + edge[1]) / 2, middle}, force);
  for (const GaussPoint& point : gauss_points(2)) {
    const Vec2 in_block = between(edge, point.at);
    visit(block, {in_block, pose.place(in_block)}, point.share * force);
  }
}

}  // namespace

void each_load(const Model& model, const Poses& poses, double time, const LoadVisitor& visit) {
  for (const PointForce& point : model.point_forces) {
    if (model.sleeps(point.block)) continue;
    const PointLoad& load = model.scene.point_loads[point.load];
    visit(point.block, {point.in_block, poses.blocks[point.block].place(point.in_block)},
          point.share * Vec2(model.load(load.force[0], time), model.load(load.force[1], time)));
  }
  for (const EdgeForce& edge : model.edge_forces) {
    if (model.sleeps(edge.block)) continue;
    const EdgeLoad& load = model.scene.edge_loads[edge.load];
    const Pose& pose = poses.blocks[edge.block];
    const Vec2 from = pose.place(edge.in_block[0]), to = pose.place(edge.in_block[1]);
    const Vec2 force = load.is_pressure
                           ? Vec2(model.load(load.traction[0], time) * perp(to - from))
                           : Vec2((edge.in_block[1] - edge.in_block[0]).norm() *
                                  Vec2(model.load(load.traction[0], time), model.load(load.traction[1], time)));
    spread(model.shapes[edge.block], pose, edge.block, edge.in_block, (from + to) / 2, force, visit);
  }
}

void each_gas_load(const Model& model, const Poses& poses, const LoadVisitor& visit) {
  for (const GasFace& face : model.gas_faces) {
    const Pose& pose = poses.blocks[face.block];
    const Vec2 from = pose.place(face.in_block[0]), to = pose.place(face.in_block[1]);
    const Vec2 force = model.gas_pressure[face.chamber] * perp(to - from);
    if (!model.shapes[face.block].second_order()) {
      visit(face.block, {(face.in_block[0] + face.in_block[1]) / 2, (from + to) / 2}, force);
      continue;
    }
    // The derivative of the area beside a parabola through the ends and the middle (gas_volume): by its corner w =
    // 4/3 middle - (from + to)/6.
    const Vec2 middle = (face.in_block[0] + face.in_block[1]) / 2, at = pose.place(middle);
    const Vec2 corner = 4 * at / 3 - (from + to) / 6;
    const auto half = [&](const Vec2& span) -> Vec2 { return model.gas_pressure[face.chamber] / 2 * perp(span); };
    visit(face.block, {face.in_block[0], from}, half(corner - from) - force / 12);
    visit(face.block, {middle, at}, 2 * force / 3);
    visit(face.block, {face.in_block[1], to}, half(to - corner) - force / 12);
  }
}

namespace {

// m/s, by which a held block is faster at the end of a step than on its mean, and slower at the start: by the parabola
// through its places then and in between. What is rounding of these is none, so that at a steady speed nothing changes
// from step to step.
Vec2 rising(const Model& model, int block, double dt) {
  if (model.held_by[block] < 0 || dt == 0) return Vec2::Zero();
  const Fixity& fixity = model.scene.fixities[model.held_by[block]];
  const Vec2 start = fixity.moved(model.time), middle = fixity.moved(model.time + dt / 2),
             end = fixity.moved(model.time + dt);
  const Vec2 bend = start - 2 * middle + end;
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  return bend.norm() <= rounding * std::max(start.norm(), end.norm()) ? Vec2::Zero() : Vec2(2 / dt * bend);
}

}  // namespace

void move_held_blocks(Model& model, double dt) {
  model.held_faster.resize(model.held_blocks.size());
  model.held_rising.resize(model.held_blocks.size(), Vec2::Zero());
  for (size_t k = 0; k < model.held_blocks.size(); ++k) {
    const int b = model.held_blocks[k];
    auto& velocity = model.blocks[b].velocity;
    const auto now = held_velocity(model, b, dt);
    const Vec2 rises = rising(model, b, dt),
               change = Vec2(now[0] - velocity[0], now[1] - velocity[1]) + rises - model.held_rising[k];
    model.held_faster[k] = {change.x(), change.y(), now[2] - velocity[2]};
    model.held_rising[k] = rises;
    std::ranges::copy(now, velocity.begin());
  }
}

std::array<double, rigid_dofs> held_velocity(const Model& model, int block, double dt) {
  if (model.held_by[block] < 0 || dt == 0) return {};
  const Fixity& fixity = model.scene.fixities[model.held_by[block]];
  const Vec2 v = (fixity.moved(model.time + dt) - model.blocks[block].shift) / dt;
  return {v.x(), v.y(), fixity.spin * model.shapes[block].length};
}

void place_held_blocks(Model& model) {
  std::unordered_map<int, Vec2> moved;
  for (const int b : model.held_blocks) {
    if (model.held_by[b] < 0) continue;
    const Vec2 to = model.moved(model.scene.fixities[model.held_by[b]], model.time);
    if (to == model.blocks[b].shift) continue;
    moved[b] = to - model.blocks[b].shift;
    model.blocks[b].shift = to;
    model.blocks[b].centroid = model.shapes[b].reference_centroid + to;
  }
  if (moved.empty()) return;
  const auto move = [&](int block) { return moved.contains(block) ? moved[block] : Vec2(Vec2::Zero()); };
  for (Contact& c : model.contacts) {
    const int next = model.shapes[c.j].vertex_begin + model.next_vertex(c.j, c.edge);
    c.stretch += (model.vertex[next] - model.vertex[c.global_edge]).normalized().dot(move(c.i) - move(c.j));
  }
  model.place_vertices();
}

void add_force(const Model& model, const Poses& poses, int block, const LoadPoint& point, const Vec2& force,
               System& system) {
  const BlockShape& shape = model.shapes[block];
  with_size(shape.second_order(),
            [&](auto n) { system.add_force(shape, block, force_on<n>(poses.blocks[block], point, force)); });
}

void add_loads(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  const LoadVisitor add = [&](int block, const LoadPoint& point, const Vec2& force) {
    add_force(model, poses, block, point, force, system);
  };
  each_load(model, poses, model.time + scheme.load_time, add);
  each_gas_load(model, poses, add);
}

}  // namespace talus
