#pragma once
// A plate in equilibrium under the tractions of a known stress on its whole outline and the body force that goes with
// it. What that leaves free, its motion as a whole, is held by its first block.
#include <gtest/gtest.h>

#include <functional>

#include "assembled.h"
#include "equations/linear_solver.h"
#include "small_scene.h"

namespace talus::test {

inline constexpr double gauss5[] = {0.04691007703066802, 0.23076534494715845, 0.5, 0.76923465505284155,
                                    0.95308992296933198};
inline constexpr double weight5[] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444, 0.23931433524968324,
                                     0.11846344252809454};
inline constexpr double small_motion = 1e-8;  // what the geometry makes of finite displacements is left out

// f(material point, weight) over a triangular block, exact for degree 8 (a square folded into the triangle).
template <class F>
void each_point(const Model& model, int block, F f) {
  const Vec2* v = &model.reference_vertex[size_t(model.shapes[size_t(block)].vertex_begin)];
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const double a = gauss5[i], b = gauss5[j] * (1 - a);
      f(Vec2(v[0] + a * (v[1] - v[0]) + b * (v[2] - v[0])),
        weight5[i] * weight5[j] * (1 - a) * 2 * model.shapes[size_t(block)].area);
    }
}

struct Exact {
  std::function<Vec3(const Vec2&)> stress;
  std::function<Vec2(const Vec2&)> body_force = [](const Vec2&) { return Vec2(0, 0); };  // -div σ
};

// Loads of the exact solution on block `b`: on its mass, and on those of its edges that no bond holds.
template <class Add>
void add_exact_loads(const Model& model, const Exact& exact, const std::vector<char>& bonded, int b, Add add) {
  each_point(model, b, [&](const Vec2& x, double w) { add(b, x, w * exact.body_force(model.reference_place(b, x))); });
  for (int v = 0; v < model.vertex_count(b); ++v) {
    const int begin = model.shapes[size_t(b)].vertex_begin;
    if (bonded[size_t(begin + v)]) continue;
    const Vec2 p = model.reference_vertex[size_t(begin + v)],
               // with its length
        q = model.reference_vertex[size_t(begin + model.next_vertex(b, v))], n = -perp(q - p);
    for (int k = 0; k < 5; ++k) {
      const Vec2 x = (1 - gauss5[k]) * p + gauss5[k] * q;
      const Vec3 s = exact.stress(model.reference_place(b, x));
      add(b, x, weight5[k] * Vec2(s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y()));
    }
  }
}

// `small_motion` times the solution is put into the model.
inline Model solved_plate(const Scene& scene, const Exact& exact) {
  Model model = build(scene);
  Assembled all(model);
  std::vector<char> bonded(model.reference_vertex.size(), 0);
  for (const Joint& joint : model.joints)
    bonded[size_t(model.shapes[size_t(joint.a)].vertex_begin + joint.edge_a)] =
        bonded[size_t(model.shapes[size_t(joint.b)].vertex_begin + joint.edge_b)] = 1;
  for (int b = 0; b < int(model.shapes.size()); ++b)
    add_exact_loads(model, exact, bonded, b, [&](int block, const Vec2& in_block, const Vec2& force) {
      add_force(model, all.poses, block, {in_block, model.reference_place(block, in_block)}, force, all.system);
    });
  Eigen::MatrixXd pin = Eigen::MatrixXd::Zero(max_dofs, max_dofs);
  pin.diagonal().head<3>().setConstant(1000);
  all.system.matrix.add(all.system.matrix.slot(0, 0), false, pin);
  LinearSolver solver;
  solver.analyse(all.system.matrix);
  EXPECT_EQ(solver.factor(all.system.matrix), -1);
  Vector d;
  solver.solve(all.system.force, d);
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const BlockShape& s = model.shapes[b];
    BlockState& state = model.blocks[b];
    state.shift = small_motion * d.segment<2>(s.dof_begin);
    state.centroid = s.reference_centroid + state.shift;
    state.angle = small_motion * d[s.dof_begin + 2] / s.length;
    state.strain = small_motion * d.segment<3>(s.dof_begin + 3) / s.length;
    for (int k = first_order_dofs; k < s.dofs; ++k)
      (*state.bend)[size_t(k - first_order_dofs)] = small_motion * d[s.dof_begin + k];
  }
  model.place_vertices();
  return model;
}

}  // namespace talus::test
