#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "assembled.h"
#include "contact/detection.h"
#include "equations/contact_terms.h"
#include "equations/recovery.h"
#include "model/gauss.h"
#include "small_scene.h"
#include "step/simulation.h"

namespace talus {
namespace {

using test::Assembled;
using test::Dense;
using test::rectangle;
using test::region;
using test::scene_of;

Scene second_order(Scene scene) {
  for (Region& r : scene.regions) r.order = BlockOrder::second;
  return scene;
}

// First, second and rigid blocks beside each other.
Scene mixed(Scene scene) {
  for (Region& r : scene.regions)
    r.order_at = [](Vec2 p) {
      const int third = int(std::floor(7 * p.x() + 11 * p.y())) % 3;
      return third == 0 ? BlockOrder::second : third == 1 ? BlockOrder::first : BlockOrder::rigid;
    };
  return scene;
}

// Sum over a fine grid of triangles in the block: of what need not be polynomial.
template <class F>
double by_quadrature(const Model& model, int block, F f) {
  constexpr int parts = 60;
  const BlockShape& shape = model.shapes[block];
  double sum = 0;
  for (int v = shape.vertex_begin + 1; v + 1 < shape.vertex_end; ++v) {
    const Vec2 a = model.reference_vertex[shape.vertex_begin], b = model.reference_vertex[v] - a,
               c = model.reference_vertex[v + 1] - a;
    const double area = cross(b, c) / 2 / (parts * parts);
    for (int i = 0; i < parts; ++i)
      for (int j = 0; i + j < parts; ++j)
        for (int up = 0; up < (i + j + 1 < parts ? 2 : 1); ++up)
          sum += area * f(a + (i + (1 + up) / 3.0) / parts * b + (j + (1 + up) / 3.0) / parts * c);
  }
  return sum;
}

Model bent_block() {
  Model model = build(second_order(scene_of({region("block", {{0, 0}, {3, 0.5}, {2, 2}, {0.3, 1.4}})})));
  BlockState& state = model.blocks[0];
  state.angle = 0.7;
  state.strain = Vec3(0.03, -0.05, 0.04);
  *state.bend = {0.02, -0.05, 0.03, 0.04, 0.01, -0.02};
  state.velocity = {0.3, -0.7, 1.1, 0.4, -0.2, 0.9, 0.2, -0.3, 0.5, 0.1, 0.7, -0.6};
  model.place_vertices();
  return model;
}

TEST(SecondOrder, MomentsAreExact) {
  const Polyline outline = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};  // two rectangles
  const HighMoments m = integrate_high(outline, {0.5, 0.25});
  const auto moment = [](int px, int py) {
    const auto side = [](double from, double to, int p) {
      return (std::pow(to, p + 1) - std::pow(from, p + 1)) / (p + 1);
    };
    return side(-0.5, 3.5, px) * side(-0.25, 0.75, py) + side(-0.5, 0.5, px) * side(0.75, 2.75, py);
  };
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(m.third[size_t(k)], moment(3 - k, k), 1e-13 * moment(4, 0)) << k;
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(m.fourth[size_t(k)], moment(4 - k, k), 1e-13 * moment(4, 0)) << k;
}

TEST(SecondOrder, MassMatrixGivesTheKineticEnergy) {
  Model model = bent_block();
  model.blocks[0].strain.setZero();
  *model.blocks[0].bend = {};
  const Pose pose = flown(model, 0, 0);
  const ColumnOf<12> v = model.blocks[0].velocity.column<12>();
  const double energy = v.dot(second_order_mass_matrix(model, 0) * v) / 2;
  const double summed = by_quadrature(model, 0, [&](const Vec2& x) { return pose.velocity_at(x).squaredNorm(); });
  EXPECT_NEAR(energy, model.material(0).density / 2 * summed, 1e-3 * energy);
}

TEST(SecondOrder, MomentOfInertiaCountsStrainAndBend) {
  const Model model = bent_block();
  const BlockState& state = model.blocks[0];
  const Pose pose = flown(model, 0, 0);
  const double summed =
      by_quadrature(model, 0, [&](const Vec2& x) { return (pose.place(x) - pose.centroid).squaredNorm(); });
  const double inertia = moment_of_inertia(model, 0, state.strain, state.bend) * model.shapes[0].area;
  EXPECT_NEAR(inertia, model.material(0).density * summed, 1e-3 * inertia);
  const Vec2 moved(by_quadrature(model, 0, [&](const Vec2& x) { return (pose.place(x) - pose.centroid).x(); }),
                   by_quadrature(model, 0, [&](const Vec2& x) { return (pose.place(x) - pose.centroid).y(); }));
  EXPECT_LT(moved.norm(), 1e-4 * summed);  // the centroid stays one
}

TEST(SecondOrder, RowsAndRatesAreTheDerivativeOfThePlace) {
  Model model = bent_block();
  const Vec2 in_block(0.6, -0.3);
  const Pose pose = flown(model, 0, 0);
  const RowsOf<12> rows = pose.rows<12>(in_block, pose.place(in_block));
  const double h = 1e-6;
  const auto place = [&](int k, double by) {
    Model moved = model;
    moved.blocks[0].velocity = {};
    moved.blocks[0].velocity[size_t(k)] = 1;
    return flown(moved, 0, by).place(in_block);
  };
  for (int k = 0; k < 12; ++k) EXPECT_LT((rows.col(k) - (place(k, h) - place(k, -h)) / (2 * h)).norm(), 1e-8) << k;
  const Vec2 rate = rows * model.blocks[0].velocity.column<12>();
  EXPECT_LT((pose.velocity_at(in_block) - rate).norm(), 1e-13);
  EXPECT_LT((model.velocity_at(0, model.place(0, in_block)) - rate).norm(), 1e-9);
  EXPECT_LT((model.place(0, in_block) - pose.place(in_block)).norm(), 1e-14);
}

// u = (quadratic), whose stress varies linearly and needs the body force -div σ: of blocks without a free edge nothing
// is left.
TEST(SecondOrder, BondsLetThroughAnyQuadraticField) {
  Scene scene = second_order(test::irregular());
  Model model = build(scene);
  const Mat3 elastic = elasticity(model.material(0));
  const Eigen::Matrix<double, 2, 3> b =
      (Eigen::Matrix<double, 2, 3>() << 0.03, -0.05, 0.02, 0.01, 0.04, -0.06).finished();
  Vector exact(model.dofs);  // of u = B (x², xy, y²)
  for (const BlockShape& s : model.shapes) {
    const Vec2 c = s.reference_centroid;
    const double l = s.length;
    const Vec3 mean = s.bend().mean;
    Mat2 gradient;  // at the centroid
    gradient.col(0) = b * Vec3(2 * c.x(), c.y(), 0);
    gradient.col(1) = b * Vec3(0, c.x(), 2 * c.y());
    exact.segment<2>(s.dof_begin) = b * (Vec3(c.x() * c.x(), c.x() * c.y(), c.y() * c.y()) + l * l * mean);
    exact[s.dof_begin + 2] = l * (gradient(1, 0) - gradient(0, 1)) / 2;
    exact.segment<3>(s.dof_begin + 3) = l * Vec3(gradient(0, 0), gradient(1, 1), gradient(0, 1) + gradient(1, 0));
    exact.segment<3>(s.dof_begin + 6) = l * l * b.row(0).transpose();
    exact.segment<3>(s.dof_begin + 9) = l * l * b.row(1).transpose();
  }
  const Vec3 by_x = elastic * Vec3(2 * b(0, 0), b(1, 1), b(0, 1) + 2 * b(1, 0)),
             by_y = elastic * Vec3(b(0, 1), 2 * b(1, 2), 2 * b(0, 2) + b(1, 1));
  const Vec2 body = -Vec2(by_x[0] + by_y[2], by_x[2] + by_y[1]);
  Assembled all(model);
  Vector force = Vector::Zero(model.dofs);
  all.system.matrix.multiply(exact, force);
  std::vector<int> bonds(model.shapes.size(), 0);
  for (const Joint& joint : model.joints) ++bonds[size_t(joint.a)], ++bonds[size_t(joint.b)];
  int inner = 0;
  for (int k = 0; k < int(model.shapes.size()); ++k) {
    const BlockShape& s = model.shapes[size_t(k)];
    if (bonds[size_t(k)] < model.vertex_count(k)) continue;
    ++inner;
    ColumnOf<12> wanted = ColumnOf<12>::Zero();
    wanted.head<2>() = s.area * body;
    EXPECT_LT((force.segment<12>(s.dof_begin) - wanted).norm(),
              1e-10 * (s.length * elastic * by_x / elastic(0, 0)).norm());
  }
  EXPECT_GT(inner, 20);
}

std::vector<std::pair<std::string, Model>> ugly_second_order_meshes() {
  std::vector<std::pair<std::string, Model>> list;
  const auto add = [&list](const std::string& name, const Scene& scene) {
    list.emplace_back(name, build(second_order(scene)));
    list.emplace_back(name + ", mixed", build(mixed(scene)));
  };
  add("irregular", test::irregular(1.001));
  Scene needles = scene_of({test::patterned("box", rectangle(0, 0, 200, 1), MeshKind::diagonal, 2, 4)});
  needles.properties[0].penalty = 1.001;
  add("needles 100 : 1", needles);
  Scene soft = scene_of({test::patterned("box", rectangle(0, 0, 2, 1), MeshKind::alternating, 4, 3)});
  soft.materials[0].poisson = 0.49;
  soft.materials[0].plane = Plane::strain;
  soft.properties[0].penalty = 1.001;
  add("nearly incompressible", soft);
  return list;
}

// On the ground at one point of a block, so that three rigid motions are left at most. Scaled to a unit diagonal.
TEST(SecondOrder, BondsArePositiveJustAboveTheProvenStiffness) {
  for (auto& [name, model] : ugly_second_order_meshes()) {
    const Dense k = Assembled(model).dense();
    const Vector scale = k.diagonal().cwiseSqrt().cwiseInverse();
    const Dense scaled = scale.asDiagonal() * k * scale.asDiagonal();
    const Vector values = Eigen::SelfAdjointEigenSolver<Dense>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_GT(values[0], -1e-12) << name;
    EXPECT_LT(values[2], 1e-11) << name;
    EXPECT_GT(values[3], 1e-11) << name;
  }
}

TEST(SecondOrder, BondsAreIndefiniteFarBelowIt) {
  Scene scene = second_order(scene_of({test::patterned("box", rectangle(0, 0, 2, 1), MeshKind::cross, 4, 2)}));
  scene.properties[0].penalty = 0.2;
  EXPECT_LT(
      Eigen::SelfAdjointEigenSolver<Dense>(Assembled(build(scene)).dense(), Eigen::EigenvaluesOnly).eigenvalues()[0],
      -1);
}

// K is minus the derivative of the forces, of bonds by Nitsche and by springs, turned and not, with a fixed edge.
TEST(SecondOrder, StiffnessIsTheDerivativeOfTheForces) {
  for (const BondKind kind : {BondKind::exact, BondKind::spring}) {
    Scene scene = mixed(scene_of({test::patterned("box", rectangle(0, 0, 2, 1), MeshKind::cross, 3, 2)}));
    scene.properties[0].bond = kind;
    scene.fixities = {test::fix(0, test::on_line({0, 0}, {0, 1}))};
    const Model model = build(scene);
    const Dense k = Assembled(model).dense();
    const double h = 1e-7;
    for (int unknown = 0; unknown < model.dofs; ++unknown) {
      const auto forces = [&](double by) {
        Model moved = model;
        for (size_t b = 0; b < moved.shapes.size(); ++b) {
          const BlockShape& s = moved.shapes[b];
          const int own = unknown - s.dof_begin;
          if (own < 0 || own >= s.dofs) continue;
          BlockState& state = moved.blocks[b];
          if (own < 2) state.shift[own] += by, state.centroid[own] += by;
          if (own == 2) state.angle += by / s.length;
          if (own > 2 && own < 6) state.strain[own - 3] += by / s.length;
          if (own >= 6) (*state.bend)[size_t(own - 6)] += by;
        }
        return Assembled(moved).system.force;
      };
      const Vector slope = (forces(h) - forces(-h)) / (2 * h);
      EXPECT_LT((slope + k.col(unknown)).norm(), 1e-6 * k.norm()) << unknown;
    }
  }
}

// Blocks of second order have corners along their edges, the same on both sides of a joint, which stands on several
// sides then.
TEST(SecondOrder, BothSidesOfAJointHaveTheSameCorners) {
  for (const bool bonded : {false, true}) {
    Region cut = region("cut", rectangle(0, 0, 4, 1));
    Trace& trace = cut.traces.emplace_back();
    trace.points = {{0.1, -1}, {0.1, 2}};  // leaves a slender block on its left
    trace.bonded = bonded;
    const Model model = build(second_order(scene_of({cut})));
    ASSERT_EQ(model.shapes.size(), 2U);
    ASSERT_EQ(model.joints.size(), 1U);
    const Joint& joint = model.joints[0];
    ASSERT_GT(joint.sides, 2);
    EXPECT_NEAR(joint.length, 1, 1e-12);
    const auto place = [&](int block, int corner) {
      return model.reference_place(block,
                                   model.reference_vertex[size_t(model.shapes[size_t(block)].vertex_begin + corner)]);
    };
    EXPECT_LT((place(joint.a, joint.edge_a) - model.reference_place(joint.a, joint.in_a[0])).norm(), 1e-12);
    EXPECT_LT((place(joint.b, joint.edge_b) - model.reference_place(joint.b, joint.in_b[1])).norm(), 1e-12);
    for (int side = 0; side < joint.sides; ++side) {
      const int a = joint.edge_a + side, b = joint.facing(a);
      EXPECT_LT((place(joint.a, a) - place(joint.b, model.next_vertex(joint.b, b))).norm(), 1e-15);
      EXPECT_LT((place(joint.a, model.next_vertex(joint.a, a)) - place(joint.b, b)).norm(), 1e-15);
    }
  }
}

// A body that nothing can touch has no corners but its own.
TEST(SecondOrder, WithoutContactsEdgesAreNotDivided) {
  Region meshed = region("plate", rectangle(0, 0, 2, 1));
  meshed.mesh.kind = MeshKind::triangles;
  meshed.mesh.size = 0.5;
  const Scene scene = second_order(scene_of({meshed}));
  for (const BlockShape& shape : build(scene).shapes) EXPECT_EQ(shape.vertex_end - shape.vertex_begin, 3);
  Scene with_floor = scene;
  with_floor.regions.push_back(region("floor", rectangle(0, -2, 2, 1)));
  EXPECT_EQ(build(with_floor).shapes[0].vertex_end, 6);
}

// Of the gap, of the vertex and of the edge as it bends.
TEST(SecondOrder, ContactRowsAreTheDerivativeOfTheGap) {
  Model model =
      build(second_order(scene_of({region("floor", rectangle(0, 0, 3, 1)), region("block", rectangle(0.5, 1, 1, 1))})));
  *model.blocks[0].bend = {0.01, 0.02, -0.01, 0.005, 0.01, 0.02};
  *model.blocks[1].bend = {-0.02, 0.01, 0.01, 0.01, -0.005, 0.01};
  model.place_vertices();
  ContactSearch search;
  search.update(model, 0);
  ASSERT_FALSE(model.contacts.empty());
  Poses poses;
  const Scheme scheme = Scheme::equilibrium();
  poses.predict(model, scheme);
  ContactTerms terms;
  terms.linearise(model, poses, scheme, false, {});
  const double h = 1e-7;
  for (const ContactRows& row : terms.rows())
    for (int unknown = 0; unknown < 12; ++unknown)
      for (const int block : {row.i, row.j}) {
        const auto gap = [&](double by) {
          Model moved = model;
          moved.blocks[size_t(block)].velocity[size_t(unknown)] = 1;
          const Pose pose = flown(moved, block, by);
          for (int v = moved.shapes[size_t(block)].vertex_begin; v < moved.shapes[size_t(block)].vertex_end; ++v)
            moved.vertex[size_t(v)] = pose.place(moved.reference_vertex[size_t(v)]);
          const Contact& c = moved.contacts[size_t(row.contact)];
          const int to = moved.shapes[size_t(c.j)].vertex_begin + moved.next_vertex(c.j, c.edge);
          const Vec2 from = moved.vertex[size_t(c.global_edge)], span = moved.vertex[size_t(to)] - from;
          const Pose of_j = flown(moved, c.j, c.j == block ? by : 0);
          const Vec2 middle =
              of_j.place((moved.reference_vertex[size_t(c.global_edge)] + moved.reference_vertex[size_t(to)]) / 2);
          return CurvedEdge{from, span, Vec2(middle - from - span / 2)}.foot(moved.vertex[size_t(c.global_vertex)]).gap;
        };
        const double slope = (gap(h) - gap(-h)) / (2 * h);
        EXPECT_NEAR((block == row.i ? row.normal_i : row.normal_j)[size_t(unknown)], slope, 1e-7) << unknown;
      }
}
// Loose blocks of both orders come to rest on each other by sweeps, and their stress carries what lies above.
TEST(SecondOrder, LooseBlocksComeToRest) {
  Scene scene =
      second_order(scene_of({region("floor", rectangle(-1, -1, 4, 1)), region("low", rectangle(0, 0, 1, 1)),
                             region("middle", rectangle(0, 1, 1, 1)), region("high", rectangle(0, 2, 1, 1))}));
  scene.regions[0].held = true;
  scene.regions[2].order = BlockOrder::first;
  scene.materials[0].young = 1e6;
  scene.gravity = {0, -10};
  scene.time.mode = Mode::dynamic;
  scene.time.settled_start = true;
  scene.time.t_end = 0.2;
  scene.time.dt = 0.01;
  Simulation simulation(scene);
  while (!simulation.finished()) simulation.step();
  for (int b = 1; b < 4; ++b) {
    EXPECT_NEAR(simulation.model.stress(b)[1], -20 * (3.5 - b), 0.05) << b;
    EXPECT_LT(
        Vec2(simulation.model.blocks[size_t(b)].velocity[0], simulation.model.blocks[size_t(b)].velocity[1]).norm(),
        1e-9);
  }
}

// A linear initial stress that is in equilibrium stays as it is, in the block too.
TEST(SecondOrder, InitialStressVariesInABlock) {
  Scene scene = second_order(scene_of({test::meshed("plate", rectangle(0, 0, 2, 1), 0.5)}));
  StressField& stress = scene.regions[0].stress.emplace();
  stress.value = {3, -1, 0.5};
  stress.gradient_y = {2, 0, 0};  // σx = 3 + 2 y: no body force
  scene.fixities = {test::fix(0, test::on_line({0, 0}, {0, 1})), test::fix(0, test::on_line({2, 0}, {2, 1})),
                    test::fix(0, test::on_line({0, 0}, {2, 0})), test::fix(0, test::on_line({0, 1}, {2, 1}))};
  Simulation simulation(scene);
  simulation.step();
  const Model& model = simulation.model;
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    const Vec2 in_block = model.reference_vertex[size_t(model.shapes[size_t(b)].vertex_begin)];
    const double y = model.reference_place(b, in_block).y();
    EXPECT_LT((model.stress(b, in_block) - Vec3(3 + 2 * y, -1, 0.5)).norm(), 1e-8);
  }
}

