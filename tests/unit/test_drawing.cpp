#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/polygon.h"
#include "input/drawing.h"

namespace talus {
namespace {

std::string problem_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const FileError& error) {
    return error.what();
  }
  return "none";
}
std::string csv_problem(const std::string& text) {
  return problem_of([&] { read_csv(text, "f.csv"); });
}
std::string dxf_problem(const std::string& text) {
  return problem_of([&] { read_dxf(text, "f.dxf", 0.01); });
}

// Group codes and values, each on a line of its own: "0 LINE 8 a" is LINE on layer a.
std::string dxf(const std::string& entities, const std::string& header = "") {
  std::string text = "0 SECTION 2 HEADER " + header + "0 ENDSEC 0 SECTION 2 ENTITIES " + entities + "0 ENDSEC 0 EOF ";
  std::replace(text.begin(), text.end(), ' ', '\n');
  return text;
}

TEST(Csv, PointsARow) {
  const Drawing d = read_csv(
      "\xef\xbb\xbfTrace, X ,Y,remark\r\n# survey of "
      "May\r\nF1,0,0,a\r\nF1,+1.5e0,2,\r\n\r\nF2,3,-4,\r\nF2,3,5,\r\n",
      "f.csv");
  ASSERT_EQ(d.lines.size(), 2u);
  EXPECT_EQ(d.lines[0].layer, "F1");
  EXPECT_EQ(d.lines[0].points, (Polyline{{0, 0}, {1.5, 2}}));
  EXPECT_EQ(d.lines[1].points, (Polyline{{3, -4}, {3, 5}}));
  EXPECT_EQ(d.lines[1].line, 6);
}

TEST(Csv, SegmentsARow) {
  const Drawing d = read_csv("x1;y1;x2;y2\n0;0;1;2\n\"5\";6;7;8", "f.csv");
  ASSERT_EQ(d.lines.size(), 2u);
  EXPECT_EQ(d.lines[1].points, (Polyline{{5, 6}, {7, 8}}));
}

TEST(Csv, SaysWhatIsWrong) {
  EXPECT_EQ(csv_problem(""), "f.csv: expected a header with the columns trace,x,y or x1,y1,x2,y2, got an empty file");
  EXPECT_EQ(csv_problem("0,1,2\n"),
            "f.csv:1: expected a header with the columns trace,x,y or x1,y1,x2,y2, got \"0,1,2\"");
  EXPECT_EQ(csv_problem("trace,x,y\n"), "f.csv:1: expected rows with points below the header, got none");
  EXPECT_EQ(csv_problem("trace,x,y\na,0,zero\n"),
            "f.csv:2: expected a finite number for y, with a decimal point, got \"zero\"");
  for (const char* number : {"nan", "inf", "1e999", "0x10", "", "1 2"})
    EXPECT_NE(csv_problem("trace,x,y\na,0," + std::string(number) + "\n").find("f.csv:2: expected a finite number"),
              std::string::npos)
        << number;
  EXPECT_EQ(csv_problem("trace;x;y\na;0,5;1\n"),
            "f.csv:2: expected a finite number for x, with a decimal point, got \"0,5\"");
  EXPECT_EQ(csv_problem("trace,x,y\na,0,5,1,0\n"),
            "f.csv:2: expected 3 columns as in the header, and decimal points, not commas, got 5");
  EXPECT_EQ(csv_problem("trace,x,y\na,0,0\nb,1,1\nb,2,2\n"),
            "f.csv:2: expected two or more different points of trace \"a\", got one");
  EXPECT_EQ(csv_problem("trace,x,y\na,0,0\na,1,0\nb,1,1\nb,2,2\na,2,0\n"),
            "f.csv:6: expected the rows of a trace to follow each other, got trace \"a\" again");
  EXPECT_EQ(csv_problem(std::string("trace,x,y\na,0,\0\n", 16)), "f.csv:2: expected text, got a binary file");
}

TEST(Csv, TooManyPointsAreRefused) {
  std::string text = "x1,y1,x2,y2\n";
  for (int i = 0; i < 500001; ++i) text += "0,0,1,1\n";
  EXPECT_EQ(csv_problem(text), "f.csv:500002: expected at most 1000000 points, got more");
}

TEST(Dxf, LinesAndLightPolylines) {
  const Drawing d = read_dxf(dxf("0 LINE 8 faults 10 1 20 2 30 0 11 3 21 4 "
                                 "0 LWPOLYLINE 8 slope 90 3 70 1 10 0 20 0 10 2 20 0 10 0 20 1 0 TEXT 1 hello "),
                             "f.dxf", 0.01);
  ASSERT_EQ(d.lines.size(), 2u);
  EXPECT_EQ(d.lines[0].layer, "faults");
  EXPECT_EQ(d.lines[0].points, (Polyline{{1, 2}, {3, 4}}));
  EXPECT_FALSE(d.lines[0].closed);
  EXPECT_TRUE(d.lines[1].closed);
  EXPECT_EQ(d.lines[1].points, (Polyline{{0, 0}, {2, 0}, {0, 1}}));
  EXPECT_EQ(d.skipped.at("TEXT"), 1);
  EXPECT_EQ(d.unit, 1);
}

// Chords whose corners lie on the circle and whose middle is off it by 0.01 of the radius at most.
void expect_on_circle(const Polyline& points, const Vec2& centre, double radius) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    EXPECT_NEAR((points[i] - centre).norm(), radius, 1e-9 * radius);
    EXPECT_GT(((points[i] + points[i + 1]) / 2 - centre).norm(), 0.99 * radius);
  }
}

