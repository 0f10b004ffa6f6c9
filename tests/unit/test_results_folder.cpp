// What a run wrote is read back as it was, and drawn.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "hand_model.h"
#include "output/output.h"
#include "output/picture_of_results.h"
#include "output/pvd.h"
#include "output/vtk_writer.h"
#include "scene/error.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

class Results : public testing::Test {
 protected:
  void SetUp() override {
    dir_ = (fs::temp_directory_path() / ("talus_test_results_" + std::to_string(getpid()))).string();
    fs::remove_all(dir_);
    fs::create_directories(dir_);
    PvdSeries blocks(dir_, "blocks");
    for (const int frame : {0, 1}) {
      Model model = frame == 0 ? test::two_squares() : test::moved_squares();
      model.time = 0.5 * frame;
      const std::string name = "blocks_0000" + std::to_string(frame) + ".vtp";
      write_blocks_vtp(dir_ + "/" + name, {model, nullptr}, {{"heat", {7.5 + frame, -2}}});
      blocks.add(model.time, name);
    }
  }
  void TearDown() override { fs::remove_all(dir_); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(dir_ + "/" + name, std::ios::binary) << content;
    return dir_ + "/" + name;
  }
  static std::string refusal(const std::function<void()>& act) {
    try {
      act();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
  std::string dir_;
};

TEST_F(Results, AFrameReadsBackAsItWasWritten) {
  const Model model = test::moved_squares();
  const ResultFrame frame = ResultsFolder(dir_).blocks(1);
  EXPECT_EQ(frame.time, 0.5);
  ASSERT_EQ(frame.size(), 2u);
  EXPECT_EQ(frame.begin, (std::vector<int>{0, 4, 8}));
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_EQ(frame.points[v], Vec2(model.vertex[v] + model.origin));
    EXPECT_NEAR(frame.of_point("displacement")->at(v, 0),
                model.vertex[v].x() - model.shapes[v / 4].reference_centroid.x() - model.reference_vertex[v].x(),
                1e-15);
  }
  EXPECT_TRUE(frame.cell("region")->whole);
  EXPECT_FALSE(frame.cell("sxx")->whole);
  EXPECT_EQ(frame.cell("velocity")->components, 3);
  EXPECT_EQ(frame.cell("heat")->at(0), 8.5);
  EXPECT_EQ(frame.names.at("region_names").size(), model.scene.regions.size());
}

TEST_F(Results, TheNearestFrameIsFound) {
  const ResultsFolder run(dir_);
  EXPECT_EQ(run.nearest(-1), 0u);
  EXPECT_EQ(run.nearest(0.26), 1u);
  EXPECT_EQ(run.nearest(9), 1u);
  EXPECT_FALSE(run.has("cracks"));
}

TEST_F(Results, PicturesAreColouredByWhatIsThere) {
  const ResultsFolder run(dir_);
  const std::string svg = draw_result(run, 1, {.field = "heat", .range = Span{-4, 10}});
  EXPECT_NE(svg.find("t = 500 ms"), std::string::npos);
  EXPECT_NE(svg.find(">heat<"), std::string::npos);
  EXPECT_NE(svg.find(">10<"), std::string::npos);  // the bar's upper end
  EXPECT_NE(draw_result(run, 1, {.field = "region"}).find("2 regions"), std::string::npos);
  EXPECT_NE(draw_result(run, 1, {.field = "uy", .vectors = "velocity"}).find("longest arrow"), std::string::npos);
  EXPECT_NE(refusal([&] { draw_result(run, 1, {.field = "heet"}); }).find("did you mean \"heat\"?"), std::string::npos);
  EXPECT_NE(refusal([&] { draw_result(run, 1, {.vectors = "speed"}); }).find("an array of vectors"), std::string::npos);
}

TEST_F(Results, OneRangeServesASeries) {
  const Span range = range_of(ResultsFolder(dir_), {0, 1}, {.field = "heat"});
  EXPECT_EQ(range.low, -2);
  EXPECT_EQ(range.high, 8.5);
}

TEST_F(Results, DisplacementsAreMagnifiedFromTheStart) {
  // A picture at scale 3 has the corners where the start and three times the way put them: the frame's axes tell.
  const ResultsFolder run(dir_);
  EXPECT_NE(draw_result(run, 1, {.field = "uy"}), draw_result(run, 1, {.field = "uy", .scale = 3}));
  EXPECT_NE(draw_result(run, 1, {.field = "uy", .scale = 3}).find("displacements × 3"), std::string::npos);
}

TEST_F(Results, FilesThatAreCutShortAreRefusedByName) {
  const std::string path = dir_ + "/blocks_00001.vtp";
  const auto whole = fs::file_size(path);
  for (const auto kept : {std::uintmax_t(0), whole / 10, whole / 2, whole - 40}) {
    fs::resize_file(path, kept);
    EXPECT_NE(refusal([&] { ResultsFolder(dir_).blocks(1); }).find("cannot read " + path), std::string::npos) << kept;
  }
  EXPECT_NE(refusal([&] { ResultsFolder("/nowhere/at/all"); }).find("expected a run's results folder"),
            std::string::npos);
}

TEST_F(Results, HistoryHasNamesUnitsAndValues) {
  const auto columns = read_history(write("history.csv", "time [s],\"a, b.uy [m]\",count\n0,1e-3,2\n0.5,-4,nan\n0.7,"));
  ASSERT_EQ(columns.size(), 3u);
  EXPECT_EQ(columns[1].name, "a, b.uy");
  EXPECT_EQ(columns[1].unit, "m");
  EXPECT_EQ(columns[1].values, (std::vector<double>{1e-3, -4}));
  EXPECT_EQ(columns[2].unit, "");
  EXPECT_TRUE(std::isnan(columns[2].values[1]));
  EXPECT_NE(refusal([&] { read_history(write("bad.csv", "a,b\n1\n2,3\n")); }).find("bad.csv:2: expected 2 columns"),
            std::string::npos);
}

TEST_F(Results, HistoriesOfOneUnitAreDrawnTogether) {
  write("history.csv", "time [s],a_b [m],c [m],p [Pa]\n0,0,0,0\n1,2,3,4\n");
  const ResultsFolder run(dir_);
  EXPECT_NE(draw_history(run, {"a_b", "c"}).find("value / m"), std::string::npos);
  EXPECT_NE(draw_history(run, {"a_b [m]"}).find("a b / m"), std::string::npos);
  EXPECT_NE(refusal([&] { draw_history(run, {"c", "p"}); }).find("columns of one unit (m)"), std::string::npos);
  EXPECT_NE(refusal([&] { draw_history(run, {"pp"}); }).find("did you mean \"p\"?"), std::string::npos);
}

}  // namespace
}  // namespace talus
