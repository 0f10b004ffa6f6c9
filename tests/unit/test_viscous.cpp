// Viscous edges: the mean velocity of the step, exact dissipation, and tractions that stay.
#include <gtest/gtest.h>

#include <cmath>

#include "small_scene.h"
#include "step/simulation.h"

namespace talus {
namespace {

using test::rectangle;

// A square of 1 m with ρ = 2, E = 1000, ν = 0.25, in motion for a tenth of a second; left and right edges are viscous.
Scene sliding(Plane plane, const Vec2& velocity) {
  Region block = test::region("block", rectangle(0, 0, 1, 1));
  block.order = BlockOrder::rigid;
  block.velocity = velocity;
  Scene scene = test::scene_of({block});
  scene.materials[0].plane = plane;
  scene.time.mode = Mode::dynamic;
  scene.time.t_end = 0.1;
  scene.time.dt = 0.01;
  scene.time.displacement_ratio = 1e6;
  scene.viscous_boundaries = {{{}, 0, test::on_line({0, 0}, {0, 1})}, {{}, 0, test::on_line({1, 0}, {1, 1})}};
  return scene;
}

// v1 = v0 (1 - a/2)/(1 + a/2) a step with a = C Δt/M; what is lost is what the dashpots took.
TEST(Viscous, SlowsBySpeedsOfThePlaneState) {
  const double nu = 0.25, young = 1000, shear = young / 2 / (1 + nu), density = 2;
  const double p_stress = young / (1 - nu * nu), p_strain = young * (1 - nu) / (1 + nu) / (1 - 2 * nu);
  for (const Integrator integrator : {Integrator::theta, Integrator::newmark})
    for (const Plane plane : {Plane::stress, Plane::strain})
      for (const int axis : {0, 1}) {
        Scene scene = sliding(plane, axis == 0 ? Vec2(1, 0) : Vec2(0, 1));
        scene.numerics.integrator = integrator;
        Simulation simulation(scene);
        while (!simulation.finished()) simulation.step();
        const double modulus = axis == 1 ? shear : plane == Plane::stress ? p_stress : p_strain;
        const double a = 2 * std::sqrt(density * modulus) * 0.01 / density;
        const double v = std::pow((1 - a / 2) / (1 + a / 2), 10);
        EXPECT_NEAR(simulation.model.blocks[0].velocity[size_t(axis)], v, 1e-12);
        EXPECT_NEAR(simulation.energies().viscous, 1 - v * v, 1e-12);
        EXPECT_NEAR(simulation.energies().unexplained, 0, 1e-12);
      }
}

TEST(Viscous, EdgesAreMarked) {
  const Simulation simulation(sliding(Plane::stress, {0, 0}));
  ASSERT_EQ(simulation.model.viscous_edges.size(), 2u);
  for (const ViscousEdge& edge : simulation.model.viscous_edges) {
    const BlockShape& shape = simulation.model.shapes[edge.block];
    const Vec2 from = simulation.model.reference_vertex[size_t(shape.vertex_begin + edge.edge)];
    EXPECT_NEAR((from - edge.in_block[0]).norm(), 0, 1e-15);
  }
}

// Deformable blocks under their weight: held while they settle, then carried by what the edges bore.
TEST(Viscous, ASettledSceneStays) {
  for (const Integrator integrator : {Integrator::theta, Integrator::newmark}) {
    Scene scene = test::scene_of({test::meshed("bench", rectangle(0, 0, 2, 1), 0.5)});
    scene.time.mode = Mode::dynamic;
    scene.time.t_end = 1;
    scene.time.dt = 0.01;
    scene.time.settled_start = true;
    scene.gravity = {0, -1};
    scene.numerics.integrator = integrator;
    scene.viscous_boundaries = {{{}, 0, test::on_line({0, 0}, {2, 0})}};
    Simulation simulation(scene);
    simulation.begin();
    double weight = 0;
    for (const ViscousEdge& edge : simulation.model.viscous_edges)
      weight += edge.length * (edge.traction[0].y() + edge.traction[1].y()) / 2;
    EXPECT_NEAR(weight, 4, 1e-6);
    const auto shift = [&] { return simulation.model.blocks[0].shift; };
    const Vec2 before = shift();
    while (!simulation.finished()) simulation.step();
    EXPECT_EQ(shift(), before);
  }
}

}  // namespace
}  // namespace talus
