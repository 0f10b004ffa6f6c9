#include <gtest/gtest.h>

#include <cmath>

#include "hand_model.h"
#include "output/json.h"
#include "output/report.h"
#include "output/versions.h"

namespace talus {
namespace {

bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Json, NestsAndSeparates) {
  Json json;
  json.object().whole("a", 1).array("b").text("x").object().end().end().truth("c", false).array("d").end().end();
  EXPECT_EQ(json.file(), R"({
  "a": 1,
  "b": [
    "x",
    {}
  ],
  "c": false,
  "d": []
}
)");
}

TEST(Json, EscapesStringsAndKeys) {
  Json json;
  json.object().text("say \"\\\"", "line\n\ttab \x01 \xff é").end();
  EXPECT_EQ(json.file(), "{\n  \"say \\\"\\\\\\\"\": \"line\\n\\ttab \\u0001 \xEF\xBF\xBD é\"\n}\n");
}

TEST(Json, NumbersReadBackAndNonFiniteOnesAreNull) {
  Json json;
  json.object().number("a", 0.1).number("b", NAN).number("c", -INFINITY).number("d", 1e300).end();
  EXPECT_EQ(json.file(), "{\n  \"a\": 0.1,\n  \"b\": null,\n  \"c\": null,\n  \"d\": 1e+300\n}\n");
}

TEST(RunReport, TellsWhatWasRunAndHowItWent) {
  Scene scene;
  scene.file = "examples/x.lua";
  Material rock;
  rock.density = 2000;
  rock.young = 1e9;
  scene.materials = {rock};
  Region region;
  region.material = 0;
  region.outlines = {test::rectangle(0, 0, 1, 1)};
  scene.regions = {region};
  scene.time.t_end = 1;
  Simulation simulation(scene);
  simulation.totals.steps = 7;
  simulation.totals.cuts = 2;
  simulation.totals.largest_iterations = 9;
  simulation.totals.largest_residual = NAN;
  simulation.totals.seconds("solve") = 0.25;
  const RunAccount account = {.command_line = "talus \"x y.lua\"",
                              .outcome = "stopped",
                              .wall_seconds = 2,
                              .cpu_seconds = 1.5,
                              .checks = {{"tip", "1.01", "1 ± 0.02", true}, {"angle", "3", "< 2", false}},
                              .restores = {{"x.state", 300, 0.5}}};
  const std::string json = run_report(simulation, account);
  EXPECT_TRUE(has_part(json, "\"talus\": \"" + versions().talus + "\""));
  EXPECT_TRUE(has_part(json, "\"vtk\": \"9."));
  EXPECT_TRUE(has_part(json, "\"scene\": \"examples/x.lua\""));
  EXPECT_TRUE(has_part(json, "\"command_line\": \"talus \\\"x y.lua\\\"\""));
  EXPECT_TRUE(has_part(json, "\"outcome\": \"stopped\""));
  EXPECT_TRUE(has_part(json, "\"state_hash\": \"" + hex(simulation.hash()) + "\""));
  EXPECT_TRUE(has_part(json, "\"from\": \"x.state\",\n      \"step\": 300,\n      \"time\": 0.5"));
  EXPECT_TRUE(has_part(json, "\"blocks\": 1,"));
  EXPECT_TRUE(has_part(json, "\"unknowns\": 6,"));
  EXPECT_TRUE(has_part(json, "\"steps\": 7,"));
  EXPECT_TRUE(has_part(json, "\"step_cuts\": 2,"));
  EXPECT_TRUE(has_part(json, "\"largest_iterations\": 9,"));
  EXPECT_TRUE(has_part(json, "\"largest_residual\": null,"));
  EXPECT_TRUE(has_part(json, "\"solve\": 0.25,"));
  EXPECT_TRUE(has_part(json, "\"total\": 1.5\n"));
  EXPECT_TRUE(has_part(json, "\"wall_seconds\": 2,"));
  EXPECT_TRUE(has_part(json, "\"expected\": \"1 ± 0.02\",\n      \"pass\": true"));
  EXPECT_TRUE(has_part(json, "\"value\": \"3\",\n      \"expected\": \"< 2\",\n      \"pass\": false"));
  EXPECT_TRUE(has_part(json, simulation.plan.lines.at(0).first + ": "));
}

}  // namespace
}  // namespace talus