TEST(Dxf, ArcsBecomeChords) {
  const Drawing d = read_dxf(dxf("0 CIRCLE 8 a 10 5 20 6 40 2 0 ARC 8 a 10 0 20 0 40 3 50 300 51 30 "
                                 "0 LWPOLYLINE 8 a 70 0 10 0 20 0 42 1 10 2 20 0 10 4 20 0 "),
                             "f.dxf", 0.01);
  ASSERT_EQ(d.lines.size(), 3u);
  EXPECT_TRUE(d.lines[0].closed);
  EXPECT_EQ(d.lines[0].points.size(), 23u);
  expect_on_circle(d.lines[0].points, {5, 6}, 2);
  expect_on_circle(d.lines[1].points, {0, 0}, 3);
  EXPECT_NEAR(d.lines[1].points.front().x(), 1.5, 1e-9);
  EXPECT_NEAR(d.lines[1].points.back().y(), 1.5, 1e-9);
  Polyline bulged = d.lines[2].points;  // half a circle below, counter-clockwise from (0, 0) to (2, 0)
  EXPECT_EQ(bulged.back(), Vec2(4, 0));
  bulged.pop_back();
  expect_on_circle(bulged, {1, 0}, 1);
  EXPECT_LT(bulged[bulged.size() / 2].y(), -0.9);
}

TEST(Dxf, OldPolylinesAndSidesSeenFromBelow) {
  const Drawing d =
      read_dxf(dxf("0 POLYLINE 8 a 70 1 0 VERTEX 10 0 20 0 0 VERTEX 10 1 20 0 0 VERTEX 10 0 20 1 0 SEQEND "
                   "0 ARC 8 b 10 1 20 0 40 1 50 0 51 90 210 0 220 0 230 -1 "
                   "0 CIRCLE 8 b 10 1 20 0 40 1 210 1 220 0 230 0 "),
               "f.dxf", 0.01);
  ASSERT_EQ(d.lines.size(), 2u);
  EXPECT_EQ(d.lines[0].points, (Polyline{{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_NEAR(d.lines[1].points.front().x(), -2, 1e-12);
  EXPECT_EQ(d.skipped.at("CIRCLE in another plane"), 1);
}

TEST(Dxf, ReadsTheUnit) {
  const Drawing d = read_dxf(dxf("0 LINE 10 1 20 2 11 3 21 4 ", "9 $INSUNITS 70 4 "), "f.dxf", 0.01);
  EXPECT_EQ(d.unit, 1e-3);
  EXPECT_EQ(d.unit_name, "mm");
}

TEST(Dxf, SaysWhatIsWrong) {
  EXPECT_EQ(dxf_problem(""), "f.dxf: expected an ASCII DXF, got an empty file");
  EXPECT_EQ(dxf_problem("AutoCAD Binary DXF\r\n\x1a"),
            "f.dxf: expected an ASCII DXF, got a binary DXF: save it as ASCII");
  EXPECT_EQ(dxf_problem("AC1027"), "f.dxf: expected an ASCII DXF, got a DWG: save it as DXF");
  EXPECT_EQ(dxf_problem("hello\nworld\n"), "f.dxf:1: expected a group code (an integer), got \"hello\"");
  const std::string line = "0 LINE 8 a 10 1 20 2 11 3 21 4 ";
  EXPECT_EQ(dxf_problem(dxf("0 LINE 8 a 10 1 20 2 11 3 ")), "f.dxf:12: expected LINE with group code 21, got none");
  EXPECT_EQ(dxf_problem(dxf("0 LINE 8 a 10 1 20 2 11 nan 21 4 ")),
            "f.dxf:20: expected a finite number after group code 11, got \"nan\"");
  EXPECT_EQ(dxf_problem(dxf("0 CIRCLE 10 1 20 2 40 -3 ")),
            "f.dxf:12: expected CIRCLE with a radius > 0, got -3.000000");
  EXPECT_EQ(dxf_problem(dxf("0 LINE 10 1 20 2 11 1 21 2 ")),
            "f.dxf:12: expected LINE of two or more different points, got one point");
  EXPECT_EQ(dxf_problem(dxf(line, "9 $INSUNITS 70 99 ")),
            "f.dxf:8: expected $INSUNITS of a length up to hectometres, got \"99\"");
  EXPECT_EQ(dxf_problem(dxf("0 POLYLINE 8 a 0 LINE 10 0 20 0 11 1 21 1 ")),
            "f.dxf:16: expected VERTEX or SEQEND after POLYLINE, got \"LINE\"");
  EXPECT_EQ(dxf_problem("0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n"),
            "f.dxf:8: expected a section ENTITIES, got none");
}

// Wherever a file ends, or whatever line is missing: one message or a drawing, no crash and no hang.
TEST(Dxf, TruncatedAnywhere) {
  const std::string whole =
      dxf("0 LINE 8 a 10 1 20 2 11 3 21 4 0 LWPOLYLINE 70 1 10 0 20 0 42 1 10 2 20 0 10 0 20 1 "
          "0 POLYLINE 70 1 0 VERTEX 10 0 20 0 0 VERTEX 10 1 20 0 0 SEQEND ",
          "9 $INSUNITS 70 4 ");
  for (std::size_t length = 0; length + 5 < whole.size(); ++length)
    EXPECT_NE(dxf_problem(whole.substr(0, length)), "none") << length;
  for (std::size_t at = 0; at < whole.size(); ++at) dxf_problem(whole.substr(0, at) + whole.substr(at + 1));
}

}  // namespace
}  // namespace talus
