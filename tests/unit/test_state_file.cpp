// Saved states as files: whole or refused. And a real run that goes on from one.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "output/files.h"
#include "output/state_file.h"
#include "small_scene.h"
#include "step/simulation.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string scratch_state(const std::string& name) {
  const fs::path dir = fs::temp_directory_path() / ("talus_test_state_" + std::to_string(getpid()));
  fs::create_directories(dir);
  return (dir / name).string();
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

SavedRun sample() {
  return {.simulation = 2,
          .step = 300,
          .time = 0.1,
          .scene = {.blocks = 3, .joints = 4, .vertices = 5, .geometry = 6, .values = 7},
          .layout = 8,
          .talus = "0.1.0 (abc)",
          .engine = std::string("a\0b", 3),
          .output = "",
          .script = "script"};
}

TEST(StateFile, ReadsBackWhatWasWritten) {
  const std::string path = scratch_state("whole.state");
  const SavedRun saved = sample();
  write_state(path, saved);
  const SavedRun back = read_state(path);
  EXPECT_EQ(back.simulation, 2);
  EXPECT_EQ(back.step, 300);
  EXPECT_EQ(back.time, 0.1);
  EXPECT_EQ(back.layout, 8u);
  EXPECT_EQ(back.talus, saved.talus);
  EXPECT_EQ(back.engine, saved.engine);
  EXPECT_EQ(back.output, saved.output);
  EXPECT_EQ(back.script, saved.script);
  EXPECT_EQ(back.scene.joints, 4);
  check_same_scene(back.scene, saved.scene);
  EXPECT_FALSE(fs::exists(path + ".part"));
}

TEST(StateFile, CutAtAnyLengthIsRefused) {
  const std::string path = scratch_state("cut.state");
  write_state(path, sample());
  const std::string whole = bytes_of(path);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write_whole(path, whole.substr(0, length));
    EXPECT_THROW(read_state(path), StateError) << length;
  }
  write_whole(path, whole + "x");
  EXPECT_THROW(read_state(path), StateError);
}

TEST(StateFile, AnyByteChangedIsRefused) {
  const std::string path = scratch_state("flipped.state");
  write_state(path, sample());
  const std::string whole = bytes_of(path);
  for (std::size_t at = 0; at < whole.size(); ++at)
    for (const int bit : {1, 128}) {
      std::string flipped = whole;
      flipped[at] = static_cast<char>(flipped[at] ^ bit);
      write_whole(path, flipped);
      EXPECT_THROW(read_state(path), StateError) << at;
    }
}

TEST(StateFile, TheFormerFileStaysWhenTheNewOneCannotBeWritten) {
  const std::string path = scratch_state("none/x.state");
  EXPECT_THROW(write_state(path, sample()), RunError);
  EXPECT_THROW(read_state(path), StateError);
}

// Two squares fall on a held one.
Scene falling() {
  Scene scene = test::scene_of({test::region("floor", {{-3, -1}, {3, -1}, {3, 0}, {-3, 0}}),
                                test::region("low", {{0, 0.01}, {1, 0.01}, {1, 1.01}, {0, 1.01}}),
                                test::region("high", {{0.3, 1.05}, {1.3, 1.05}, {1.3, 2.05}, {0.3, 2.05}})});
  scene.regions[0].held = true;
  scene.contact = 0;
  scene.gravity = {0, -10};
  scene.time.mode = Mode::dynamic;
  scene.time.t_end = 10;
  return scene;
}

void advance(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.step();
}

TEST(SimulationState, GoesOnBitByBit) {
  Simulation one(falling()), two(falling()), three(falling());
  advance(one, 40);
  EXPECT_GT(one.last.closed_contacts, 0);
  const std::string half = one.save();
  const std::uint64_t at_half = one.hash();
  advance(one, 40);
  advance(two, 80);
  EXPECT_EQ(two.hash(), one.hash());
  EXPECT_NE(at_half, one.hash());
  three.restore(half);
  EXPECT_EQ(three.hash(), at_half);
  EXPECT_EQ(three.totals.steps, 40);
  advance(three, 40);
  EXPECT_EQ(three.save(), one.save());
}

TEST(SimulationState, AStateOfOtherTablesChangesNothing) {
  Simulation one(falling());
  Scene scene = falling();
  scene.regions.pop_back();
  Simulation smaller(scene);
  advance(one, 5);
  const std::string before = one.save();
  EXPECT_THROW(one.restore(smaller.save()), StateError);
  EXPECT_THROW(one.restore(before.substr(0, before.size() - 1)), StateError);
  EXPECT_THROW(one.restore(before + "x"), StateError);
  EXPECT_EQ(one.save(), before);
  EXPECT_EQ(one.layout(), smaller.layout());
}

TEST(SimulationState, AStoppedRunGoesOnAfterARestore) {
  Simulation one(falling());
  advance(one, 5);
  one.stop();
  const std::string state = one.save();
  EXPECT_TRUE(one.finished());
  one.restore(state);
  EXPECT_FALSE(one.finished());
}

// A step size of the former run does not pass the bounds that the scene sets now.
TEST(SimulationState, ASmallerStepOfTheSceneHolds) {
  Scene scene = falling();
  scene.time.dt = 2e-3;
  Simulation one(scene);
  advance(one, 3);
  scene.time.dt = 1e-3;
  Simulation two(scene);
  two.restore(one.save());
  EXPECT_NEAR(two.step().dt, 1e-3, 1e-12);
}

}  // namespace
}  // namespace talus
