#include "equations/viscous_terms.h"

#include <cmath>

#include "equations/side.h"
#include "model/gauss.h"

namespace talus {

namespace {

// The springs give way by this part of what the block behind them is strained, as a fixed edge does (joint_terms.cpp).
constexpr double hold_factor = 1000;

// An integration point of the edge.
struct EdgePoint {
  int number;
  Vec2 in_block;
  double weight;  // m
};

std::vector<EdgePoint> points_of(const Model& model, const ViscousEdge& edge) {
  std::vector<EdgePoint> points;
  for (const GaussPoint& point : gauss_points(model.shapes[edge.block]))
    points.push_back({int(points.size()), between(edge.in_block, point.at), edge.length * point.share});
  return points;
}

// N/m3: E' / √area, many times.
double hold_stiffness(const Model& model, int block) {
  return hold_factor * elasticity(model.material(block))(0, 0) / model.shapes[block].length;
}

// ρ c along and across the normal, Pa s/m: ρ c = √(ρ D) with the modulus D of the wave in the material's plane state.
Mat2 impedance(const Material& material, const Vec2& n) {
  const Mat3 d = elasticity(material);
  const Vec2 s = perp(n);
  return std::sqrt(material.density * d(0, 0)) * n * n.transpose() +
         std::sqrt(material.density * d(2, 2)) * s * s.transpose();
}

template <int n>
MatrixOf<n> damping(const Model& model, const ViscousEdge& edge, const Pose& pose) {
  const Mat2 z = impedance(model.material(edge.block), pose.rotation.turn(edge.normal));
  MatrixOf<n> c = MatrixOf<n>::Zero();
  for (const EdgePoint& point : points_of(model, edge)) {
    const RowsOf<n> t = pose.rows<n>(point.in_block, pose.place(point.in_block));
    c += point.weight * t.transpose() * z * t;
  }
  return c;
}

template <int n>
void add_hold(const Model& model, const ViscousEdge& edge, const Pose& pose, System& system) {
  const double stiffness = hold_stiffness(model, edge.block);
  ColumnOf<n> force = ColumnOf<n>::Zero();
  MatrixOf<n> matrix = MatrixOf<n>::Zero();
  for (const EdgePoint& point : points_of(model, edge)) {
    const double k = stiffness * point.weight;
    const RowsOf<n> t = pose.rows<n>(point.in_block, pose.place(point.in_block));
    force -= k * t.transpose() * pose.displacement(point.in_block);
    matrix += k * t.transpose() * t;
  }
  system.add_force(model.shapes[edge.block], edge.block, force);
  system.add_rounding(edge.block, stiffness * edge.length, pose.shift.norm());
  system.matrix.add(system.matrix.slot(edge.block, edge.block), false, matrix);
}

template <int n>
void add_dashpots(const Model& model, const ViscousEdge& edge, const Pose& pose, const Scheme& scheme, System& system) {
  const MatrixOf<n> c = damping<n>(model, edge, pose);
  system.add_force(model.shapes[edge.block], edge.block, ColumnOf<n>(-c * pose.rates<n>()));
  system.matrix.add(system.matrix.slot(edge.block, edge.block), false, MatrixOf<n>(scheme.velocity_d / 2 * c));
}

}  // namespace

void add_viscous_edges(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  const bool motion = scheme.step_v > 0;
  for (const ViscousEdge& edge : model.viscous_edges) {
    if (model.sleeps(edge.block)) continue;
    const Pose& pose = poses.blocks[edge.block];
    with_size(model.shapes[edge.block].second_order(), [&](auto n) {
      if (motion)
        add_dashpots<n>(model, edge, pose, scheme, system);
      else
        add_hold<n>(model, edge, pose, system);
    });
  }
  if (!motion) return;
  each_viscous_traction(model, poses, [&](int block, const LoadPoint& point, const Vec2& force) {
    add_force(model, poses, block, point, force, system);
  });
}

void keep_viscous_tractions(Model& model) {
  for (ViscousEdge& edge : model.viscous_edges) {
    const Pose pose = flown(model, edge.block, 0);
    for (const EdgePoint& point : points_of(model, edge))
      edge.traction[point.number] = -hold_stiffness(model, edge.block) * pose.displacement(point.in_block);
  }
}

double viscous_hold_energy(const Model& model) {
  double sum = 0;
  for (const ViscousEdge& edge : model.viscous_edges) {
    const Pose pose = flown(model, edge.block, 0);
    for (const EdgePoint& point : points_of(model, edge))
      sum += hold_stiffness(model, edge.block) * point.weight * pose.displacement(point.in_block).squaredNorm() / 2;
  }
  return sum;
}

void each_viscous_traction(const Model& model, const Poses& poses, const LoadVisitor& visit) {
  for (const ViscousEdge& edge : model.viscous_edges) {
    if (model.sleeps(edge.block)) continue;
    for (const EdgePoint& point : points_of(model, edge))
      visit(edge.block, {point.in_block, poses.blocks[edge.block].place(point.in_block)},
            point.weight * edge.traction[point.number]);
  }
}

ViscousForms viscous_forms(const Model& model, const Poses& poses, const TwoOfBlock& of) {
  ViscousForms sum;
  for (const ViscousEdge& edge : model.viscous_edges) {
    if (model.sleeps(edge.block)) continue;
    const int dofs = model.shapes[edge.block].dofs;
    const auto [a, b] = of(edge.block);
    with_size(model.shapes[edge.block].second_order(), [&](auto n) {
      const MatrixOf<n> whole = damping<n>(model, edge, poses.blocks[edge.block]);
      const auto c = whole.topLeftCorner(dofs, dofs);
      sum.own += a.head(dofs).dot(c * a.head(dofs));
      sum.mixed += a.head(dofs).dot(c * b.head(dofs));
    });
  }
  return sum;
}

}  // namespace talus
