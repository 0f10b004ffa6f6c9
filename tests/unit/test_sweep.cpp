// The parts of `talus sweep` that need no process: marks of finished runs, locks, keys, tables and plots.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "input/file_hash.h"
#include "model/saved_state.h"
#include "scene/error.h"
#include "sweep/key.h"
#include "sweep/map.h"
#include "sweep/outcome.h"
#include "sweep/page.h"
#include "sweep/plots.h"
#include "sweep/process.h"
#include "sweep/sweep_progress.h"
#include "sweep/table.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

class Folder {
 public:
  explicit Folder(const std::string& name) : path_(fs::path(testing::TempDir()) / ("talus_sweep_" + name)) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string path(const std::string& name = "") const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
  }

 private:
  fs::path path_;
};

Setting number(const std::string& name, double value) {
  std::ostringstream text;
  text << value;
  return {name, text.str(), "number", value};
}

// angle × friction, one column; the value is angle·friction.
Study grid(const std::vector<double>& angles, const std::vector<double>& frictions, std::vector<StudyRow>& rows) {
  Study study;
  study.title = "a & b";
  study.parameters = {"angle", "friction"};
  study.columns = {{"way", "m", "way", false}};
  for (const double angle : angles)
    for (const double friction : frictions) {
      const Setting a = number("angle", angle), f = number("friction", friction);
      study.runs.push_back({"angle=" + a.text + "_friction=" + f.text, {a, f}});
      StudyRow row;
      row.outcome = Outcome{.wall = 1, .cpu = 0.5};
      row.collected = {{Cell{"value", angle * friction}}, {""}, ""};
      rows.push_back(row);
    }
  return study;
}

TEST(Outcome, ComesBackFromItsFile) {
  const Folder folder("outcome");
  const Outcome written{.key = 0xfedcba9876543210u,
                        .exit_status = 1,
                        .wall = 1.25,
                        .cpu = 0.5,
                        .message = "failed: a, b",
                        .inputs = {{"scene.lua", 7}, {"../parts/a b.lua", 8}}};
  write_outcome(folder.path(), written);
  const auto read = read_outcome(folder.path());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->key, written.key);
  EXPECT_EQ(read->exit_status, 1);
  EXPECT_EQ(read->wall, 1.25);
  EXPECT_EQ(read->message, written.message);
  ASSERT_EQ(read->inputs.size(), 2u);
  EXPECT_EQ(read->inputs[1].path, "../parts/a b.lua");
  EXPECT_EQ(read->inputs[1].hash, 8u);
  remove_outcome(folder.path());
  EXPECT_FALSE(read_outcome(folder.path()));
}

TEST(Outcome, CutShortAnywhereIsNone) {
  const Folder folder("cut");
  write_outcome(folder.path(), {.key = 1, .message = "x", .inputs = {{"scene.lua", 7}}});
  const std::string whole = folder.read("run.done");
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    folder.write("run.done", whole.substr(0, length));
    EXPECT_FALSE(read_outcome(folder.path())) << length;
  }
}

TEST(Outcome, WhatASignalEndedIsNotFinal) {
  EXPECT_TRUE(Outcome{}.good());
  EXPECT_TRUE((Outcome{.exit_status = 3}).final());
  EXPECT_FALSE((Outcome{.exit_status = 3}).has_results());
  EXPECT_FALSE((Outcome{.signal = 9}).final());
  EXPECT_EQ((Outcome{.signal = 9}).status(), "killed");
  EXPECT_FALSE((Outcome{.exit_status = 143}).final());
  EXPECT_TRUE((Outcome{.exit_status = 143, .time_limit = 5}).final());
  EXPECT_EQ((Outcome{.exit_status = 143, .time_limit = 5}).status(), "time limit");
  EXPECT_EQ((Outcome{.exit_status = 127}).status(), "failed");
}

TEST(Outcome, MessagesAreTheRunsOwn) {
  const Folder folder("log");
  folder.write("log.txt",
               "PASS  a  1  expected 1\nFAIL  way, m  2  expected 1\nFAIL  b  2  expected 1\ntalus: x.lua:3: no\n");
  EXPECT_EQ(message_of_log(folder.path("log.txt"), 1, 0), "way, m, b");
  EXPECT_EQ(message_of_log(folder.path("log.txt"), 2, 0), "x.lua:3: no");
  EXPECT_EQ(message_of_log(folder.path("log.txt"), 0, 0), "");
  EXPECT_EQ(message_of_log(folder.path("log.txt"), 0, 9), "ended by signal 9 (Killed)");
}

