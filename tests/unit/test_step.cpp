// A step that is cut, or fails, leaves the model as it was.
#include <gtest/gtest.h>

#include <stdexcept>

#include "fracture/reduction.h"
#include "model/registry.h"
#include "model/saved_state.h"
#include "small_scene.h"
#include "step/simulation.h"
#include "step/step_parts.h"

namespace talus {
namespace {

using test::rectangle;

// A square that lies on a floor that moves ever faster, and one beside it a little above the floor.
Scene on_a_moving_floor(double dt) {
  Region floor = test::region("floor", rectangle(-5, -1, 30, 1));
  floor.held = true;
  Scene scene = test::scene_of(
      {floor, test::region("block", rectangle(0, 0, 1, 1)), test::region("other", rectangle(1.5, 0.02, 1, 1))});
  scene.materials[0].young = 1e6;
  scene.contact = 0;
  scene.gravity = {0, -10};
  scene.fixities = {test::fix(0, On{})};
  scene.fixities[0].motion = Fixity::velocity;
  scene.fixities[0].value = {History({{0, 0}, {1, 1}}), History(0.0)};
  PointLoad load;
  load.region = 1;
  load.at = {0.5, 1};
  load.force = {History(0.1), History(0.0)};
  scene.point_loads = {load, load};
  scene.time.mode = Mode::dynamic;
  scene.time.dt = dt;
  scene.time.dt_min = 0.6 * dt;
  return scene;
}

std::string state_of(Simulation& simulation) {
  StateWriter writer;
  visit_state(simulation.model, writer);
  visit_state(simulation.ledger, writer);
  return writer.bytes;
}

std::vector<std::int64_t> closed_pairs(const Simulation& simulation) {
  std::vector<std::int64_t> keys;
  for (const Contact& c : simulation.model.contacts)
    if (c.state != ContactState::open) keys.push_back(c.key());
  return keys;
}

TEST(Step, OneThatCannotBeAcceptedChangesNothing) {
  Simulation simulation(on_a_moving_floor(1e-3));
  for (int i = 0; i < 20; ++i) simulation.step();
  ASSERT_FALSE(closed_pairs(simulation).empty());
  const size_t contacts = simulation.model.contacts.size();
  simulation.model.blocks[2].velocity[0] = -4000;  // 4 m a step: meets what it did not, and is too far
  const std::string before = state_of(simulation);
  bool searched = false;
  simulation.model.scene.point_loads[0].force[0] = History([&](double) {
    searched = simulation.model.contacts.size() != contacts;
    return 0.1;
  });
  EXPECT_THROW(simulation.step(), RunError);
  EXPECT_TRUE(searched);  // the attempt had other contacts
  simulation.model.scene.point_loads[0].force[0] = History(0.1);
  EXPECT_EQ(state_of(simulation), before);
}

TEST(Step, OneWhoseLawFailsChangesNothing) {
  for (int call = 1; call <= 2; ++call) {  // in the assembly; then in the ledger, when the solution is there
    Simulation simulation(on_a_moving_floor(1e-3));
    for (int i = 0; i < 20; ++i) simulation.step();
    const std::string before = state_of(simulation);
    int calls = 0;
    auto& force = simulation.model.scene.point_loads[1].force[0];  // that of the first is booked already
    force = History([&](double) -> double {
      if (++calls == call) throw std::runtime_error("no number");
      return 0.1;
    });
    EXPECT_THROW(simulation.step(), std::runtime_error);
    EXPECT_EQ(calls, call);
    force = History(0.1);
    EXPECT_EQ(state_of(simulation), before) << call;
  }
}

// The attempt before left no trace: the same step, taken at once, ends in the same bits.
TEST(Step, AfterACutIsTheSmallerStepTakenAtOnce) {
  const auto thrown = [](Scene scene) {
    scene.time.dt_min = 1e-6;
    return scene;
  };
  Scene scene = thrown(on_a_moving_floor(0.1));
  scene.regions[2].velocity = {-40, -1};
  Simulation cut(scene);
  const StepReport report = cut.step();
  ASSERT_GT(report.cuts, 0);
  scene.time.dt = report.dt;
  Simulation direct(scene);
  ASSERT_EQ(direct.step().cuts, 0);
  EXPECT_EQ(direct.last.dt, report.dt);
  StateWriter one, other;
  visit_state(cut.model, one);
  visit_state(direct.model, other);
  EXPECT_EQ(one.bytes, other.bytes);
}

// A square of softening bonds, torn in static steps.
Scene torn(CrackPath path) {
  Scene scene = test::scene_of({test::patterned("plate", rectangle(0, 0, 1, 1), MeshKind::cross, 4, 4)});
  JointProperty& joint = scene.properties[0];
  joint.breaks = true;
  joint.cohesion = 10;
  joint.tension = 1;
  joint.reduction = softening({false, 0.01, 0.01, {0.6, 0, 0}});
  scene.fixities = {test::fix(0, test::on_line({0, 0}, {1, 0})), test::fix(0, test::on_line({0, 1}, {1, 1}))};
  scene.fixities[1].motion = Fixity::displacement;
  scene.fixities[1].value = {History(0.0), History({{0, 0}, {1, 0.02}})};
  scene.time.steps = 4;
  scene.fracture.path = path;
  return scene;
}

TEST(Step, ATornSquareGoesOnFromASavedState) {
  for (const CrackPath path : {CrackPath::mesh, CrackPath::tracked}) {
    Simulation straight(torn(path)), restored(torn(path));
    long failed = 0;
    for (int i = 0; i < 12 && !straight.collapsed(); ++i) {
      restored.restore(straight.save());
      straight.step();
      restored.step();
      failed += straight.last.failures;
      ASSERT_EQ(restored.hash(), straight.hash()) << i;
    }
    EXPECT_GT(failed, 4);
  }
}

// Wherever it is left in its search for equilibrium: everything is as before it, and taken again it ends in the same
// bits.
TEST(Step, ASearchForEquilibriumThatIsInterruptedChangesNothing) {
  for (const CrackPath path : {CrackPath::mesh, CrackPath::tracked}) {
    constexpr int steps = 8;
    Simulation undisturbed(torn(path)), interrupted(torn(path));
    long solves = 0, interrupts = 0, failed = 0;
    undisturbed.step_parts().on_equilibrium_solve = [&] { ++solves; };
    for (int i = 0; i < steps; ++i) {
      const std::uint64_t before = interrupted.hash();
      solves = 0;
      undisturbed.step();
      failed += undisturbed.last.failures;
      for (long last = 1; last <= solves; last += 3) {
        long left = last;
        interrupted.step_parts().on_equilibrium_solve = [&] {
          if (--left == 0) throw std::runtime_error("interrupted");
        };
        EXPECT_THROW(interrupted.step(), std::runtime_error);
        EXPECT_EQ(interrupted.hash(), before) << "step " << i << ", solve " << last;
        ++interrupts;
      }
      interrupted.step_parts().on_equilibrium_solve = nullptr;
      interrupted.step();
      ASSERT_EQ(interrupted.hash(), undisturbed.hash()) << "step " << i;
    }
    EXPECT_GT(failed, 0);
    EXPECT_GT(interrupts, steps);
  }
}

}  // namespace
}  // namespace talus
