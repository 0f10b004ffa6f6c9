#include "equations/viscous_terms.h"

#include <cmath>

#include "equations/side.h"

namespace talus {

namespace {

// The springs give way by this part of what the block behind them is strained, as a fixed edge does (joint_terms.cpp).
constexpr double hold_factor = 1000;

// Velocities and displacements are linear along the edge: two Gauss points are exact for what is quadratic in them.
Vec2 gauss_point(const ViscousEdge& edge, int point) {
  const double reach = std::sqrt(3.0) / 6;
  return between(edge.in_block, point == 0 ? 0.5 - reach : 0.5 + reach);
}
constexpr int gauss_points = 2;

double weight(const ViscousEdge& edge) { return edge.length / gauss_points; }

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

DofMatrix damping(const Model& model, const ViscousEdge& edge, const Pose& pose) {
  const Mat2 z = impedance(model.material(edge.block), pose.rotation.turn(edge.normal));
  DofMatrix c = DofMatrix::Zero();
  for (int p = 0; p < gauss_points; ++p) {
    const DofRows t = pose.rows(pose.place(gauss_point(edge, p)));
    c += weight(edge) * t.transpose() * z * t;
  }
  return c;
}

void add_hold(const Model& model, const ViscousEdge& edge, const Pose& pose, System& system) {
  const double k = hold_stiffness(model, edge.block) * weight(edge);
  DofColumn force = DofColumn::Zero();
  DofMatrix matrix = DofMatrix::Zero();
  for (int p = 0; p < gauss_points; ++p) {
    const Vec2 at = gauss_point(edge, p);
    const DofRows t = pose.rows(pose.place(at));
    force -= k * t.transpose() * pose.displacement(at);
    matrix += k * t.transpose() * t;
  }
  system.add_force(model.shapes[edge.block], edge.block, force);
  system.add_rounding(edge.block, gauss_points * k, pose.shift.norm());
  system.matrix.add(system.matrix.slot(edge.block, edge.block), false, matrix);
}

void add_dashpots(const Model& model, const ViscousEdge& edge, const Pose& pose, const Scheme& scheme,
                  System& system) {
  const DofMatrix c = damping(model, edge, pose);
  const DofColumn v0 = Eigen::Map<const DofColumn>(pose.velocity.data());
  system.add_force(model.shapes[edge.block], edge.block, -c * v0);
  system.matrix.add(system.matrix.slot(edge.block, edge.block), false, DofMatrix(scheme.velocity_d / 2 * c));
}

}  // namespace

void add_viscous_edges(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  const bool motion = scheme.step_v > 0;
  for (const ViscousEdge& edge : model.viscous_edges) {
    if (model.sleeps(edge.block)) continue;
    const Pose& pose = poses.blocks[edge.block];
    if (motion)
      add_dashpots(model, edge, pose, scheme, system);
    else
      add_hold(model, edge, pose, system);
  }
  if (!motion) return;
  each_viscous_traction(model, poses, [&](int block, const Vec2& at, const Vec2& force) {
    system.add_force(model.shapes[block], block, poses.blocks[block].rows(at).transpose() * force);
  });
}

void keep_viscous_tractions(Model& model) {
  for (ViscousEdge& edge : model.viscous_edges) {
    const Pose pose = flown(model, edge.block, 0);
    for (int p = 0; p < gauss_points; ++p)
      edge.traction[p] = -hold_stiffness(model, edge.block) * pose.displacement(gauss_point(edge, p));
  }
}

double viscous_hold_energy(const Model& model) {
  double sum = 0;
  for (const ViscousEdge& edge : model.viscous_edges) {
    const Pose pose = flown(model, edge.block, 0);
    for (int p = 0; p < gauss_points; ++p)
      sum += hold_stiffness(model, edge.block) * weight(edge) * pose.displacement(gauss_point(edge, p)).squaredNorm() / 2;
  }
  return sum;
}

void each_viscous_traction(const Model& model, const Poses& poses, const LoadVisitor& visit) {
  for (const ViscousEdge& edge : model.viscous_edges) {
    if (model.sleeps(edge.block)) continue;
    for (int p = 0; p < gauss_points; ++p)
      visit(edge.block, poses.blocks[edge.block].place(gauss_point(edge, p)), weight(edge) * edge.traction[p]);
  }
}

double viscous_form(const Model& model, const Poses& poses, const Vector& a, const Vector& b) {
  double sum = 0;
  for (const ViscousEdge& edge : model.viscous_edges) {
    if (model.sleeps(edge.block)) continue;
    const BlockShape& shape = model.shapes[edge.block];
    const DofMatrix c = damping(model, edge, poses.blocks[edge.block]);
    sum += a.segment(shape.dof_begin, shape.dofs)
               .dot(c.topLeftCorner(shape.dofs, shape.dofs) * b.segment(shape.dof_begin, shape.dofs));
  }
  return sum;
}

}  // namespace talus
