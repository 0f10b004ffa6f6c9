#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "equations/block_terms.h"
#include "equations/kinematics.h"
#include "small_scene.h"
#include "step/simulation.h"

namespace talus {
namespace {

struct Momentum {
  Vec2 linear = Vec2::Zero();
  double angular = 0;  // about the origin
};
// ∫ρ x × v over the strained blocks: by corners' midpoints of the triangles, exact for linear fields.
Momentum momentum(const Model& model) {
  Momentum sum;
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    const BlockShape& shape = model.shapes[b];
    const Pose pose = flown(model, b, 0);
    const Vec2* p = &model.reference_vertex[shape.vertex_begin];
    for (const Vec2& at : {Vec2((p[0] + p[1]) / 2), Vec2((p[1] + p[2]) / 2), Vec2((p[2] + p[0]) / 2)}) {
      const double part = model.mass(b) / 3;
      sum.linear += part * pose.velocity_at(at);
      sum.angular += part * cross(pose.place(at), pose.velocity_at(at));
    }
  }
  return sum;
}

// A disc of bonded triangles that flies and turns, its blocks' velocities scattered by `disorder`.
struct FreeDisc {
  Simulation simulation;
  FreeDisc(double theta, double dt, double disorder) : simulation(scene(theta, dt)) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal(0, 1);
    for (BlockState& state : simulation.model.blocks)
      for (double& v : state.velocity) v += disorder * normal(random);
  }
  static Scene scene(double theta, double dt) {
    Polyline circle;
    for (int k = 0; k < 16; ++k) circle.push_back(Vec2(std::cos(k * M_PI / 8), std::sin(k * M_PI / 8)));
    Scene scene = test::scene_of({test::meshed("disc", circle, 0.5)});
    scene.regions[0].velocity = {0.5, -0.2};
    scene.regions[0].spin = 1;
    scene.time.mode = Mode::dynamic;
    scene.time.dt = dt;
    scene.time.t_end = 100;
    scene.numerics.theta = theta;
    return scene;
  }
};

// What a step keeps to round-off: of each block the moment of inertia counts strain, its mean spin has the strain
// rates' share with reference moments.
double kept_angular_momentum(const Model& model) {
  double sum = 0;
  for (int b = 0; b < int(model.shapes.size()); ++b) {
    const BlockShape& s = model.shapes[b];
    const BlockState& state = model.blocks[b];
    const auto& v = state.velocity;
    const auto mass = mass_matrix(model, b);
    const double spin = mass.row(2).dot(v.column<6>()) / mass(2, 2);
    Mat2 stretch, moments;
    stretch << 1 + state.strain[0], state.strain[2] / 2, state.strain[2] / 2, 1 + state.strain[1];
    moments << s.xx, s.xy, s.xy, s.yy;
    const double inertia = model.material(b).density * (stretch * moments * stretch).trace();
    sum += model.mass(b) * cross(state.centroid, Vec2(v[0], v[1])) + inertia * spin / s.length;
  }
  return sum;
}

TEST(Momentum, AStepKeepsIt) {
  for (double theta : {0.5, 0.75, 1.0})
    for (double dt : {0.01, 0.001})
      for (double disorder : {0.0, 0.1}) {
        FreeDisc disc(theta, dt, disorder);
        const Model& model = disc.simulation.model;
        const Momentum before = momentum(model);
        const double kept = kept_angular_momentum(model);
        EXPECT_NEAR(kept, before.angular, 1e-14 * kept);  // unstrained
        for (int k = 0; k < 50; ++k) disc.simulation.step();
        const Momentum after = momentum(model);
        EXPECT_LT((after.linear - before.linear).norm(), 1e-13 * before.linear.norm());
        EXPECT_NEAR(kept_angular_momentum(model), kept, 1e-12 * kept) << theta << " " << dt << " " << disorder;
        // the body's own differs by ∫ρ (e X) × (ė X), of second order in the strain
        double strain = 0, rate = 0;
        for (size_t b = 0; b < model.blocks.size(); ++b) {
          const auto& v = model.blocks[b].velocity;
          strain = std::max(strain, model.blocks[b].strain.norm());
          rate = std::max(rate, Vec3(v[3], v[4], v[5]).norm() / model.shapes[b].length);
        }
        EXPECT_GT(strain, 1e-4);  // it does deform
        double moments = 0;
        for (size_t b = 0; b < model.shapes.size(); ++b) moments += 2 * (model.shapes[b].xx + model.shapes[b].yy);
        EXPECT_LE(std::abs(after.angular - kept), strain * rate * moments);
      }
}

// Stress-free and rigid, it flies on unchanged: turned by what its spin asks for, and with the speed it had.
TEST(Momentum, FreeFlightOfOneBlockIsExact) {
  Scene scene = test::scene_of({test::region("block", test::rectangle(0, 0, 2, 1))});
  scene.regions[0].order = BlockOrder::rigid;
  scene.regions[0].velocity = {3, 1};
  scene.regions[0].spin = 0.7;
  scene.gravity = {0, -10};
  scene.time.mode = Mode::dynamic;
  scene.time.dt = 0.1;
  scene.time.t_end = 2;
  Simulation simulation(scene);
  while (!simulation.finished()) simulation.step();
  const BlockState& state = simulation.model.blocks[0];
  EXPECT_NEAR((state.shift - Vec2(6, 2 - 5 * 4.0)).norm(), 0, 1e-12);
  EXPECT_NEAR(state.angle, 1.4, 1e-13);
  EXPECT_NEAR(state.velocity[1], 1 - 20, 1e-12);
}

}  // namespace
}  // namespace talus
