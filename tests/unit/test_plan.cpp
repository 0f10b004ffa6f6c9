#include <gtest/gtest.h>

#include <algorithm>

#include "gas/eos.h"
#include "output/report.h"
#include "scene/plan.h"
#include "script/plan_text.h"
#include "small_scene.h"

namespace talus {
namespace {

using test::on_line;
using test::rectangle;
using test::region;
using test::scene_of;

const Polyline box = rectangle(0, 0, 2, 1);

Plan plan_of(const Scene& scene) {
  return make_plan(build(scene));
}

std::vector<std::string> parts(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& [part, text] : plan_of(scene).lines) names.push_back(part);
  return names;
}
using Parts = std::vector<std::string>;

std::string line(const Scene& scene, const std::string& part) {
  for (const auto& [name, text] : plan_of(scene).lines)
    if (name == part) return text;
  return "absent";
}

TEST(Plan, OfOneBlockInFlightHasNothingBeside) {
  Scene scene = scene_of({region("box", box)});
  scene.time.mode = Mode::dynamic;
  const Plan plan = plan_of(scene);
  EXPECT_TRUE(plan.dynamic);
  EXPECT_FALSE(plan.bonds || plan.contacts || plan.fixities || plan.point_loads || plan.edge_loads ||
               plan.body_forces || plan.held_blocks || plan.recovery);
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode"}));
  EXPECT_EQ(line(scene, "blocks"), "1 block: 1 first order, 0 rigid, 0 held; 6 unknowns");
  EXPECT_EQ(line(scene, "mode"), "dynamic, velocity theta-scheme");
}

TEST(Plan, EachFeatureAddsItsPartAndNoOther) {
  const Scene plain = scene_of({region("box", box)});
  Scene scene = plain;
  scene.gravity = {0, -10};
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "body forces"}));
  scene = plain;
  scene.regions[0].body_force[1] = History(-3);
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "body forces"}));
  scene = plain;
  scene.fixities = {test::fix(0, on_line({0, 0}, {2, 0}))};
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "fixities"}));
  EXPECT_EQ(line(scene, "fixities"), "1 edge, 0 points");
  scene = plain;
  scene.edge_loads = {test::traction(0, on_line({0, 1}, {2, 1}), {0, -1})};
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "edge loads"}));
  scene = plain;
  scene.point_loads.resize(1);
  scene.point_loads[0].at = {2, 1};
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "point loads"}));
  scene = plain;
  scene.regions.push_back(region("other", rectangle(2, 0, 1, 1)));
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "contacts"}));
}

TEST(Plan, BondedRockHasNoContactsUntilItIsCut) {
  Scene scene = scene_of({test::patterned("box", box, MeshKind::cross, 2, 1)});
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "bonds", "stress recovery"}));
  EXPECT_EQ(line(scene, "bonds"), "9 exact (Nitsche), 0 by springs");
  scene.numerics.recovery = false;
  scene.properties[0].bond = BondKind::spring;
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "bonds"}));
  EXPECT_EQ(line(scene, "bonds"), "0 exact (Nitsche), 9 by springs");

  Scene cut = scene_of({region("box", box)});
  Trace trace;
  trace.points = {{1, -1}, {1, 2}};
  cut.regions[0].traces = {trace};
  EXPECT_EQ(parts(cut), (Parts{"blocks", "mode", "contacts"}));
  cut.regions[0].traces[0].bonded = true;
  EXPECT_EQ(parts(cut), (Parts{"blocks", "mode", "bonds", "stress recovery"}));
}

// A bonded body that a trace enters but does not divide is one body with a crack, and its faces may touch.
TEST(Plan, ACrackHasContacts) {
  Scene scene = scene_of({test::meshed("box", box, 0.4)});
  Trace crack;
  crack.points = {{0.5, 0.5}, {1.5, 0.5}};
  scene.regions[0].traces = {crack};
  EXPECT_TRUE(plan_of(scene).contacts);
  EXPECT_TRUE(plan_of(scene).bonds);
}

