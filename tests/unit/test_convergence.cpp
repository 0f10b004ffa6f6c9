#include <gtest/gtest.h>

#include <cmath>

#include "equations/recovery.h"
#include "exact_plate.h"

namespace talus {
namespace {

using test::each_point;

constexpr double small = test::small_motion;

// The manufactured displacement u = (sin(2x + y), cos(x - 2y)) and what belongs to it.
Vec2 exact(const Vec2& p) {
  return {std::sin(2 * p.x() + p.y()), std::cos(p.x() - 2 * p.y())};
}
Vec3 exact_stress(const Mat3& elastic, const Vec2& p) {
  const double c = std::cos(2 * p.x() + p.y()), s = std::sin(p.x() - 2 * p.y());
  return elastic * Vec3(2 * c, 2 * s, c - s);
}
Vec2 body_force(const Mat3& elastic, const Vec2& p) {  // -div σ
  const double s = std::sin(2 * p.x() + p.y()), c = std::cos(p.x() - 2 * p.y());
  const Vec3 by_x = elastic * Vec3(-4 * s, 2 * c, -2 * s - c), by_y = elastic * Vec3(-2 * s, -4 * c, -s + 2 * c);
  return -Vec2(by_x[0] + by_y[2], by_x[2] + by_y[1]);
}

struct Errors {
  double displacement, stress, recovered;
  int blocks;
};

// Tractions all round and body force from the exact stress; what is left free, three rigid motions, is taken out of the
// error.
Errors solve(BlockOrder order, double size) {
  Scene scene = test::scene_of({test::meshed("plate", {{0, 0}, {1.1, 0.1}, {1, 1}, {-0.1, 0.9}}, size)});
  scene.regions[0].order = order;
  const Mat3 elastic = elasticity(build(scene).material(0));
  const Model model = test::solved_plate(scene, {[&](const Vec2& p) { return exact_stress(elastic, p); },
                                                 [&](const Vec2& p) { return body_force(elastic, p); }});
  const Recovery recovery(model);
  Errors errors{0, 0, 0, int(model.shapes.size())};
  Mat3 modes = Mat3::Zero();
  Vec3 along = Vec3::Zero();
  double area = 0;
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    const Pose pose = flown(model, b, 0);
    each_point(model, b, [&](const Vec2& x, double w) {
      const Vec2 p = model.reference_place(b, x), e = pose.displacement(x) / small - exact(p);
      Eigen::Matrix<double, 2, 3> rigid;
      rigid << 1, 0, -p.y(), 0, 1, p.x();
      modes += w * rigid.transpose() * rigid;
      along += w * rigid.transpose() * e;
      errors.displacement += w * e.squaredNorm();
      errors.stress += w * (model.stress(b, x) / small - exact_stress(elastic, p)).squaredNorm();
    });
    const Vec2 c = model.shapes[size_t(b)].reference_centroid;
    const double edge = std::min({c.x(), c.y(), 1 - c.x(), 1 - c.y()});
    if (edge < 0.25) continue;  // the same inner part of all meshes
    area += model.shapes[size_t(b)].area;
    errors.recovered += model.shapes[size_t(b)].area *
                        (recovery.stress_at(model, b, Vec2::Zero()) / small - exact_stress(elastic, c)).squaredNorm();
  }
  errors.displacement = std::sqrt(errors.displacement - along.dot(modes.ldlt().solve(along)));
  errors.stress = std::sqrt(errors.stress);
  errors.recovered = std::sqrt(errors.recovered / area);
  return errors;
}

// Rates in the mean size of the blocks over two halvings, in L2.
TEST(Convergence, SmoothSolutionsOnUnstructuredMeshes) {
  struct Case {
    BlockOrder order;
    double displacement, stress, recovered;
  };
  for (const Case& least : {Case{BlockOrder::first, 1.9, 0.9, 1.7}, Case{BlockOrder::second, 2.8, 1.8, 2.1}}) {
    const Errors coarse = solve(least.order, 0.1), fine = solve(least.order, 0.025);
    const auto rate = [&](double from, double to) {
      return 2 * std::log(from / to) / std::log(double(fine.blocks) / coarse.blocks);
    };
    const int order = int(least.order);
    const double displacement = rate(coarse.displacement, fine.displacement), stress = rate(coarse.stress, fine.stress),
                 recovered = rate(coarse.recovered, fine.recovered);
    EXPECT_GE(displacement, least.displacement) << "order " << order;
    EXPECT_GE(stress, least.stress) << "order " << order;
    EXPECT_GE(recovered, least.recovered) << "order " << order;
    EXPECT_LT(fine.recovered, 0.2 * fine.stress) << "order " << order;
    std::printf(
        "order %d, %d to %d blocks: rates of displacement %.2f, stress %.2f, recovered stress %.2f; errors %.1e, %.1e, %.1e\n",
        order, coarse.blocks, fine.blocks, displacement, stress, recovered, fine.displacement, fine.stress,
        fine.recovered);
  }
}

}  // namespace
}  // namespace talus
