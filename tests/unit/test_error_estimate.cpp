#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "equations/error_estimate.h"
#include "exact_plate.h"

namespace talus {
namespace {

// Tension 1 along x round a hole of radius 1 at the origin (Kirsch 1898). The polygon that stands for the hole bears
// the tractions that this stress has on it.
Vec3 kirsch(const Vec2& p) {
  const double r2 = p.squaredNorm(), q = 1 / r2, t = std::atan2(p.y(), p.x()), c2 = std::cos(2 * t),
               s2 = std::sin(2 * t), c4 = std::cos(4 * t), s4 = std::sin(4 * t);
  return {1 - q * (1.5 * c2 + c4) + 1.5 * q * q * c4, -q * (0.5 * c2 - c4) - 1.5 * q * q * c4,
          -q * (0.5 * s2 + s4) + 1.5 * q * q * s4};
}

// A beam of height 1 bent by a shear force at its end (Timoshenko & Goodier, § 21): σx bilinear, τ a parabola.
Vec3 beam(const Vec2& p) {
  return {12 * (4 - p.x()) * (p.y() - 0.5), 0, -6 * p.y() * (1 - p.y())};
}

struct Measured {
  double effectivity;  // estimated over true error
  double relative;     // true error over the whole, in energy norm
  int blocks;
};

Measured measure(const test::Exact& exact, Region region, BlockOrder order, double size) {
  region.mesh.kind = MeshKind::triangles;
  region.mesh.size = size;
  region.order = order;
  const Model model = test::solved_plate(test::scene_of({region}), exact);
  const Mat3 compliance = elasticity(model.material(0)).inverse();
  double error = 0, energy = 0;
  for (int b = 0; b < int(model.shapes.size()); ++b)
    test::each_point(model, b, [&](const Vec2& x, double w) {
      const Vec3 s = exact.stress(model.reference_place(b, x)), e = s - model.stress(b, x) / test::small_motion;
      error += w * e.dot(compliance * e);
      energy += w * s.dot(compliance * s);
    });
  const ErrorNorm estimate = error_of_regions(model, Recovery(model))[0];
  if (error < 0.01 * energy) {
    EXPECT_NEAR(estimate.energy / (test::small_motion * test::small_motion), energy, 0.05 * energy);
  }
  return {std::sqrt(estimate.error / error) / test::small_motion, std::sqrt(error / energy), int(model.shapes.size())};
}

Region plate_with_hole() {
  Region plate = test::region("plate", test::rectangle(-4, -4, 8, 8));
  Hole& hole = plate.holes.emplace_back();
  for (int k = 0; k < 48; ++k) hole.outline.push_back({std::cos(k * M_PI / 24), -std::sin(k * M_PI / 24)});
  return plate;
}

// Where the mesh resolves the solution the estimate is within 15 % of the error, and it tends to it; where the mesh is
// coarse and graded it is too large rather than too small.
TEST(ErrorEstimate, TendsToTheErrorOfClosedForms) {
  struct Case {
    const char* name;
    test::Exact exact;
    Region region;
    double coarse, fine, most;  // sizes; most that the coarse estimate is of the error
  };
  for (const Case& c :
       {Case{"plate with a hole", {kirsch}, plate_with_hole(), 0.5, 0.125, 1.4},
        Case{"cantilever", {beam}, test::region("beam", test::rectangle(0, 0, 4, 1)), 0.25, 0.0625, 1.1}})
    for (const BlockOrder order : {BlockOrder::first, BlockOrder::second}) {
      const Measured coarse = measure(c.exact, c.region, order, c.coarse),
                     fine = measure(c.exact, c.region, order, c.fine);
      std::printf("%s, order %d: %d blocks, error %.3f %%, estimate %.2f of it; %d blocks, %.3f %%, %.2f\n", c.name,
                  int(order), coarse.blocks, 100 * coarse.relative, coarse.effectivity, fine.blocks,
                  100 * fine.relative, fine.effectivity);
      EXPECT_GT(coarse.effectivity, 0.85) << c.name << ", order " << int(order);
      EXPECT_LT(coarse.effectivity, c.most) << c.name << ", order " << int(order);
      EXPECT_NEAR(fine.effectivity, 1, 0.1) << c.name << ", order " << int(order);
    }
}

// One stress everywhere is every block's own: no error, whatever it is, and no jump of traction; but for the digits
// that places leave to displacements of 1e-8 of a strain of 1e-3.
TEST(ErrorEstimate, OneStressHasNone) {
  for (const BlockOrder order : {BlockOrder::first, BlockOrder::second}) {
    Scene scene = test::irregular();
    scene.regions[0].order = order;
    const Model model = test::solved_plate(scene, {[](const Vec2&) { return Vec3(3, -2, 1); }});
    const ErrorNorm estimate = error_of_regions(model, Recovery(model))[0];
    EXPECT_LT(estimate.relative(), 1e-4);
    EXPECT_GT(estimate.energy, 0);
    for (const Joint& joint : model.joints) EXPECT_LT(traction_jump(model, joint), 1e-4 * test::small_motion);
  }
}

// Two squares side by side, one of them strained: the jump is the traction of the one on their joint.
TEST(ErrorEstimate, TractionJumpIsThatOfTheStresses) {
  Scene scene = test::scene_of({test::patterned("box", test::rectangle(0, 0, 2, 1), MeshKind::diagonal, 1, 1)});
  Model model = build(scene);
  ASSERT_EQ(model.joints.size(), 1u);
  model.blocks[size_t(model.joints[0].a)].strain = elasticity(model.material(0)).inverse() * Vec3(3, 0, 0);
  EXPECT_NEAR(traction_jump(model, model.joints[0]), 3 * std::abs(model.joints[0].normal.x()), 1e-12);
  EXPECT_GT(std::abs(model.joints[0].normal.x()), 0.1);
  // Two blocks are too few to smooth anything: no estimate, rather than a wrong one.
  EXPECT_EQ(error_of_block(model, Recovery(model), model.joints[0].a).error, 0);
  EXPECT_GT(error_of_block(model, Recovery(model), model.joints[0].a).energy, 0);
}

}  // namespace
}  // namespace talus
