#include <gtest/gtest.h>

#include <cmath>

#include "assembled.h"
#include "equations/linear_solver.h"
#include "equations/recovery.h"
#include "small_scene.h"

namespace talus {
namespace {

using test::Assembled;

// The manufactured displacement u = (sin(2x + y), cos(x - 2y)) and what belongs to it.
Vec2 exact(const Vec2& p) { return {std::sin(2 * p.x() + p.y()), std::cos(p.x() - 2 * p.y())}; }
Vec3 exact_stress(const Mat3& elastic, const Vec2& p) {
  const double c = std::cos(2 * p.x() + p.y()), s = std::sin(p.x() - 2 * p.y());
  return elastic * Vec3(2 * c, 2 * s, c - s);
}
Vec2 body_force(const Mat3& elastic, const Vec2& p) {  // -div σ
  const double s = std::sin(2 * p.x() + p.y()), c = std::cos(p.x() - 2 * p.y());
  const Vec3 by_x = elastic * Vec3(-4 * s, 2 * c, -2 * s - c), by_y = elastic * Vec3(-2 * s, -4 * c, -s + 2 * c);
  return -Vec2(by_x[0] + by_y[2], by_x[2] + by_y[1]);
}

constexpr double gauss5[] = {0.04691007703066802, 0.23076534494715845, 0.5, 0.76923465505284155, 0.95308992296933198};
constexpr double weight5[] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324, 0.11846344252809454};

// f(material point, weight) over a triangular block, exact for degree 8 (a square folded into the triangle).
template <class F>
void each_point(const Model& model, int block, F f) {
  const Vec2* v = &model.reference_vertex[size_t(model.shapes[size_t(block)].vertex_begin)];
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const double a = gauss5[i], b = gauss5[j] * (1 - a);
      f(Vec2(v[0] + a * (v[1] - v[0]) + b * (v[2] - v[0])), weight5[i] * weight5[j] * (1 - a) * 2 * model.shapes[size_t(block)].area);
    }
}

struct Errors {
  double displacement, stress, recovered;
  int blocks;
};

// Tractions all round and body force from the exact stress; what is left free, three rigid motions, is taken out of the error.
Errors solve(BlockOrder order, double size) {
  Scene scene = test::scene_of({test::meshed("plate", {{0, 0}, {1.1, 0.1}, {1, 1}, {-0.1, 0.9}}, size)});
  scene.regions[0].order = order;
  Model model = build(scene);
  const Mat3 elastic = elasticity(model.material(0));
  Assembled all(model);
  std::vector<char> bonded(model.reference_vertex.size(), 0);
  for (const Joint& joint : model.joints)
    bonded[size_t(model.shapes[size_t(joint.a)].vertex_begin + joint.edge_a)] =
        bonded[size_t(model.shapes[size_t(joint.b)].vertex_begin + joint.edge_b)] = 1;
  const auto add = [&](int block, const Vec2& in_block, const Vec2& force) {
    add_force(model, all.poses, block, {in_block, model.reference_place(block, in_block)}, force, all.system);
  };
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    each_point(model, b, [&](const Vec2& x, double w) { add(b, x, w * body_force(elastic, model.reference_place(b, x))); });
    for (int v = 0; v < model.vertex_count(b); ++v) {
      const int begin = model.shapes[size_t(b)].vertex_begin;
      if (bonded[size_t(begin + v)]) continue;
      const Vec2 p = model.reference_vertex[size_t(begin + v)],
                 q = model.reference_vertex[size_t(begin + model.next_vertex(b, v))], n = -perp(q - p);  // with its length
      for (int k = 0; k < 5; ++k) {
        const Vec2 x = (1 - gauss5[k]) * p + gauss5[k] * q;
        const Vec3 s = exact_stress(elastic, model.reference_place(b, x));
        add(b, x, weight5[k] * Vec2(s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y()));
      }
    }
  }
  Eigen::MatrixXd pin = Eigen::MatrixXd::Zero(max_dofs, max_dofs);
  pin.diagonal().head<3>().setConstant(1000);
  all.system.matrix.add(all.system.matrix.slot(0, 0), false, pin);
  LinearSolver solver;
  solver.analyse(all.system.matrix);
  EXPECT_EQ(solver.factor(all.system.matrix), -1);
  Vector d;
  solver.solve(all.system.force, d);

  constexpr double small = 1e-8;  // what the geometry makes of finite displacements is left out
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const BlockShape& s = model.shapes[b];
    BlockState& state = model.blocks[b];
    state.shift = small * d.segment<2>(s.dof_begin);
    state.centroid = s.reference_centroid + state.shift;
    state.angle = small * d[s.dof_begin + 2] / s.length;
    state.strain = small * d.segment<3>(s.dof_begin + 3) / s.length;
    for (int k = first_order_dofs; k < s.dofs; ++k) state.bend[size_t(k - first_order_dofs)] = small * d[s.dof_begin + k];
  }
  model.place_vertices();
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
    std::printf("order %d, %d to %d blocks: rates of displacement %.2f, stress %.2f, recovered stress %.2f; errors %.1e, %.1e, %.1e\n",
                order, coarse.blocks, fine.blocks, displacement, stress, recovered, fine.displacement, fine.stress,
                fine.recovered);
  }
}

}  // namespace
}  // namespace talus