TEST(SecondOrder, EachBlockCanHaveItsOwnOrder) {
  const Model model = build(mixed(test::irregular()));
  int count[3] = {0, 0, 0};
  for (const BlockShape& shape : model.shapes) ++count[shape.dofs / 6];
  EXPECT_GT(count[0], 5);
  EXPECT_GT(count[1], 5);
  EXPECT_GT(count[2], 5);
  EXPECT_EQ(int(model.quadratic_shapes.size()), count[2]);
  for (const Joint& joint : model.joints) {
    const bool second = model.shapes[size_t(joint.a)].second_order() || model.shapes[size_t(joint.b)].second_order();
    EXPECT_EQ(joint.points.size(), second ? 3u : 2u);
  }
}

// The same field saved and read back is the same to the last bit.
TEST(SecondOrder, AStateIsSavedWhole) {
  Scene scene = mixed(scene_of({test::meshed("plate", rectangle(0, 0, 2, 1), 0.5)}));
  scene.regions[0].spin = 0.5;
  scene.time.mode = Mode::dynamic;
  scene.time.dt = 0.01;
  scene.time.t_end = 1;
  Simulation one(scene), other(scene);
  for (int k = 0; k < 5; ++k) one.step();
  other.restore(one.save());
  EXPECT_EQ(one.hash(), other.hash());
  for (int k = 0; k < 5; ++k) one.step(), other.step();
  for (size_t b = 0; b < one.model.blocks.size(); ++b) {
    EXPECT_EQ(one.model.blocks[b].velocity, other.model.blocks[b].velocity);
    const auto &bend = one.model.blocks[b].bend, &saved = other.model.blocks[b].bend;
    ASSERT_EQ(bool(bend), bool(saved));
    if (bend) {
      EXPECT_EQ(*bend, *saved);
    }
  }
  EXPECT_EQ(one.hash(), other.hash());
}

