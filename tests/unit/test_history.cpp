// history.csv and the schedule of output times, on real runs of small scenes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "hand_model.h"
#include "output/files.h"
#include "output/history.h"
#include "output/output.h"
#include "output/progress.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

// A unit square that falls freely from rest, one step of 0.25 s after the other until 1 s.
Scene falling(const std::string& dir) {
  Scene scene;
  Material rock;
  rock.name = "rock";
  rock.density = 2000;
  rock.young = 1e9;
  scene.materials = {rock};
  Region region;
  region.name = "block";
  region.material = 0;
  region.outlines = {test::rectangle(0, 0, 1, 1)};
  scene.regions = {region};
  Probe probe;
  probe.name = "top, right";
  probe.at = {1, 1};
  scene.probes = {probe};
  scene.gravity = {0, -8};
  scene.time.t_end = 1;
  scene.time.dt = 0.25;
  scene.time.displacement_ratio = 100;
  scene.output.dir = dir;
  scene.output.picture = false;
  scene.output.fields = {{"heat", [](int) { return 3.5; }}};
  return scene;
}

std::string scratch(const std::string& name) {
  const fs::path dir = fs::temp_directory_path() / ("talus_test_history_" + std::to_string(getpid())) / name;
  fs::remove_all(dir);
  return dir.string();
}

std::vector<std::vector<std::string>> rows(const std::string& dir) {
  std::ifstream file(dir + "/history.csv");
  std::vector<std::vector<std::string>> all;
  for (std::string line; std::getline(file, line);) {
    all.emplace_back();
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) all.back().push_back(cell);
  }
  return all;
}

std::set<std::string> files(const std::string& dir) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(dir)) names.insert(entry.path().filename().string());
  return names;
}

void run(Scene scene) {
  Simulation simulation(std::move(scene));
  RunOutput output(simulation, "talus falling.lua");
  output.after_step(simulation);
  while (!simulation.finished()) {
    simulation.step();
    output.after_step(simulation);
  }
  output.finish(simulation, "finished", {});
}

TEST(HistoryTable, HeaderWithUnitsAndRowsThatReadBack) {
  const std::string dir = scratch("rows");
  Scene scene = falling(dir);
  scene.output.every = 0.5;
  run(scene);
  std::ifstream file(dir + "/history.csv");
  std::string header;
  std::getline(file, header);
  EXPECT_EQ(header,
            "time [s],step,dt [s],kinetic_energy [J/m],strain_energy [J/m],gravity_energy [J/m],total_energy [J/m],"
            "numerical_loss [J/m],unexplained_energy [J/m],closed_contacts,max_residual,"
            "\"top, right.ux [m]\",\"top, right.uy [m]\",\"top, right.vx [m/s]\",\"top, right.vy [m/s]\","
            "\"top, right.sxx [Pa]\",\"top, right.syy [Pa]\",\"top, right.sxy [Pa]\",heat.min,heat.mean,heat.max");
  const auto table = rows(dir);
  ASSERT_EQ(table.size(), 4u);  // header, 0, 0.5, 1
  EXPECT_EQ(table[1][0], "0");
  EXPECT_EQ(table[2][0], "0.5");
  EXPECT_EQ(table[3][0], "1");
  EXPECT_EQ(table[3][1], "4");
  EXPECT_EQ(table[3][2], "0.25");
  EXPECT_NEAR(std::stod(table[3][3]), 2000 * 64 / 2, 1e-3);  // m v²/2 at v = 8 m/s
  EXPECT_NEAR(std::stod(table[3][14]), -8, 1e-9);
  EXPECT_EQ(table[3].size(), 21u);
  EXPECT_EQ(table[3][19], "3.5");
}

TEST(HistoryTable, RangeOfUserArraysOverTheBlocks) {
  const std::string dir = scratch("range");
  Scene scene = falling(dir);
  scene.probes.clear();
  scene.regions[0].outlines.push_back(test::rectangle(5, 0, 1, 1));
  scene.output.fields = {{"heat", [](int block) { return block == 0 ? -2.0 : 7.0; }}};
  run(scene);
  const auto table = rows(dir);
  EXPECT_EQ((std::vector<std::string>(table[1].end() - 3, table[1].end())),
            (std::vector<std::string>{"-2", "2.5", "7"}));
  EXPECT_EQ(files(dir).count("joints.pvd"), 1u);  // two bodies may touch
  EXPECT_EQ(files(dir).count("joints_00001.vtp"), 1u);
}