// Rock that a charge breaks has all that there is beside loads and supports, and loses each part with what it comes
// from.
TEST(Plan, RockUnderGas) {
  Scene scene = scene_of({test::meshed("rock", box, 0.5)});
  scene.time.mode = Mode::dynamic;
  scene.regions[0].holes.resize(1);
  scene.regions[0].holes[0].outline = {{0.8, 0.4}, {0.8, 0.6}, {1.2, 0.6}, {1.2, 0.4}};
  scene.properties[0].breaks = true;
  scene.properties[0].cohesion = 10;
  scene.properties[0].tension = 5;
  Charge& charge = scene.charges.emplace_back();
  charge.region = charge.hole = 0;
  charge.law = polytropic(100, 1.4);
  ViscousBoundary& viscous = scene.viscous_boundaries.emplace_back();
  viscous.region = 0;
  viscous.on = on_line({0, 0}, {2, 0});
  EXPECT_EQ(parts(scene),
            (Parts{"blocks", "mode", "bonds", "fracture", "gas", "contacts", "viscous boundaries", "stress recovery"}));
  EXPECT_EQ(line(scene, "gas"), "1 charge");
  scene.charges.clear();
  EXPECT_EQ(parts(scene),
            (Parts{"blocks", "mode", "bonds", "fracture", "contacts", "viscous boundaries", "stress recovery"}));
  scene.properties[0].breaks = false;
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "bonds", "viscous boundaries", "stress recovery"}));
  scene.viscous_boundaries.clear();
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "bonds", "stress recovery"}));
}

TEST(Plan, OrdersAndHeldBlocks) {
  Scene scene = scene_of({region("a", box), region("b", rectangle(3, 0, 1, 1)), region("c", rectangle(5, 0, 1, 1))});
  scene.regions[1].order = BlockOrder::rigid;
  scene.regions[2].held = true;
  EXPECT_EQ(line(scene, "blocks"), "3 blocks: 1 first order, 1 rigid, 1 held; 9 unknowns");
  EXPECT_TRUE(plan_of(scene).held_blocks);
  scene.regions[2].held = false;
  EXPECT_FALSE(plan_of(scene).held_blocks);
  scene.fixities = {test::fix(2, {})};  // the whole region
  EXPECT_TRUE(plan_of(scene).held_blocks);
  EXPECT_FALSE(plan_of(scene).fixities);
}

TEST(Plan, ErrorsOfStepsAreLookedAtWhereTheyAreAskedFor) {
  Scene scene = scene_of({region("box", box)});
  scene.time.mode = Mode::dynamic;
  scene.time.tolerance = 1e-3;
  EXPECT_EQ(parts(scene), (Parts{"blocks", "mode", "step error"}));
  EXPECT_TRUE(plan_of(scene).step_error);
  scene.time.mode = Mode::static_;
  EXPECT_FALSE(plan_of(scene).step_error);
}

TEST(Plan, ModeNamesTheIntegrator) {
  Scene scene = scene_of({region("box", box)});
  scene.time.steps = 4;
  EXPECT_EQ(line(scene, "mode"), "static equilibrium, 4 load steps");
  scene.time.mode = Mode::dynamic;
  scene.numerics.integrator = Integrator::newmark;
  EXPECT_EQ(line(scene, "mode"), "dynamic, Newmark (1/2, 1)");
}

// What is absent takes no time: no part of it is called.
TEST(Plan, WhatIsAbsentIsNotCalled) {
  Scene scene = scene_of({region("box", box)});
  scene.time.mode = Mode::dynamic;
  scene.time.dt = 0.1;
  Simulation free_flight(scene);
  free_flight.step();
  for (const auto& part : free_flight.totals.parts) EXPECT_NE(part.name, "contact search");
  scene.regions.push_back(region("other", rectangle(4, 0, 1, 1)));
  Simulation two(scene);
  two.step();
  EXPECT_TRUE(std::any_of(two.totals.parts.begin(), two.totals.parts.end(),
                          [](const auto& part) { return part.name == "contact search"; }));
}

TEST(Plan, TextAndReportTellItLineByLine) {
  Scene scene = scene_of({test::patterned("box", box, MeshKind::cross, 2, 1)});
  scene.title = "a box";
  const Simulation simulation(scene);
  const std::string text = plan_text(simulation), json = run_report(simulation, {});
  EXPECT_EQ(text.find("plan of a box"), 0u);
  for (const auto& [part, what] : simulation.plan.lines) {
    EXPECT_NE(text.find("  " + part), std::string::npos);
    EXPECT_NE(text.find(what), std::string::npos);
    EXPECT_NE(json.find(part + ": " + what), std::string::npos) << json;
  }
  for (const char* absent : {"contacts", "fixities", "loads", "body forces"}) {
    EXPECT_EQ(text.find(absent), std::string::npos) << text;
    EXPECT_EQ(json.find(std::string(absent) + ": "), std::string::npos) << json;
  }
}

}  // namespace
}  // namespace talus
