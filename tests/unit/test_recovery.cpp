#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>

#include "equations/kinematics.h"
#include "equations/recovery.h"
#include "small_scene.h"

namespace talus {
namespace {

using test::rectangle;

using Field = std::function<Vec2(const Vec2&)>;

// Corners are put where the field takes them; blocks only turn, by `angle`.
void displace(Model& model, const Field& u, double angle = 0) {
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const BlockShape& s = model.shapes[b];
    model.blocks[b].angle = angle;
    for (int v = s.vertex_begin; v < s.vertex_end; ++v) {
      const Vec2 p = s.reference_centroid + model.reference_vertex[v];
      model.vertex[v] = p + u(p);
    }
  }
}

// Central differences with Richardson's step: exact for the polynomials here, but for round-off.
Mat2 gradient(const Field& u, const Vec2& at) {
  Mat2 g;
  for (int k = 0; k < 2; ++k) {
    const auto difference = [&](double h) {
      return Vec2((u(at + h * Vec2::Unit(k)) - u(at - h * Vec2::Unit(k))) / (2 * h));
    };
    g.col(k) = (4 * difference(0.5) - difference(1)) / 3;
  }
  return g;
}

// R D (U - I) Rᵀ with F = I + ∇u = R U: the engine's measure of strain, not linearised.
Vec3 exact_stress(const Model& model, const Field& u, const Vec2& at) {
  const Mat2 f = Mat2::Identity() + gradient(u, at);
  const double angle = std::atan2(f(1, 0) - f(0, 1), f(0, 0) + f(1, 1));
  const Rotation r = Rotation::of(angle);
  const Vec2 x = r.back(f.col(0)), y = r.back(f.col(1));
  return turn_stress(r, elasticity(model.material(0)) * Vec3(x.x() - 1, y.y() - 1, x.y() + y.x()));
}

Model plate(Plane plane = Plane::stress) {
  Scene scene = test::scene_of({test::meshed("plate", rectangle(0, 0, 4, 2), 0.3)});
  scene.materials[0].plane = plane;
  return build(scene);
}

// Cubic fields of plane elasticity by its complex potentials: 2G (u + iv) = κ φ(z) - z conj φ'(z) - conj ψ(z),
// with φ = a z³ + b z², ψ = c z³: no body force; and quadratic ones with a constant body force.
Field kolosov(const Model& model, double scale) {
  const Material& m = model.material(0);
  const double nu = m.poisson, kappa = m.plane == Plane::stress ? (3 - nu) / (1 + nu) : 3 - 4 * nu;
  return [kappa, scale](const Vec2& p) {
    using Complex = std::complex<double>;
    const Complex z(p.x() - 1.7, p.y() - 0.8), a(0.4, -0.7), b(0.3, 0.2), c(-0.5, 0.6);
    const Complex phi = a * z * z * z + b * z * z, slope = 3.0 * a * z * z + 2.0 * b * z, psi = c * z * z * z;
    const Complex u = scale * (kappa * phi - z * std::conj(slope) - std::conj(psi));
    return Vec2(u.real(), u.imag());
  };
}

// Largest error over all blocks' centroids, and over their corners on the boundary, where patches are one-sided.
double worst(const Model& model, const std::function<Vec3(const Vec2&)>& exact, double* largest = nullptr) {
  const Recovery recovery(model);
  double error = 0;
  for (int b = 0; b < int(model.shapes.size()); ++b)
    for (const Vec2& at : {Vec2(0, 0), model.reference_vertex[model.shapes[b].vertex_begin]}) {
      const Vec3 expected = exact(model.reference_place(b, at));
      error = std::max(error, (recovery.stress_at(model, b, at) - expected).norm());
      if (largest) *largest = std::max(*largest, expected.norm());
    }
  return error;
}

TEST(Recovery, CubicEquilibriumFieldIsExact) {
  for (Plane plane : {Plane::stress, Plane::strain}) {
    Model model = plate(plane);
    displace(model, kolosov(model, 1e-3));
    double largest = 0;
    const auto exact = [&](const Vec2& p) { return exact_stress(model, kolosov(model, 1e-3), p); };
    const double error = worst(model, exact, &largest);
    EXPECT_GT(largest, 10);
    EXPECT_LT(error, 1e-10 * largest);
  }
}

// Body force: a quadratic field has a constant div σ, whatever it is.
TEST(Recovery, QuadraticFieldIsExact) {
  Model model = plate();
  const Field u = [](const Vec2& p) {
    return Vec2(1e-3 * (p.x() * p.x() - 2 * p.x() * p.y()), 1e-3 * (3 * p.y() * p.y() + p.x() * p.y()));
  };
  displace(model, u);
  EXPECT_LT(worst(model, [&](const Vec2& p) { return exact_stress(model, u, p); }), 1e-8);
}

// The fit is no mere interpolation: a cubic that no body force but a varying one could hold is not reproduced.
TEST(Recovery, OtherCubicsAreNot) {
  Model model = plate();
  const Field u = [](const Vec2& p) { return Vec2(1e-3 * p.x() * p.x() * p.x(), 0); };
  displace(model, u);
  EXPECT_GT(worst(model, [&](const Vec2& p) { return exact_stress(model, u, p); }), 1e-2);
}

TEST(Recovery, RigidMotionGivesNoStress) {
  Model model = plate();
  for (double angle : {0.01, 2.0, -3.0}) {
    const Rotation r = Rotation::of(angle);
    displace(
        model, [&](const Vec2& p) { return Vec2(r.turn(p) - p + Vec2(30, -20)); }, angle);
    EXPECT_LT(worst(model, [](const Vec2&) { return Vec3(0, 0, 0); }), 1e-12 * 1000 * 30);
  }
}

TEST(Recovery, StressTurnsWithTheBody) {
  Model model = plate();
  const Field u = kolosov(model, 1e-3);
  const double angle = 1.9;
  const Rotation r = Rotation::of(angle);
  displace(
      model, [&](const Vec2& p) { return Vec2(r.turn(p + u(p)) - p); }, angle);
  EXPECT_LT(worst(model, [&](const Vec2& p) { return turn_stress(r, exact_stress(model, kolosov(model, 1e-3), p)); }),
            1e-9);
  for (BlockShape& s : model.shapes) s.initial_stress = {7, -3, 2};  // in the blocks' axes
  displace(
      model, [&](const Vec2& p) { return Vec2(r.turn(p) - p); }, angle);
  EXPECT_LT(worst(model, [&](const Vec2&) { return turn_stress(r, {7, -3, 2}); }), 1e-9);
}

// Two halves, bonded on x = 2, of which the right one has moved off by 1 mm: while the joint is intact, the
// corners' averages smear the jump; once it has failed, neither half is strained.
TEST(Recovery, AFailedJointSeparates) {
  Scene scene = test::scene_of({test::meshed("plate", rectangle(0, 0, 4, 2), 0.3)});
  Trace trace;
  trace.points = {{2, -1}, {2, 3}};
  trace.bonded = true;
  scene.regions[0].traces = {trace};
  Model model = build(scene);
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const BlockShape& s = model.shapes[b];
    if (s.reference_centroid.x() < 2) continue;
    model.blocks[b].shift = Vec2(1e-3, 5e-4);
    model.blocks[b].centroid = s.reference_centroid + model.blocks[b].shift;
  }
  model.place_vertices();
  Recovery recovery(model);
  const auto largest = [&] {
    double stress = 0;
    for (int b = 0; b < int(model.shapes.size()); ++b)
      stress = std::max(stress, recovery.stress_at(model, b, {0, 0}).norm());
    return stress;
  };
  EXPECT_GT(largest(), 0.1);
  for (Joint& joint : model.joints)
    if (joint.trace == 0) joint.state = JointState::failed;
  recovery.update(model);
  EXPECT_LT(largest(), 1e-9);
}