TEST(HistoryTable, ResidualIsTheLargestSinceTheLastRow) {
  const std::string dir = scratch("residual");
  Scene scene = falling(dir);
  scene.output.every = 0.5;
  Simulation simulation(scene);
  RunOutput output(simulation, "");
  output.after_step(simulation);
  for (const double residual : {3e-9, 2e-9, 1e-9, 5e-10}) {
    simulation.step();
    simulation.last.residual = residual;
    output.after_step(simulation);
  }
  EXPECT_EQ(rows(dir)[2][10], "3e-09");
  EXPECT_EQ(rows(dir)[3][10], "1e-09");
}

TEST(RunOutput, WritesAtMultiplesFirstAndLast) {
  const std::string dir = scratch("schedule");
  Scene scene = falling(dir);
  scene.output.every = 0.4;  // steps end at 0.25, 0.5, 0.75, 1: due at 0.5 (for 0.4) and 1 (for 0.8)
  run(scene);
  EXPECT_EQ(files(dir), (std::set<std::string>{"blocks.pvd", "blocks_00000.vtp", "blocks_00001.vtp", "blocks_00002.vtp",
                                               "history.csv", "paraview.py", "report.html", "run.json"}));
  EXPECT_EQ(rows(dir)[2][0], "0.5");
}

TEST(RunOutput, WithoutEveryFirstAndLastOnly) {
  const std::string dir = scratch("ends");
  run(falling(dir));
  const auto table = rows(dir);
  ASSERT_EQ(table.size(), 3u);
  EXPECT_EQ(table[1][0], "0");
  EXPECT_EQ(table[2][0], "1");
}

TEST(RunOutput, StaticModeHasARowForEachStepAndFramesWhenDue) {
  const std::string dir = scratch("static");
  Scene scene = falling(dir);
  scene.time.mode = Mode::static_;
  scene.time.steps = 4;
  Fixity fix;
  fix.region = 0;
  fix.on = {On::line, {0, 0}, {1, 0}};
  scene.fixities = {fix};
  run(scene);
  EXPECT_EQ(rows(dir).size(), 6u);  // header, start, four load steps
  EXPECT_EQ(files(dir).count("blocks_00001.vtp"), 1u);
  EXPECT_EQ(files(dir).count("blocks_00002.vtp"), 0u);
}

TEST(RunOutput, RowsAreOnDiskAtOnce) {
  const std::string dir = scratch("flush");
  Simulation simulation(falling(dir));
  RunOutput output(simulation, "");
  output.after_step(simulation);
  EXPECT_EQ(rows(dir).size(), 2u);
}

TEST(RunOutput, FrameOnDemandOncePerStep) {
  const std::string dir = scratch("demand");
  Simulation simulation(falling(dir));
  RunOutput output(simulation, "");
  output.after_step(simulation);
  simulation.step();
  output.frame(simulation);
  output.frame(simulation);
  output.after_step(simulation);
  EXPECT_EQ(files(dir).count("blocks_00001.vtp"), 1u);
  EXPECT_EQ(files(dir).count("blocks_00002.vtp"), 0u);
  EXPECT_EQ(rows(dir).size(), 3u);
}

TEST(HistoryTable, ContinuesWholeRowsAndGoesBack) {
  const std::string dir = scratch("resumed");
  Scene scene = falling(dir);
  run(scene);
  std::ofstream(dir + "/history.csv", std::ios::app) << "1.25,5,0.2";  // cut short by a crash
  Simulation simulation(scene);
  HistoryTable table(dir + "/history.csv", simulation.model, simulation.plan, true);
  EXPECT_EQ(rows(dir).size(), 3u);
  table.rewind(0);
  EXPECT_EQ(rows(dir).size(), 2u);
  EXPECT_TRUE(fs::exists(dir + "/history_before.csv"));
  simulation.totals.steps = 2;
  table.add(simulation, 0, {{"heat", {1.0}}});
  EXPECT_EQ(rows(dir).size(), 3u);
  EXPECT_EQ(rows(dir)[2][1], "2");
}

TEST(HistoryTable, OfOtherColumnsIsKeptBeside) {
  const std::string dir = scratch("columns");
  Scene scene = falling(dir);
  run(scene);
  const size_t columns = rows(dir)[0].size();
  scene.probes.clear();
  const Simulation simulation(scene);
  const HistoryTable table(dir + "/history.csv", simulation.model, simulation.plan, true);
  EXPECT_EQ(rows(dir).size(), 1u);
  EXPECT_LT(rows(dir)[0].size(), columns);
  EXPECT_TRUE(fs::exists(dir + "/history_before.csv"));
}

