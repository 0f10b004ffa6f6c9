#include <gtest/gtest.h>

#include <cmath>

#include "assembled.h"
#include "equations/linear_solver.h"
#include "small_scene.h"
#include "step/simulation.h"
#include "step/update.h"

namespace talus {
namespace {

using test::Assembled;
using test::Dense;
using test::irregular;
using test::meshed;
using test::on_line;
using test::patterned;
using test::rectangle;
using test::scene_of;

// Unknowns of the displacement field u(x) = G x about the scene's origin, to first order.
Vector linear_field(const Model& model, const Mat2& gradient) {
  Vector d(model.dofs);
  for (const BlockShape& s : model.shapes) {
    d.segment<2>(s.dof_begin) = gradient * s.reference_centroid;
    d[s.dof_begin + 2] = s.length * (gradient(1, 0) - gradient(0, 1)) / 2;
    d.segment<3>(s.dof_begin + 3) = s.length * Vec3(gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0));
  }
  return d;
}

// Tractions σ n on every edge that no joint covers, holes included.
void load_boundary(Model& model, const Vec3& stress) {
  std::vector<char> bonded(model.reference_vertex.size(), 0);
  for (const Joint& joint : model.joints) {
    bonded[model.shapes[joint.a].vertex_begin + joint.edge_a] = 1;
    bonded[model.shapes[joint.b].vertex_begin + joint.edge_b] = 1;
  }
  for (int b = 0; b < int(model.shapes.size()); ++b)
    for (int v = 0; v < model.vertex_count(b); ++v) {
      const int begin = model.shapes[b].vertex_begin;
      if (bonded[begin + v]) continue;
      const Vec2 p = model.reference_vertex[begin + v], q = model.reference_vertex[begin + model.next_vertex(b, v)];
      const Vec2 n = -perp(q - p).normalized();
      model.edge_forces.push_back({int(model.scene.edge_loads.size()), b, {p, q}});
      model.scene.edge_loads.push_back(
          test::traction(0, {}, {stress[0] * n.x() + stress[2] * n.y(), stress[2] * n.x() + stress[1] * n.y()}));
    }
}

// The bonds are consistent: the exact field of a constant stress satisfies the equations, at every penalty.
TEST(Bonds, ALinearFieldGivesItsConstantStress) {
  const Vec3 stress(30, -20, 10);
  for (double penalty : {1.001, 1.1, 50.0}) {
    Model model = build(irregular(penalty));
    ASSERT_GT(model.shapes.size(), 50u);
    load_boundary(model, stress);
    const Vec3 strain = elasticity(model.material(0)).inverse() * stress;
    Mat2 gradient;
    gradient << strain[0], strain[2] / 2 + 0.01, strain[2] / 2 - 0.01, strain[1];
    Assembled all(model);
    const Vector exact = linear_field(model, gradient);
    Vector force = Vector::Zero(model.dofs);
    all.system.matrix.multiply(exact, force);
    EXPECT_LT((force - all.system.force).lpNorm<Eigen::Infinity>(), 1e-12 * all.dense().lpNorm<Eigen::Infinity>());

    // And no other does: held at the rigid modes of block 0, whose reactions are nought, K gives it back.
    all.system.matrix.add(all.system.matrix.slot(0, 0), false,
                          Dense((Vector(6) << 1e3, 1e3, 1e3, 0, 0, 0).finished().asDiagonal()));
    LinearSolver solver;
    solver.analyse(all.system.matrix);
    ASSERT_EQ(solver.factor(all.system.matrix), -1);
    Vector d;
    solver.solve(all.system.force, d);
    for (const BlockShape& s : model.shapes) {
      const Vec3 found = elasticity(model.material(0)) * d.segment<3>(s.dof_begin + 3) / s.length;
      EXPECT_LT((found - stress).norm(), 1e-10 * stress.norm());
    }
  }
}

// The same through the step, with edges bonded to the ground in one direction each. At strains of 1e-9 the
// geometry changes the stress by as much, and no more.
TEST(Bonds, PatchTestThroughTheStep) {
  Scene scene = scene_of({meshed("plate", rectangle(0, 0, 2, 1), 0.25)});
  scene.fixities = {test::fix(0, on_line({0, 0}, {0, 1}), true, false),
                    test::fix(0, on_line({0, 0}, {2, 0}), false, true)};
  scene.edge_loads = {test::traction(0, on_line({2, 0}, {2, 1}), {2e-6, 0}),
                      test::traction(0, on_line({0, 1}, {2, 1}), {0, -1e-6})};
  Simulation simulation(scene);
  simulation.step();
  const Vec3 stress(2e-6, -1e-6, 0);
  const Model& model = simulation.model;
  for (int b = 0; b < int(model.shapes.size()); ++b) EXPECT_LT((model.stress(b) - stress).norm(), 2e-8 * stress.norm());
  for (const Joint& joint : model.joints)
    for (const JointPoint& point : joint.points) {
      const Vec2 n = joint.normal, t(stress[0] * n.x(), stress[1] * n.y());
      EXPECT_NEAR(point.normal, t.dot(n), 2e-8 * stress.norm());
      EXPECT_NEAR(point.shear, t.dot(perp(n)), 2e-8 * stress.norm());
    }
}

// Moves the whole model by a finite rotation about the origin and a shift.
void turn(Model& model, double angle, const Vec2& shift) {
  for (size_t b = 0; b < model.blocks.size(); ++b) {
    BlockState& state = model.blocks[b];
    const Vec2 c = model.shapes[b].reference_centroid;
    state.shift = Rotation::of(angle).turn(c) - c + shift;
    state.centroid = c + state.shift;
    state.angle = angle;
  }
  model.place_vertices();
}

// K is minus the derivative of the forces: central differences over all unknowns, turned and not. A matrix whose
// upper triangle alone is kept passes only where the forces' derivative is symmetric.
TEST(Bonds, StiffnessIsTheDerivativeOfTheForces) {
  for (BondKind kind : {BondKind::exact, BondKind::spring})
    for (double angle : {0.0, 1.1}) {
      Scene scene = scene_of({patterned("box", rectangle(0, 0, 2, 1), MeshKind::cross, 2, 1)});
      scene.properties[0].bond = kind;
      Model model = build(scene);
      turn(model, angle, {0, 0});
      const Scheme scheme = Scheme::equilibrium();
      const Dense k = Assembled(model).dense();
      const double h = 1e-5;
      Dense derivative(model.dofs, model.dofs);
      for (int j = 0; j < model.dofs; ++j) {
        const auto force = [&](double step) {
          Model moved = model;
          moved.blocks = moved_blocks(model, scheme, step * Vector::Unit(model.dofs, j));
          return Assembled(moved).system.force;
        };
        derivative.col(j) = (force(-h) - force(h)) / (2 * h);
      }
      EXPECT_LT((derivative - k).lpNorm<Eigen::Infinity>(), 1e-8 * k.lpNorm<Eigen::Infinity>());
    }
}

// Stress-free: no force. Under an initial stress: none on blocks that are bonded all round. What is left is the
// rounding of displacements, times the stiffness.
TEST(Bonds, RigidMotionGivesNoForce) {
  for (BondKind kind : {BondKind::exact, BondKind::spring}) {
    Scene scene = irregular();
    scene.properties[0].bond = kind;
    Model model = build(scene);
    turn(model, 2.3, {-40, 70});
    const Assembled all(model);
    const double stiffness = all.dense().lpNorm<Eigen::Infinity>();
    EXPECT_LT(all.system.force.lpNorm<Eigen::Infinity>(), 4 * 2.2e-16 * stiffness * 100);
  }
  Model model = build(irregular());
  for (BlockShape& shape : model.shapes) shape.initial_stress = {300, -200, 100};
  turn(model, 2.3, {0, 0});
  const Assembled all(model);
  std::vector<double> bonded(model.shapes.size(), 0);
  for (const Joint& joint : model.joints) ++bonded[joint.a], ++bonded[joint.b];
  const double stiffness = all.dense().lpNorm<Eigen::Infinity>();
  int inner = 0;
  for (size_t b = 0; b < bonded.size(); ++b) {
    const double force = all.system.force.segment<6>(model.shapes[b].dof_begin).norm();
    if (bonded[b] < 3) {
      EXPECT_GT(force, 1);
      continue;
    }
    ++inner;
    EXPECT_LT(force, 1e-14 * stiffness);
  }
  EXPECT_GT(inner, 20);
}

}  // namespace
}  // namespace talus