// A corner's displacement is the mean over all blocks that hang together round it: it does not matter which of
// them has moved.
TEST(Recovery, ACornerIsTheMeanOfAllItsBlocks) {
  Model model = plate();
  const Nodes& nodes = model.nodes;
  for (size_t n = 0; n + 1 < nodes.begin.size(); ++n) {
    std::vector<Vec3> stresses;
    for (int k = nodes.begin[n]; k < nodes.begin[n + 1]; ++k) {
      model.place_vertices();
      model.vertex[model.shapes[nodes.blocks[k]].vertex_begin + nodes.corners[k]] += Vec2(1e-3, 2e-3);
      stresses.push_back(Recovery(model).stress_at(model, nodes.blocks[nodes.begin[n]], {0, 0}));
    }
    for (const Vec3& stress : stresses) EXPECT_LT((stress - stresses[0]).norm(), 1e-9) << "node " << n;
  }
}

TEST(Recovery, FewCornersGiveTheBlocksOwnStress) {
  Scene scene = test::scene_of({test::patterned("box", rectangle(0, 0, 1, 1), MeshKind::diagonal, 1, 1)});
  Model model = build(scene);
  model.blocks[1].strain = {1e-3, -2e-3, 5e-4};
  model.blocks[1].angle = 0.3;
  model.place_vertices();
  const Recovery recovery(model);
  for (int b = 0; b < 2; ++b) EXPECT_EQ(recovery.stress_at(model, b, {0.1, 0.1}), model.stress(b));
  model.shapes[0].dofs = 3;
  model.shapes[0].initial_stress = {1, 2, 3};
  EXPECT_EQ(recovery.stress_at(model, 0, {0, 0}), Vec3(1, 2, 3));
}

}  // namespace
}  // namespace talus
