#include <gtest/gtest.h>

#include <set>

#include "contact/box_grid.h"
#include "small_scene.h"
#include "step/simulation.h"

namespace talus {
namespace {

using test::rectangle;
using test::region;

Scene moving(const std::vector<Region>& regions, bool sleeping) {
  Scene scene = test::scene_of(regions);
  scene.regions[0].held = true;
  scene.gravity = {0, -9};
  scene.time.mode = Mode::dynamic;
  scene.time.t_end = 10;
  scene.time.dt = 0.01;
  scene.time.settled_start = true;
  scene.numerics.sleeping = sleeping;
  return scene;
}

// A stack of two on a floor, and a block that falls on it.
Scene falling(bool sleeping) {
  Scene scene = moving({region("floor", rectangle(-10, -1, 20, 1)), region("low", rectangle(0, 0, 1, 1)),
                        region("high", rectangle(0, 1, 1, 1)), region("block", rectangle(0.2, 3, 1, 1))},
                       sleeping);
  scene.time.settled_start = false;
  return scene;
}

std::vector<double> places(const Model& model) {
  std::vector<double> all;
  for (const BlockState& state : model.blocks) {
    all.insert(all.end(), {state.shift.x(), state.shift.y(), state.angle, state.strain[0], state.strain[1]});
    all.insert(all.end(), state.velocity.begin(), state.velocity.end());
  }
  return all;
}

// A column between two held blocks, of which the upper one comes down on it after a while.
Scene pressed(bool sleeping) {
  Scene scene = moving({region("floor", rectangle(-10, -1, 20, 1)), region("column", rectangle(0, 0, 1, 1)),
                        region("press", rectangle(0, 1.5, 1, 1))},
                       sleeping);
  Fixity down;
  down.region = 2;
  down.motion = Fixity::displacement;
  down.value[1] = History(std::vector<std::pair<double, double>>{{0, 0}, {0.3, 0}, {0.6, -0.51}, {10, -0.51}});
  scene.fixities.push_back(down);
  return scene;
}

void expect_same(const Scene& with, const Scene& without, int steps, long least_asleep) {
  Simulation slept(with), awake(without);
  for (int i = 0; i < steps; ++i) {
    slept.step();
    awake.step();
    ASSERT_EQ(places(slept.model), places(awake.model)) << "step " << i;
    ASSERT_EQ(slept.model.contacts.size(), awake.model.contacts.size()) << "step " << i;
  }
  EXPECT_GE(slept.totals.islands.asleep, least_asleep);
  EXPECT_EQ(awake.totals.islands.asleep, 0);
}

TEST(Sleep, AFallingBlockWakesTheStackAsIfItHadNotSlept) {
  Scene with = falling(true), without = falling(false);
  with.time.settled_start = without.time.settled_start = false;
  expect_same(with, without, 200, 0);
}

TEST(Sleep, AHeldBlockThatComesNearWakes) {
  expect_same(pressed(true), pressed(false), 80, 20);
}

// A hit in the midst of a step throws the second block into the third, which nothing had come near as the step began.
TEST(Sleep, WhatIsThrownWithinAStepWakesWhatItMeets) {
  const auto thrown = [](bool sleeping) {
    Region shot = region("shot", rectangle(-6.05, 0, 1, 1));
    shot.velocity = {90, 0};
    Scene scene = moving({region("floor", rectangle(-10, -5, 20, 1)), shot, region("struck", rectangle(0, 0, 1, 1)),
                          region("met", rectangle(1.12, 0, 1, 1))},
                         sleeping);
    scene.gravity = {0, 0};
    scene.time.settled_start = false;
    return scene;
  };
  expect_same(thrown(true), thrown(false), 12, 4);
}

TEST(Sleep, ContactsOfWhatSleepsStandFirst) {
  Simulation simulation(pressed(true));
  for (int i = 0; i < 5; ++i) simulation.step();
  const Model& model = simulation.model;
  ASSERT_TRUE(model.sleeps(1));
  EXPECT_EQ(model.asleep[1], 2);  // by its first block
  EXPECT_EQ(model.sleeping_contacts, int(model.contacts.size()));
  EXPECT_GT(model.sleeping_contacts, 0);
}

TEST(Sleep, AChangeWakesAll) {
  Simulation simulation(pressed(true));
  for (int i = 0; i < 5; ++i) simulation.step();
  simulation.model.changed();
  EXPECT_FALSE(simulation.model.sleeps(1));
  EXPECT_EQ(simulation.model.sleeping_contacts, 0);
  const std::vector<double> before = places(simulation.model);
  simulation.step();
  EXPECT_EQ(places(simulation.model), before);
  EXPECT_TRUE(simulation.model.sleeps(1));
}

TEST(Sleep, OffNothingIsKeptForIt) {
  Simulation simulation(pressed(false));
  for (int i = 0; i < 5; ++i) simulation.step();
  EXPECT_TRUE(simulation.model.asleep.empty());
}

TEST(Sleep, ARunWithoutItWakesWhatARestoredStateLetSleep) {
  Simulation slept(pressed(true)), awake(pressed(false));
  for (int i = 0; i < 5; ++i) slept.step();
  awake.restore(slept.save());
  EXPECT_FALSE(awake.model.sleeps(1));
  slept.step();
  awake.step();
  EXPECT_EQ(places(slept.model), places(awake.model));
}

TEST(BoxGrid, ALargeBoxAmongSmallOnesMeetsAll) {
  std::vector<Box> boxes;
  for (int k = 0; k < 50; ++k) boxes.push_back({{2.0 * k, 0}, {2.0 * k + 1, 1}});
  BoxGrid grid;
  grid.fill(boxes);
  std::set<int> met;  // each may come more than once
  grid.each_meeting({{-1e6, 0.5}, {1e6, 2}}, -1000, [&](int k) { met.insert(k); });
  EXPECT_EQ(met.size(), 50u);
  met.clear();
  grid.each_meeting({{9.5, 0.5}, {10.5, 0.6}}, -1000, [&](int k) { met.insert(k); });
  ASSERT_FALSE(met.empty());
  for (const int k : met) EXPECT_EQ(k, 5);
}

}  // namespace
}  // namespace talus