TEST(FolderLock, IsHeldOnce) {
  const Folder folder("lock");
  {
    const FolderLock first(folder.path("run"));
    EXPECT_TRUE(first.held());
    EXPECT_FALSE(FolderLock(folder.path("run")).held());
  }
  EXPECT_TRUE(FolderLock(folder.path("run")).held());
  folder.write("file", "");
  EXPECT_THROW(FolderLock(folder.path("file")), RunError);
}

TEST(Keys, FollowEverythingThatARunDependsOn) {
  const Folder folder("keys");
  fs::create_directories(folder.path("lib"));
  folder.write("lib/a.lua", "1");
  folder.write("scene.lua", "1");
  std::vector<StudyRow> rows;
  Study study = grid({1, 2}, {3}, rows);
  study.scene = folder.path("scene.lua");
  study.library = folder.path("lib");
  const Keys keys(study);
  EXPECT_NE(keys.of(0), keys.of(1));
  EXPECT_EQ(keys.of(0), Keys(study).of(0));
  folder.write("inputs", hex(hash_of_file(study.scene)) + " " + study.scene + "\n" +
                             hex(hash_of_file(folder.path("lib/a.lua"))) + " " + folder.path("lib/a.lua") + "\n");
  const Outcome outcome{.key = keys.of(0), .inputs = keys.read_inputs(folder.path("inputs"))};
  ASSERT_EQ(outcome.inputs.size(), 2u);
  EXPECT_EQ(outcome.inputs[0].path, "scene.lua");
  EXPECT_EQ(outcome.inputs[1].path, "<library>/a.lua");
  EXPECT_TRUE(Keys(study).same(0, outcome));
  EXPECT_FALSE(Keys(study).same(1, outcome));
  EXPECT_FALSE(Keys(study).same(0, {.key = keys.of(0)})) << "nothing is known of its files";
  folder.write("scene.lua", "2");
  EXPECT_FALSE(Keys(study).same(0, outcome));
  folder.write("scene.lua", "1");
  EXPECT_TRUE(Keys(study).same(0, outcome));
  folder.write("lib/a.lua", "2");
  EXPECT_FALSE(Keys(study).same(0, outcome));
}

TEST(Shell, QuotesWhatItWouldChange) {
  EXPECT_EQ(shell_quoted("a=1_b=0.5"), "a=1_b=0.5");
  for (const std::string text : {"", "a b", "it's", "$HOME", "a;b", "*", "\"x\"", "a\\b", "é"})
    EXPECT_EQ(capture({"sh", "-c", "printf %s " + shell_quoted(text)}).text, text);
  EXPECT_EQ(capture({"sh", "-c", "exit 5"}).exit_status, 5);
  EXPECT_EQ(capture({"sh", "-c", "kill -9 $$"}).exit_status, 137);
  EXPECT_EQ(capture({"/no/such/program"}).exit_status, 127);
}

TEST(Progress, EstimatesFromWhatHasEnded) {
  EXPECT_LT(seconds_left({.all = 4}, 0, {}, 2), 0);
  // Six are left, 10 s each, two at a time; two of them have been at work for 5 s and 20 s.
  EXPECT_DOUBLE_EQ(seconds_left({.all = 10, .before = 2, .ended = 2}, 10, {5, 20}, 2), (60 - 5 - 10) / 2.0);
  EXPECT_DOUBLE_EQ(seconds_left({.all = 3, .ended = 2}, 10, {4}, 8), 6);
  EXPECT_EQ(sweep_line({.all = 40, .before = 5, .ended = 7, .failed = 1}, 2, 120),
            "12 of 40 runs, 2 at work, 1 failed, about 2 min left");
}

TEST(ResultsTable, HasARowARun) {
  std::vector<StudyRow> rows;
  const Study study = grid({1}, {3, 4}, rows);
  rows[0].collected.cells[0].text = "3";
  rows[1] = {};
  rows[1].note = "a, \"b\"";
  EXPECT_EQ(results_table(study, rows),
            "run,angle,friction,status,way [m],message,wall [s],cpu [s]\n"
            "angle=1_friction=3,1,3,done,3,,1.000,0.500\n"
            "angle=1_friction=4,1,4,not run,,\"a, \"\"b\"\"\",,\n");
}

