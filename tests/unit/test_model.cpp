#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "equations/block_terms.h"
#include "equations/kinematics.h"
#include "geometry/polygon.h"
#include "hand_model.h"

namespace talus {
namespace {

using test::moved_squares;
using test::two_squares;

constexpr double right_angle = std::numbers::pi / 2;

// One block of any outline, first order.
Model one_block(const Polyline& outline) {
  Model model = two_squares();
  model.shapes.resize(1);
  const PolygonIntegrals i = integrate(outline);
  BlockShape& shape = model.shapes[0];
  shape.area = i.area;
  shape.length = std::sqrt(i.area);
  shape.xx = i.xx;
  shape.yy = i.yy;
  shape.xy = i.xy;
  shape.reference_centroid = i.centroid;
  shape.vertex_begin = 0;
  shape.vertex_end = int(outline.size());
  model.reference_vertex.clear();
  for (const Vec2& p : outline) model.reference_vertex.push_back(p - i.centroid);
  model.blocks.assign(1, {});
  model.blocks[0].centroid = i.centroid;
  model.place_vertices();
  return model;
}
const Polyline wedge = {{1, 1}, {4, 1.5}, {3.5, 3}, {2, 2.2}};

TEST(Rotation, TurnsAndTurnsBack) {
  const Rotation r = Rotation::of(right_angle);
  EXPECT_NEAR((r.turn({1, 0}) - Vec2(0, 1)).norm(), 0, 1e-15);
  EXPECT_NEAR((r.back(r.turn({3, -4})) - Vec2(3, -4)).norm(), 0, 1e-14);
  // c - 1 keeps its digits where c itself has none left: -θ²/2
  EXPECT_DOUBLE_EQ(Rotation::of(1e-9).c1(), -5e-19);
  EXPECT_DOUBLE_EQ(Rotation::of(std::numbers::pi).c1(), -2);
  for (const double angle : {0.1, 1.5, 1.6, 3.1, -2.0})
    EXPECT_NEAR(Rotation::of(angle).c1(), std::cos(angle) - 1, 2e-16) << angle;
}

TEST(Model, PlaceStrainsThenTurnsThenShifts) {
  const Model model = moved_squares();  // turned by 90°, εx = 0.001, εy = -0.002, γ = 0.0004
  const Vec2 strained(1.001 * 0.5 + 0.0002 * 0.25, 0.0002 * 0.5 + 0.998 * 0.25);
  EXPECT_NEAR((model.place(0, {0.5, 0.25}) - (Vec2(0.6, 0.7) + perp(strained))).norm(), 0, 1e-15);
  for (int v = 0; v < 4; ++v)
    EXPECT_NEAR((model.vertex[v] - model.place(0, model.reference_vertex[v])).norm(), 0, 1e-15);
}

TEST(Model, AreaUnderStrainIsThatOfThePlacedOutline) {
  Model model = one_block(wedge);
  model.blocks[0].strain = {0.3, -0.2, 0.5};
  model.blocks[0].angle = 2.5;
  model.place_vertices();
  EXPECT_NEAR(model.area(0), signed_area(model.vertex), 1e-14 * model.area(0));
}

// d/dt of place, by the rates of the unknowns: central differences, error of second order.
TEST(Model, VelocityIsTheRateOfPlace) {
  Model model = one_block(wedge);
  const double length = model.shapes[0].length, h = 1e-5;
  BlockState& state = model.blocks[0];
  state.angle = 0.8;
  state.velocity = {0.3, -0.7, 1.1, 0.4, -0.2, 0.9};  // unstrained: l·rates act on reference arms
  const Vec2 in_block(0.4, -0.6);
  const auto at = [&](double t) {
    Model moved = model;
    const auto& v = state.velocity;
    moved.blocks[0].centroid += t * Vec2(v[0], v[1]);
    moved.blocks[0].angle += t * v[2] / length;
    moved.blocks[0].strain += t / length * Vec3(v[3], v[4], v[5]);
    return moved.place(0, in_block);
  };
  const Vec2 rate = (at(h) - at(-h)) / (2 * h);
  EXPECT_NEAR((model.velocity_at(0, model.place(0, in_block)) - rate).norm(), 0, 1e-9);
  EXPECT_NEAR((flown(model, 0, 0).velocity_at(in_block) - rate).norm(), 0, 1e-9);
}

TEST(Pose, RowsAreTheDerivativesOfPlace) {
  Model model = one_block(wedge);
  model.blocks[0].angle = -0.4;
  const Pose pose = flown(model, 0, 0);
  const Vec2 in_block(0.4, -0.6);
  const DofRows rows = pose.rows(pose.place(in_block));
  const double h = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const auto at = [&](double step) {
      Model moved = model;
      moved.blocks[0].velocity[k] = 1;
      return flown(moved, 0, step).place(in_block);
    };
    EXPECT_NEAR(((at(h) - at(-h)) / (2 * h) - rows.col(k)).norm(), 0, 1e-9) << k;
  }
}

// From displacements alone: a shift of 1e-12 at a place of size 1 keeps all its digits.
TEST(Pose, DisplacementKeepsItsDigits) {
  Model model = one_block(wedge);
  model.blocks[0].shift = {1e-12, -3e-13};
  model.blocks[0].angle = 1e-12;
  model.blocks[0].strain = {2e-12, 0, 0};
  const Vec2 moved = flown(model, 0, 0).displacement({1, 1});
  EXPECT_NEAR(moved.x(), 1e-12 - 1e-12 + 2e-12, 1e-23);
  EXPECT_NEAR(moved.y(), -3e-13 + 1e-12, 1e-23);
  model.blocks[0].angle = 2.9;
  const Pose pose = flown(model, 0, 0);
  EXPECT_NEAR((pose.displacement({1, 1}) - (pose.place({1, 1}) - model.reference_place(0, {1, 1}))).norm(), 0, 1e-14);
}

TEST(Stress, TurnsWithItsBlock) {
  EXPECT_NEAR((turn_stress(Rotation::of(right_angle), {3, 1, 0.5}) - Vec3(1, 3, -0.5)).norm(), 0, 1e-15);
  const double angle = 0.3;
  const Rotation r = Rotation::of(angle);
  Mat2 turn, s;
  turn << r.c, -r.s, r.s, r.c;
  s << 3, 0.5, 0.5, 1;
  const Mat2 turned = turn * s * turn.transpose();
  EXPECT_NEAR((turn_stress(r, {3, 1, 0.5}) - Vec3(turned(0, 0), turned(1, 1), turned(0, 1))).norm(), 0, 1e-15);

  Model model = two_squares();
  model.shapes[0].initial_stress = {3e5, 1e5, 5e4};
  model.blocks[0].strain = {1e-3, 0, 0};
  const Vec3 before = model.stress(0);
  model.blocks[0].angle = angle;
  EXPECT_NEAR((model.stress(0) - turn_stress(r, before)).norm(), 0, 1e-14 * before.norm());
}

TEST(Elasticity, PlaneStressAndPlaneStrain) {
  Material m;
  m.young = 7;
  m.poisson = 0.3;
  m.plane = Plane::stress;
  const Mat3 stress = elasticity(m);
  EXPECT_NEAR((stress * Vec3(1, -0.3, 0) - Vec3(7, 0, 0)).norm(), 0, 1e-14);  // pulled along x, free across
  m.plane = Plane::strain;
  const Mat3 strain = elasticity(m);
  // εy = σz-corrected: pulled along x with εz = 0 needs E' = E/(1-ν²), ν' = ν/(1-ν)
  EXPECT_NEAR((strain * Vec3(1, -0.3 / 0.7, 0) - Vec3(7 / 0.91, 0, 0)).norm(), 0, 1e-14);
  EXPECT_DOUBLE_EQ(stress(2, 2), 7 / 2.6);
  EXPECT_DOUBLE_EQ(strain(2, 2), 7 / 2.6);
}

// ½ vᵀ M v against ½ ∫ρ |v|², by the midpoints of the sides of triangles from the centroid: exact for quadratics.
TEST(MassMatrix, GivesTheKineticEnergyOfTheField) {
  Model model = one_block(wedge);
  model.blocks[0].velocity = {0.3, -0.7, 1.1, 0.4, -0.2, 0.9};
  double energy = 0;
  for (size_t k = 0; k < wedge.size(); ++k) {
    const Vec2 c = model.shapes[0].reference_centroid, a = wedge[k], b = wedge[(k + 1) % wedge.size()];
    for (const Vec2& p : {Vec2((a + b) / 2), Vec2((b + c) / 2), Vec2((c + a) / 2)})
      energy += 2000.0 / 2 * cross(a - c, b - c) / 6 * model.velocity_at(0, p).squaredNorm();
  }
  const auto v = model.blocks[0].velocity.column<6>();
  EXPECT_NEAR(v.dot(mass_matrix(model, 0) * v) / 2, energy, 1e-13 * energy);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(mass_matrix(model, 0)).eigenvalues()[0], 0);
}

}  // namespace
}  // namespace talus