// Angular momentum of a free disc of blocks of all orders: the spin counts strain and bend in the moment of inertia,
// the rates of both count with reference moments. A step keeps it to round-off.
TEST(SecondOrder, AStepKeepsTheMomentum) {
  for (const bool all : {true, false}) {
    Polyline circle;
    for (int k = 0; k < 16; ++k) circle.push_back(Vec2(std::cos(k * M_PI / 8), std::sin(k * M_PI / 8)));
    Scene scene = scene_of({test::meshed("disc", circle, 0.5)});
    scene = all ? second_order(scene) : mixed(scene);
    scene.regions[0].velocity = {0.5, -0.2};
    scene.regions[0].spin = 1;
    scene.time.mode = Mode::dynamic;
    scene.time.dt = 0.01;
    scene.time.t_end = 100;
    Simulation simulation(scene);
    const Model& model = simulation.model;
    const auto momentum = [&model] {
      Vec3 sum = Vec3::Zero();
      for (int b = 0; b < int(model.shapes.size()); ++b) {
        const BlockShape& s = model.shapes[size_t(b)];
        const BlockState& state = model.blocks[size_t(b)];
        const Vec2 v(state.velocity[0], state.velocity[1]);
        const double spin = with_size(s.second_order(), [&](auto n) {
          const MatrixOf<n> mass = mass_matrix_of<n>(model, b);
          return mass.row(2).dot(state.velocity.template column<n>()) / mass(2, 2);
        });
        const double own = moment_of_inertia(model, b, state.strain, state.bend) * s.length * spin;
        sum += Vec3(model.mass(b) * v.x(), model.mass(b) * v.y(), model.mass(b) * cross(state.centroid, v) + own);
      }
      return sum;
    };
    const Vec3 before = momentum();
    for (int k = 0; k < 50; ++k) simulation.step();
    EXPECT_LT((momentum() - before).norm(), 1e-12 * before.norm());
    double bent = 0;
    for (const BlockState& state : model.blocks)
      if (state.bend) bent = std::max(bent, Eigen::Map<const Vec6>(state.bend->data()).cwiseAbs().maxCoeff());
    EXPECT_GT(bent, 1e-5);
  }
}

}  // namespace
}  // namespace talus
