// The energy ledger against closed forms, on scenes of one or two blocks.
#include <gtest/gtest.h>

#include <cmath>

#include "output/energy_plot.h"
#include "small_scene.h"
#include "step/bodies.h"
#include "step/energy_terms.h"
#include "step/simulation.h"
#include "step/step_change.h"

namespace talus {
namespace {

using test::rectangle;

// A rigid square of 2 kg/m, in motion for 1 s.
Scene moving(double dt, const Vec2& velocity = Vec2::Zero()) {
  Region block = test::region("block", rectangle(0, 0, 1, 1));
  block.order = BlockOrder::rigid;
  block.velocity = velocity;
  Scene scene = test::scene_of({block});
  scene.time.mode = Mode::dynamic;
  scene.time.dt = dt;
  scene.time.displacement_ratio = 1e6;
  return scene;
}

Energies run(Simulation& simulation) {
  while (!simulation.finished()) simulation.step();
  return simulation.energies();
}

// Exact in X, but read at y: the way there, ahead·v, is what the integrator answers for.
TEST(Ledger, FreeFall) {
  Scene scene = moving(0.01);
  scene.gravity = {0, -8};
  Simulation simulation(scene);
  const Energies e = run(simulation);
  EXPECT_NEAR(e.kinetic, 2 * 64 / 2.0, 1e-9);
  EXPECT_NEAR(e.gravity, -2 * 8 * (4 + 0.25 * 0.01 * 8), 1e-9);
  EXPECT_NEAR(e.numerical, 2 * 8 * 0.25 * 0.01 * 8, 1e-9);
  EXPECT_NEAR(e.unexplained, 0, 1e-9);
  EXPECT_NEAR(e.scale, 64, 1e-9);
}

// A shorter step has y = X + ahead·v of what falls higher by Δahead·v; that is no energy until losses, here ahead·Δt m
// g² a step, have paid for it.
TEST(Ledger, AShorterStepLiftsWhatFallsForNothing) {
  Scene scene = moving(0.3);
  scene.gravity = {0, -8};
  Simulation simulation(scene);
  std::vector<double> total;
  while (!simulation.finished()) {
    simulation.step();
    total.push_back(simulation.energies().total);
  }
  ASSERT_NEAR(simulation.last.dt, 0.1, 1e-12);
  const double m = 2, g = 8, lost = m * g * 0.25 * 0.3 * g * 0.9;
  ASSERT_EQ(total.size(), 4);
  EXPECT_NEAR(total[2], -lost, 1e-9);
  EXPECT_NEAR(total[3], -lost, 1e-9);
  EXPECT_NEAR(simulation.energies().unexplained, 0, 1e-9);
}

TEST(Ledger, PaysWithWhatIsLostAndNoMore) {
  Ledger ledger;
  ledger.unpaid = 5;
  EXPECT_EQ(ledger.pay(-1), 0);  // a gain
  EXPECT_EQ(ledger.pay(2), 2);
  EXPECT_EQ(ledger.pay(4), 3);
  EXPECT_EQ(ledger.unpaid, 0);
  ledger.unpaid = -5;  // lowered
  EXPECT_EQ(ledger.pay(0), -5);
  EXPECT_EQ(ledger.unpaid, 0);
}

// A mass on a spring loses (θ-½)(k Δy² + m Δv²) a step; stepped here by the formula of the scheme alone.
TEST(Ledger, OscillatorLosesByTheFormula) {
  for (const double theta : {0.5, 0.75, 1.0}) {
    Scene scene = moving(1e-3, {0.3, 0});
    scene.materials[0].young = 1;  // the fixity's spring is 1e4 times that
    scene.fixities = {test::fix(0, test::on_point({0.5, 0.5}))};
    scene.numerics.theta = theta;
    Simulation simulation(scene);
    const Energies e = run(simulation);
    const double k = 1e4, m = 2, dt = 1e-3;
    double y = 0, v = 0.3, lost = 0;
    for (int i = 0; i < 1000; ++i) {
      // as it lies the spring is unstrained, from then on it goes by y
      const double lead = i == 0 ? (theta - 0.5) * dt * v : 0;
      const double mean = y + theta * (lead + dt * v);  // (1-θ) y0 + θ y1 at v1 = v0
      const double dv = -k * dt * mean / (m + k * theta * theta * dt * dt);
      const double dy = lead + dt * (v + theta * dv);
      lost += (theta - 0.5) * (k * dy * dy + m * dv * dv) + m * dv / dt * lead;
      y += dy;
      v += dv;
    }
    EXPECT_NEAR(e.kinetic, m * v * v / 2, 1e-9) << theta;
    EXPECT_NEAR(e.strain, k * y * y / 2, 1e-9) << theta;
    EXPECT_NEAR(e.numerical, lost, 1e-9) << theta;
    EXPECT_NEAR(e.unexplained, 0, 1e-9) << theta;
  }
}

// y moves when Δt changes: a shorter last step, here, while gravity, a load and a spring act.
TEST(Ledger, AStepOfAnotherLengthAddsUp) {
  Scene scene = moving(0.0093, {0.3, -0.2});
  scene.materials[0].young = 1e-2;
  scene.gravity = {0, -8};
  scene.fixities = {test::fix(0, test::on_point({0.5, 0.5}))};
  PointLoad load;
  load.region = 0;
  load.at = {0.5, 0.5};
  load.force = {History(7.0), History(3.0)};
  scene.point_loads = {load};
  Simulation simulation(scene);
  const Energies e = run(simulation);
  EXPECT_LT(simulation.last.dt, 0.009);
  EXPECT_GT(std::abs(e.external), 0.01);
  EXPECT_NEAR(e.unexplained, 0, 1e-10);
}

TEST(Ledger, LoadGivesForceTimesWay) {
  Scene scene = moving(1e-3);
  PointLoad load;
  load.region = 0;
  load.at = {0.5, 0.5};
  load.force = {History(6.0), History(0.0)};
  scene.point_loads = {load};
  Simulation simulation(scene);
  const Energies e = run(simulation);  // a = 3 m/s2
  EXPECT_NEAR(e.kinetic, 9, 1e-9);
  EXPECT_NEAR(e.external, 6 * (1.5 + 0.25e-3 * 3), 1e-9);
  EXPECT_NEAR(e.unexplained, 0, 1e-9);
}

// Two points that move as one carry the block along: what they give is its kinetic energy and what the springs
// lose.
TEST(Ledger, MovingSupportsGiveWhatArrives) {
  Scene scene = moving(1e-3);
  Fixity left = test::fix(0, test::on_point({0, 0.5})), right = test::fix(0, test::on_point({1, 0.5}));
  left.motion = right.motion = Fixity::velocity;
  left.value = right.value = {History(0.5), History(0.0)};
  scene.fixities = {left, right};
  Simulation simulation(scene);
  const double stretched = simulation.energies().strain;  // at y the supports have left already
  const Energies e = run(simulation);
  EXPECT_NEAR(e.kinetic, 2 * 0.25 / 2, 1e-6);
  EXPECT_NEAR(e.boundary + stretched, e.kinetic + e.strain + e.numerical, 1e-6);
  EXPECT_GT(e.numerical, 0.1);  // the start is an impact: half of the work is lost
  EXPECT_NEAR(e.unexplained, 0, 1e-8);
}

// On a pin at its corner, 500 kg turn at 5 rad/s: straight flight would leave it by (ω Δt)²/8 of the arm each half
// step, and held at its extrapolated place alone the pin would ride 3/16 (ω Δt)² off, thousands of times what its
// load stretches it.
TEST(Supports, APinStaysWhereItIs) {
  Scene scene = moving(1e-3);
  scene.materials[0].density = 500;
  scene.materials[0].young = 1e9;
  scene.regions[0].spin = 5;
  scene.regions[0].spin_centre = Vec2(0, 0);
  scene.fixities = {test::fix(0, test::on_point({0, 0}))};
  Simulation simulation(scene);
  double off = 0;
  while (!simulation.finished()) {
    simulation.step();
    const Vec2 arm(-0.5, -0.5);
    off = std::max(off, (simulation.model.place(0, arm) - simulation.model.reference_place(0, arm)).norm());
  }
  EXPECT_LT(off, 0.02 * 25e-6 * std::sqrt(0.5));  // of (ω Δt)² arm
  EXPECT_NEAR(simulation.energies().kinetic, 500 * (2.0 / 3) * 25 / 2, 1e-2);
  EXPECT_NEAR(simulation.energies().unexplained, 0, 1e-5 * simulation.energies().scale);
}

Scene on_floor(double friction, const Vec2& velocity, double height) {
  Scene scene = moving(1e-3, velocity);
  Region floor = test::region("floor", rectangle(-10, -1, 20, 1));
  floor.held = true;
  for (Polyline& outline : scene.regions[0].outlines)
    for (Vec2& p : outline) p.y() += height;
  scene.regions.push_back(floor);
  scene.materials[0].young = 1e6;
  scene.properties[0].friction = friction;
  scene.contact = 0;
  scene.gravity = {0, -8};
  return scene;
}

TEST(Ledger, FrictionIsForceTimesSliding) {
  Scene scene = on_floor(0.3, {6, 0}, 0);
  scene.time.settled_start = true;
  Simulation simulation(scene);
  const Energies e = run(simulation);
  const double friction = std::tan(0.3) * 2 * 8, way = 6 - std::tan(0.3) * 8 / 2;
  EXPECT_NEAR(e.friction, friction * way, 2e-3 * friction * way);  // at y; the block rocks a little at the start
  EXPECT_NEAR(e.unexplained, 0, 1e-6 * e.scale);
}

TEST(Ledger, ImpactIsTheIntegratorsLoss) {
  Simulation simulation(on_floor(0.3, {0, 0}, 0.5));
  const Energies e = run(simulation);
  EXPECT_NEAR(e.numerical, 2 * 8 * 0.5, 0.01);
  EXPECT_NEAR(e.friction, 0, 1e-6);
  EXPECT_NEAR(e.unexplained, 0, 1e-6 * e.scale);
}

// Newmark with the dynamic parameter p keeps p² of the kinetic energy a step.
TEST(Ledger, DampingOfTheDynamicParameter) {
  Scene scene = moving(0.1, {3, 0});
  scene.numerics.integrator = Integrator::newmark;
  scene.numerics.dynamic_parameter = 0.9;
  Simulation simulation(scene);
  const Energies e = run(simulation);
  EXPECT_NEAR(e.damping, 9 * (1 - std::pow(0.9, 20)), 1e-12);
  EXPECT_NEAR(e.unexplained, 0, 1e-12);
}

// The way into equilibrium is not part of the run.
TEST(Ledger, BeginsAfterTheSettledStart) {
  Scene scene = on_floor(0.3, {0, 0}, 0);
  scene.time.settled_start = true;
  Simulation simulation(scene);
  simulation.begin();
  const Energies e = simulation.energies();
  EXPECT_GT(e.contact, 0);
  EXPECT_EQ(e.gravity, 0);
  EXPECT_EQ(e.unexplained, 0);
  EXPECT_EQ(e.scale, e.total);
}

// Held by its left edge, pulled at the right: half the force at its full value times the way.
TEST(Ledger, StaticLoadsGrowFromNothing) {
  Scene scene = test::scene_of({test::region("bar", rectangle(0, 0, 2, 1))});
  scene.fixities = {test::fix(0, test::on_line({0, 0}, {0, 1}))};
  scene.edge_loads = {test::traction(0, test::on_line({2, 0}, {2, 1}), {0.1, 0})};
  scene.time.steps = 3;
  Simulation simulation(scene);
  const Energies e = run(simulation);
  EXPECT_NEAR(e.external, 0.1 * 0.1 / 1000,
              1e-6);  // ½ F (F l / E A); the support keeps its end from thinning: a little less
  EXPECT_NEAR(e.strain, e.external, 1e-4 * e.external);
  EXPECT_NEAR(e.unexplained, 0, 1e-4 * e.external);
}

// m (a² + b²)/12 of a plate of any size, and the spin of a plate that turns.
TEST(Bodies, HaveTheMomentOfInertiaOfTheirMass) {
  Simulation simulation(test::scene_of({test::region("plate", rectangle(0, 0, 0.2, 0.1))}));
  Model& model = simulation.model;
  model.blocks[0].velocity[2] = 3 * model.shapes[0].length;
  const Body body = bodies_of(model, model.blocks, model.fragment, 1)[0];
  EXPECT_NEAR(body.inertia, model.mass(0) * (0.04 + 0.01) / 12, 1e-12 * body.inertia);
  EXPECT_NEAR(body.spin, 3, 1e-12);
}

// What lies on something and hardly moves keeps y where the step changes, so that its contacts and its weight hold what
// they held; what moves faster, the sooner where it slides, and what flies, keeps X.
TEST(Ledger, AStepOfAnotherLengthKeepsWhatPressedContactsHold) {
  Simulation simulation(on_floor(0.3, {0, 0}, 0));
  simulation.step();
  Model& model = simulation.model;
  ASSERT_GT(model.contacts[0].normal_force, 0);
  const auto moved = [&](double velocity, double force, ContactState state = ContactState::stick, double slid = 0) {
    for (Contact& c : model.contacts) {
      c.normal_force = force;
      c.state = state;
      c.slid = slid;
    }
    model.blocks[0].velocity = {0, velocity, velocity};
    const BlockState kept = keep_stored(model, 0.01, 0.02)[0];
    return std::pair(kept.shift.y() - model.blocks[0].shift.y(), kept.angle - model.blocks[0].angle);
  };
  EXPECT_NEAR(moved(1e-5, 1).first, -1e-7, 1e-20);
  EXPECT_NEAR(moved(1e-5, 1).second, -1e-7, 1e-20);
  EXPECT_NEAR(moved(1e-3, 1).first, -1e-5, 1e-18);
  EXPECT_EQ(moved(1e-1, 1).first, 0);
  EXPECT_NEAR(moved(1e-5, 1, ContactState::slip, 1e-7).first, -1e-7, 1e-20);
  EXPECT_EQ(moved(1e-3, 1, ContactState::slip, 1e-5).first, 0);
  // at the limit of friction, but it has come to stand
  EXPECT_NEAR(moved(1e-3, 1, ContactState::slip, -1e-9).first, -1e-5, 1e-18);
  EXPECT_EQ(moved(1e-5, 0).first, 0);
}

TEST(EnergyTerms, OnlyWhatTheSceneCanHave) {
  const auto names = [](const Scene& scene) {
    Simulation simulation(scene);
    std::string all;
    for (const EnergyTerm* term : energy_terms(simulation.plan)) all += term->name + " ";
    return all;
  };
  EXPECT_EQ(names(moving(0.1)), "kinetic strain total numerical unexplained ");
  EXPECT_EQ(names(on_floor(0.3, {0, 0}, 0)), "kinetic strain contact gravity total friction numerical unexplained ");
}

TEST(Record, StaysSmallAndEndsWithTheRun) {
  Scene scene = moving(1e-3);
  scene.time.t_end = 3;
  Simulation simulation(scene);
  Record record;
  const Record::Row row = [&] { return energy_row(simulation); };
  while (!simulation.finished()) {
    simulation.step();
    record.after_step(simulation.totals.steps, simulation.model.time, row);
  }
  EXPECT_LT(record.size(), 256u);
  EXPECT_GT(record.size(), 127u);
  const size_t before = record.size();
  record.last(simulation.totals.steps, simulation.model.time, row);
  record.last(simulation.totals.steps, simulation.model.time, row);
  EXPECT_LE(record.size(), before + 1);
  EXPECT_EQ(record.column(0).size(), record.size());
  EXPECT_NE(draw_energies(record, simulation.plan).find("unexplained"), std::string::npos);
}

}  // namespace
}  // namespace talus