TEST(FrameNumber, IsThatOfTheName) {
  EXPECT_EQ(frame_number(frame_name("blocks", 12, ".vtp")), 12);
  EXPECT_EQ(frame_number(frame_name("blocks", 1234567, ".vtp")), 1234567);
  EXPECT_EQ(frame_number("blocks.pvd"), -1);
  EXPECT_EQ(frame_number("blocks_1x.vtp"), -1);
  EXPECT_EQ(frame_number(""), -1);
}

TEST(RunOutput, PicturesWhenAskedFor) {
  const std::string dir = scratch("picture");
  Scene scene = falling(dir);
  scene.output.picture = true;
  scene.output.vtk = false;
  run(scene);
  EXPECT_EQ(files(dir), (std::set<std::string>{"energy.svg", "picture_00000.svg", "picture_00001.svg", "history.csv",
                                               "report.html", "run.json"}));
}

TEST(RunOutput, SwitchedOffMakesNothing) {
  const fs::path here = fs::current_path();
  const std::string dir = scratch("off");
  fs::create_directories(dir);
  fs::current_path(dir);
  run(falling(""));
  fs::current_path(here);
  EXPECT_TRUE(files(dir).empty());
}

TEST(RunOutput, RerunRemovesItsOwnFormerFilesOnly) {
  const std::string dir = scratch("rerun");
  fs::create_directories(dir);
  for (const char* name : {"blocks_00099.vtp", "joints_00099.vtp", "joints.pvd", "picture_00003.svg", "energy.svg",
                           "blocks_00098.vtp.part", "blocks_old.vtp", "notes.txt", "picture.svg", "blocks_1.vtp"})
    std::ofstream(dir + "/" + name) << "x";
  run(falling(dir));
  EXPECT_EQ(files(dir), (std::set<std::string>{"blocks.pvd", "blocks_00000.vtp", "blocks_00001.vtp", "history.csv",
                                               "paraview.py", "report.html", "run.json", "blocks_old.vtp", "notes.txt",
                                               "picture.svg", "blocks_1.vtp"}));
}

TEST(RunOutput, DirectoryThatCannotBeIsAnInputError) {
  const std::string dir = scratch("file");
  fs::create_directories(fs::path(dir).parent_path());
  std::ofstream(dir) << "x";
  Scene scene = falling(dir + "/below");
  scene.output.place = {"scene.lua", 12};
  Simulation simulation(scene);
  try {
    RunOutput output(simulation, "");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("scene.lua:12: output.dir: expected a directory that can be written, got "), 0u) << message;
  }
}

TEST(RunOutput, UnknownPictureFieldIsRefusedBeforeAnythingIsWritten) {
  const std::string dir = scratch("unknown");
  Scene scene = falling(dir);
  scene.output.picture = true;
  scene.output.picture_field = "sx";
  Simulation simulation(scene);
  EXPECT_THROW(RunOutput(simulation, ""), InputError);
  EXPECT_FALSE(fs::exists(dir));
}

TEST(WriteWhole, ReplacesAndNamesThePathWhenItCannot) {
  const std::string dir = scratch("whole");
  fs::create_directories(dir);
  write_whole(dir + "/a", "one");
  write_whole(dir + "/a", std::string("t\0o", 3));
  EXPECT_EQ(fs::file_size(dir + "/a"), 3u);
  EXPECT_EQ(files(dir).size(), 1u);
  try {
    write_whole(dir + "/none/a", "x");
    FAIL() << "accepted";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find(dir + "/none/a: No such file"), std::string::npos) << error.what();
  }
}

TEST(Progress, Lines) {
  StepReport step;
  step.step = 456;
  step.time = 0.123;
  step.dt = 1e-3;
  step.iterations = 3;
  step.closed_contacts = 120;
  EXPECT_EQ(progress_line(step, 1, 15), "t 0.123 s (12 %)  step 456  dt 1.0e-03 s  it 3  contacts 120  ETA 15 s");
  EXPECT_EQ(progress_line(step, 0.123, 0), "t 0.123 s (100 %)  step 456  dt 1.0e-03 s  it 3  contacts 120");
  EXPECT_NE(progress_line(step, 100, 48718).find("ETA 13.5 h"), std::string::npos);
  const double ended = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(done_line(ended, 1, 1340, 0.084, ""), "done: 1 step, 1340 blocks, 0.08 s CPU");
  EXPECT_EQ(done_line(ended, 2, 1, 12.4, "out/a"), "done: 2 steps, 1 block, 12 s CPU; results in out/a");
  EXPECT_EQ(done_line(0.06, 3, 2, 0.02, ""), "stopped at t = 0.06 s: 3 steps, 2 blocks, 0.02 s CPU");
}

}  // namespace
}  // namespace talus
