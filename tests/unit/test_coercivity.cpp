#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "assembled.h"
#include "small_scene.h"

namespace talus {
namespace {

using test::Assembled;
using test::Dense;
using test::irregular;
using test::on_line;
using test::patterned;
using test::rectangle;
using test::scene_of;

// Block 0 is held, so that no rigid motion is left.
void hold_first_block(Model& model) {
  model.shapes[0].dofs = 0;
  model.held_blocks = {0};
  model.dofs = 0;
  for (BlockShape& shape : model.shapes) {
    shape.dof_begin = model.dofs;
    model.dofs += shape.dofs;
  }
  for (Joint& joint : model.joints) {
    if (joint.a == 0) joint.weight_a = 0, joint.weight_b = 1;
    if (joint.b == 0) joint.weight_a = 1, joint.weight_b = 0;
  }
}

// Least eigenvalue of K against bulk + jumps at penalty 1.
double coercivity(Model model, double penalty) {
  const auto stiffness = [&model](double p) {
    model.scene.properties[0].penalty = p;
    return Assembled(model).dense();
  };
  const Dense at_one = stiffness(1), jumps = stiffness(2) - at_one;
  const Dense norm = Assembled(model, Scheme::equilibrium(), false).dense() + jumps;
  // scaled to a unit diagonal, or round-off of the stiffest bond would drown a weak block
  const Vector scale = norm.diagonal().cwiseSqrt().cwiseInverse();
  const auto scaled = [&scale](const Dense& m) { return Dense(scale.asDiagonal() * m * scale.asDiagonal()); };
  const Eigen::GeneralizedSelfAdjointEigenSolver<Dense> pencil(scaled(at_one + (penalty - 1) * jumps), scaled(norm),
                                                               Eigen::EigenvaluesOnly);
  return pencil.eigenvalues()[0];
}

// With Young's inequality 2 flux·jump <= s bulk + jumps/s: the least eigenvalue c is at least the root of
// (1 - c)(p - c) = 1. It is small just above p = 1, and positive.
double proven_coercivity(double p) {
  return (1 + p - std::sqrt((1 + p) * (1 + p) - 4 * (p - 1))) / 2;
}

std::vector<std::pair<std::string, Model>> ugly_meshes() {
  std::vector<std::pair<std::string, Model>> list;
  const auto add = [&list](const std::string& name, const Scene& scene) { list.emplace_back(name, build(scene)); };
  add("irregular", irregular());
  add("needles 100 : 1", scene_of({patterned("box", rectangle(0, 0, 200, 1), MeshKind::diagonal, 2, 4)}));
  add("obtuse, 179 degrees", scene_of({patterned("box", rectangle(0, 0, 100, 1), MeshKind::cross, 2, 3)}));
  Scene soft = scene_of({patterned("box", rectangle(0, 0, 2, 1), MeshKind::alternating, 4, 3)});
  soft.materials[0].poisson = 0.49;
  soft.materials[0].plane = Plane::strain;
  add("nearly incompressible", soft);
  soft.materials.push_back(soft.materials[0]);
  soft.materials[1].young = 1e7;
  Model mixed = build(soft);
  for (size_t b = 0; b < mixed.shapes.size(); b += 3) mixed.shapes[b].material = 1;
  for (Joint& joint : mixed.joints) {
    const double a = mixed.material(joint.a).young, b = mixed.material(joint.b).young;
    joint.weight_a = b / (a + b);
    joint.weight_b = a / (a + b);
  }
  list.emplace_back("moduli 10 000 : 1", mixed);
  return list;
}

TEST(Coercivity, ArePositiveDefiniteJustAboveOne) {
  for (auto& [name, model] : ugly_meshes()) {
    hold_first_block(model);
    for (double penalty : {1.001, 1.1, 3.0})
      EXPECT_GT(coercivity(model, penalty), proven_coercivity(penalty) - 1e-5) << name << ", penalty " << penalty;
  }
}

// The bound is no safe guess: where flux and jump can line up, well below it is not enough.
TEST(Coercivity, AreIndefiniteFarBelowOne) {
  Model model = build(scene_of({patterned("box", rectangle(0, 0, 2, 1), MeshKind::cross, 4, 2)}));
  hold_first_block(model);
  EXPECT_LT(coercivity(model, 0.2), 0);
}

// Scaled to a unit diagonal, so that no stiff bond hides a weak block.
TEST(Coercivity, GroundedEdgesArePositiveDefiniteToo) {
  for (bool y : {true, false}) {
    Scene scene = scene_of({patterned("box", rectangle(0, 0, 100, 1), MeshKind::cross, 2, 2)});
    scene.properties[0].penalty = 1.001;
    scene.fixities = {test::fix(0, on_line({0, 0}, {100, 0}), true, true),
                      test::fix(0, on_line({0, 1}, {100, 1}), true, y)};
    const Dense k = Assembled(build(scene)).dense();
    const Vector scale = k.diagonal().cwiseSqrt().cwiseInverse();
    const Dense scaled = scale.asDiagonal() * k * scale.asDiagonal();
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Dense>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0], 1e-12);
  }
}

}  // namespace
}  // namespace talus