std::size_t count_parts(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

TEST(Plots, FollowTheNumberOfParametersThatVary) {
  std::vector<StudyRow> one, two, many;
  EXPECT_EQ(plots_of(grid({1, 2, 3}, {5}, one), one)[0].svgs.size(), 1u);
  const auto both = plots_of(grid({1, 2, 3}, {5, 6}, two), two);
  ASSERT_EQ(both[0].svgs.size(), 2u);  // a map, and curves
  EXPECT_EQ(count_parts(both[0].svgs[0], "linearGradient id="), 1u);
  EXPECT_NE(both[0].svgs[1].find("friction = 6"), std::string::npos);
  // More curves than colours: the map alone.
  EXPECT_EQ(plots_of(grid({1, 2, 3}, {1, 2, 3, 4, 5, 6, 7, 8}, many), many)[0].svgs.size(), 1u);
}

TEST(Plots, OfASampleAreAPictureAParameter) {
  std::vector<StudyRow> rows;
  Study study;
  study.parameters = {"a", "b", "c"};
  study.columns = {{"way", "", "way", false}};
  for (int i = 0; i < 20; ++i) {
    study.runs.push_back({std::to_string(i), {number("a", i), number("b", 7 * i % 20), number("c", 3 * i % 20)}});
    StudyRow row;
    row.outcome = Outcome{};
    row.collected = {{Cell{"1", 1. * i}}, {""}, ""};
    rows.push_back(row);
  }
  EXPECT_EQ(plots_of(study, rows)[0].svgs.size(), 3u);
}

TEST(Plots, TakeTheMeanOverSeeds) {
  std::vector<StudyRow> rows;
  Study study;
  study.parameters = {"a", "seed"};
  study.seed_parameter = "seed";
  study.columns = {{"way", "", "way", false}};
  for (const double a : {1, 2})
    for (const double seed : {1, 2}) {
      study.runs.push_back({"", {number("a", a), number("seed", seed)}});
      StudyRow row;
      row.outcome = Outcome{};
      row.collected = {{Cell{"", a * seed}}, {""}, ""};
      rows.push_back(row);
    }
  const auto plots = plots_of(study, rows);
  ASSERT_EQ(plots[0].svgs.size(), 1u);
  EXPECT_NE(plots[0].svgs[0].find("mean over the seeds"), std::string::npos);
  EXPECT_EQ(count_parts(plots[0].svgs[0], "<circle"), 2 + 4 + 2u);  // means, runs, the legend
}

TEST(ValueMap, HasACellAValueAndSaysIt) {
  ValueMap map{.x_label = "x", .y_label = "y", .label = "v", .unit = "m"};
  for (const double x : {1, 2, 4})
    for (const double y : {10, 20}) {
      map.at.emplace_back(x, y);
      map.values.push_back(x == 4 && y == 20 ? NAN : x * y);
    }
  const std::string svg = draw_map(map);
  EXPECT_EQ(count_parts(svg, "<rect"), 1 + 5 + 1 + 1u);  // paper, cells, frame, bar
  EXPECT_NE(svg.find(">40<"), std::string::npos);
  map.cells = false;
  EXPECT_EQ(count_parts(draw_map(map), "<circle"), 5u);
}

TEST(ResultsPage, IsOneFileWithNamesOfItsOwn) {
  std::vector<StudyRow> rows;
  Study study = grid({1, 2, 3}, {5, 6}, rows);
  study.columns.push_back({"more", "m", "more", false});
  for (StudyRow& row : rows) {
    row.collected.cells.push_back(row.collected.cells[0]);
    row.collected.units.emplace_back();
  }
  const std::string page = results_page(study, rows);
  EXPECT_NE(page.find("<title>a &amp; b</title>"), std::string::npos);
  std::set<std::string> names;
  std::size_t found = 0;
  for (std::size_t at = 0; (at = page.find(" id=\"", at)) != std::string::npos; ++at, ++found)
    names.insert(page.substr(at + 5, page.find('"', at + 5) - at - 5));
  EXPECT_EQ(found, 2u);
  EXPECT_EQ(names.size(), found);
  for (const std::string& name : names) EXPECT_EQ(count_parts(page, "url(#" + name + ")"), 1u);
}

}  // namespace
}  // namespace talus
