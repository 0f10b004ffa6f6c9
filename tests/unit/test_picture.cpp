#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hand_model.h"
#include "output/axis.h"
#include "output/colour_bar.h"
#include "output/output.h"
#include "output/picture_marks.h"
#include "output/plot.h"
#include "output/text.h"

namespace talus {
namespace {

using test::two_squares;

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

bool has(const std::string& text, const std::string& part) {
  return count(text, part) > 0;
}

std::string picture(const Model& model, const PictureOptions& options = {}) {
  return draw_picture({model, nullptr}, options);
}

std::string refusal(const Model& model, const std::string& field) {
  try {
    picture(model, {.field = field});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Text, NumbersReadBackAndDoNotShowMinusZero) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(1e22), "1e+22");
  EXPECT_EQ(std::stod(shortest(1.0 / 3)), 1.0 / 3);
  EXPECT_EQ(fixed(-0.001, 2), "0.00");
  EXPECT_EQ(fixed(-0.25, 1), "-0.2");
}

TEST(Text, EscapesForXmlAndCsv) {
  EXPECT_EQ(escape_xml("a<b & \"c\""), "a&lt;b &amp; &quot;c&quot;");
  EXPECT_EQ(escape_xml("\xff"), "\xEF\xBF\xBD");
  EXPECT_EQ(escape_xml("σ₁"), "σ₁");
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell("a,\"b\""), "\"a,\"\"b\"\"\"");
}

TEST(Axis, TicksAreRoundAndInside) {
  EXPECT_EQ(linear_ticks({0, 8}, 8), (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(linear_ticks({-0.9, 2.1}, 3), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(linear_ticks({0, 1}, 5, true), (std::vector<double>{0, 1}));
  EXPECT_EQ(linear_ticks({3, 3}, 5), (std::vector<double>{3}));
  EXPECT_EQ(log_ticks({0.5, 2000}), (std::vector<double>{1, 10, 100, 1000}));
  EXPECT_EQ(tick_text(-1.3, -1.3), "−1.3");
  EXPECT_EQ(log_ticks({1, 12}), (std::vector<double>{1, 2, 5, 10}));
  EXPECT_EQ(tick_text(-0.25, 0.25), "−0.25");
  EXPECT_EQ(tick_text(2, 0.5), "2.0");
  EXPECT_EQ(tick_text(20, 5), "20");
}

TEST(Axis, UnitsTakePrefixesWhereTheyMay) {
  EXPECT_EQ(shown_unit("Pa", 2.5e5).name, "kPa");
  EXPECT_EQ(shown_unit("Pa", 2.5e5).factor, 1e3);
  EXPECT_EQ(shown_unit("Pa", 1e6).name, "MPa");
  EXPECT_EQ(shown_unit("m", 3e-4).name, "µm");
  EXPECT_EQ(shown_unit("s", 7200).name, "s");
  EXPECT_EQ(shown_unit("m2", 12).name, "m²");
  EXPECT_EQ(shown_unit("m2", 3e-5).name, "10⁻⁶ m²");  // not "µm²", which is 1e-12
  EXPECT_EQ(shown_unit("kg/m3", 2500).name, "kg/m³");
  EXPECT_EQ(shown_unit("", 2e-4).factor, 1e-6);
  EXPECT_EQ(label("v", shown_unit("m/s", 0.05)), "v / (mm/s)");
  EXPECT_EQ(quantity(-5000, "N/m"), "−5 kN/m");
}

TEST(ColourScale, BothSignsAreCentredAtZero) {
  const ColourScale scale = colour_scale({-1, 0, 4}, false);
  EXPECT_EQ(scale.map, ColourMap::diverging);
  EXPECT_DOUBLE_EQ(scale.place(0), 0.5);
  EXPECT_DOUBLE_EQ(scale.place(4), 1);
  EXPECT_DOUBLE_EQ(scale.place(-1), 0.375);  // the same step of colour for the same difference on both sides
  EXPECT_DOUBLE_EQ(colour_scale({-4, 0, 1}, false).place(1), 0.625);
  EXPECT_EQ(colour_scale({1, 2, 3}, false).map, ColourMap::sequential);
  EXPECT_EQ(colour_scale({-0.01, 2, 3}, false).map, ColourMap::sequential);  // a trace only
}

TEST(ColourScale, OutliersAreCutAndSaid) {
  std::vector<double> values;
  for (int k = 0; k <= 100; ++k) values.push_back(1 + k / 100.0);
  EXPECT_FALSE(colour_scale(values, false).above);
  values.back() = 1e6;
  const ColourScale scale = colour_scale(values, false);
  EXPECT_TRUE(scale.above);
  EXPECT_FALSE(scale.below);
  EXPECT_NEAR(scale.range.high, 2, 0.1);
  EXPECT_EQ(scale.range.low, 1);
  EXPECT_EQ(scale.level(1e6), ColourScale::levels - 1);
}

TEST(ColourScale, OneValueAndNonFiniteOnes) {
  EXPECT_TRUE(colour_scale({5, 5, 5}, false).flat);
  EXPECT_TRUE(colour_scale({NAN, NAN}, false).flat);
  EXPECT_TRUE(colour_scale({1e-26, -1e-27, 3e-26}, false, 1e-20).flat);
  EXPECT_FALSE(colour_scale({1e-26, -1e-27, 3e-20}, false, 1e-20).flat);
  const ColourScale scale = colour_scale({1, NAN, 9, INFINITY}, false);
  EXPECT_EQ(scale.range.high, 9);
}

TEST(ColourMap, EndsAndMiddle) {
  EXPECT_EQ(colour(ColourMap::sequential, 0), "#440154");
  EXPECT_EQ(colour(ColourMap::sequential, 1), "#fde725");
  EXPECT_EQ(colour(ColourMap::diverging, 0.5), "#f3f3f3");
  EXPECT_EQ(colour(ColourMap::sequential, 7), "#fde725");
  EXPECT_EQ(colour(ColourMap::sequential, 0.5 / 16), "#460d5f");  // half-way between the first two
}

TEST(Picture, OneValueIsSaidInItsOwnDigits) {
  Model model = two_squares();
  const auto says = [&](double first, double second, const std::string& text) {
    model.scene.output.fields = {{"mine", [=](int block) { return block == 0 ? first : second; }}};
    return has(picture(model, {.field = "mine"}), ">" + text + "</text>");
  };
  EXPECT_TRUE(says(0.3, 0.3, "0.3"));
  EXPECT_TRUE(says(950, 950, "950"));
  EXPECT_TRUE(says(-12.5, -12.5 * (1 + 1e-7), "−12.5"));  // not a scale of equal numbers
  EXPECT_TRUE(says(7, 7, "7"));
  model.shapes[0].initial_stress = {950, 0, 0};  // of the only block that is not held
  EXPECT_TRUE(has(picture(model, {.field = "sxx"}), ">950</text>"));
  EXPECT_TRUE(has(picture(model, {.field = "order"}), ">0<"));
}

TEST(Picture, BlocksAreNumberedAsInLua) {
  const std::string svg = picture(two_squares(), {.field = "id"});
  EXPECT_TRUE(has(svg, ">1</text>"));
  EXPECT_TRUE(has(svg, ">2</text>"));
  EXPECT_FALSE(has(svg, ">0</text>"));
}

TEST(Picture, RoundingErrorsAreNoPicture) {
  Model model = two_squares();
  model.shapes[1].dofs = 6;
  model.shapes[0].initial_stress = {1e-26, 0, 0};
  const std::string svg = picture(model);
  EXPECT_TRUE(has(svg, ">0</text>"));
  EXPECT_TRUE(has(svg, " Pa</text>"));
  EXPECT_EQ(count(svg, "<path fill=\"" + colour(ColourMap::diverging, 0.5 + 0.5 / ColourScale::levels) + "\""), 1);
}

TEST(Picture, HeldBlocksAreGreyAndTheOthersColoured) {
  Model model = two_squares();
  model.shapes[0].initial_stress = {2e6, 0, 0};
  const std::string svg = picture(model);
  EXPECT_EQ(count(svg, "fill=\"#b4b4b4\""), 1);
  EXPECT_TRUE(has(svg, "<path fill=\"" + colour(ColourMap::sequential, 0.5 + 0.5 / ColourScale::levels) + "\""));
  EXPECT_TRUE(has(svg, "σ"));
  EXPECT_TRUE(has(svg, "MPa"));
  EXPECT_TRUE(has(svg, "most tensile"));
  EXPECT_TRUE(has(svg, "x / m"));
  EXPECT_TRUE(has(svg, ">101.0<"));  // user coordinates
  EXPECT_EQ(svg.rfind("</svg>\n"), svg.size() - 7);
}

TEST(Picture, AspectIsEqual) {
  const std::string svg = picture(two_squares(), {.field = "id"});
  // Corners of block 0, in tenths of a px: right, up, left by the same amount.
  const auto at = svg.find("fill=\"" + colour(ColourMap::sequential, ColourScale::place_of(0)));
  ASSERT_NE(at, std::string::npos);
  const auto path = svg.substr(svg.find("d=\"M", at) + 4);
  long x = 0, y = 0, dx = 0, dy = 0, dx2 = 0, dy2 = 0;
  ASSERT_EQ(std::sscanf(path.c_str(), "%ld %ldl%ld %ld%ld %ld", &x, &y, &dx, &dy, &dx2, &dy2), 6);
  EXPECT_GT(dx, 1000);
  EXPECT_EQ(dy, 0);
  EXPECT_EQ(dx2, 0);
  EXPECT_NEAR(-dy2, dx, 1);
}

TEST(Picture, MagnificationIsSaidAndApplied) {
  Model model = two_squares();
  model.blocks[0].centroid += Vec2(-0.01, 0);
  model.place_vertices();
  EXPECT_FALSE(has(picture(model), "displacements ×"));
  const std::string svg = picture(model, {.scale = 100});
  EXPECT_TRUE(has(svg, "displacements × 100"));
  EXPECT_TRUE(has(svg, ">99.0<")) << "block 0 is drawn from x = 99";
}

TEST(Picture, MarksFixitiesLoadsAndFailedJoints) {
  Model model = two_squares();
  model.joints[0].state = JointState::failed;
  model.joints[0].mode = FailureMode::tension;
  model.scene.fixities.resize(1);
  model.point_fixities = {{.fixity = 0, .block = 0, .in_block = {-0.5, -0.5}}};
  PointLoad load;
  load.force = {History(0), History(-5000)};
  model.scene.point_loads = {load};
  // Shared by two blocks: still one arrow.
  model.point_forces = {{.load = 0, .block = 0, .in_block = {0.5, 0.5}, .share = 0.5},
                        {.load = 0, .block = 1, .in_block = {-0.5, 0.5}, .share = 0.5}};
  const std::string svg = picture(model);
  EXPECT_EQ(count(svg, "5 kN/m"), 1);
  EXPECT_EQ(count(svg, "fill=\"#111\""), 1);
  EXPECT_TRUE(has(svg, "1 failed in tension (black)"));
  model.scene.fixities[0].held = {true, false};
  model.scene.point_loads[0].force = {History(0), History(0)};
  const std::string other = picture(model);
  EXPECT_EQ(count(other, "stroke=\"#111\" "), count(svg, "stroke=\"#111\" "));
  EXPECT_EQ(count(other, "fill=\"#111\""), 0);  // one direction only: hollow
  EXPECT_FALSE(has(other, "kN"));               // no load, no arrow
}

TEST(Picture, ShowsWhereTheGasPresses) {
  Model model = test::two_squares();
  EXPECT_FALSE(has(draw_picture({model, nullptr}, {}), "gas"));
  model.gas_faces = {{0, 0, {Vec2(-0.5, 0.5), Vec2(0.5, 0.5)}}};
  const std::string svg = draw_picture({model, nullptr}, {});
  EXPECT_TRUE(has(svg, "faces under gas (orange)"));
  EXPECT_TRUE(has(svg, gas_colour));
}

TEST(Picture, FlyingChipDoesNotShrinkTheRest) {
  Model model = two_squares();
  model.blocks[0].centroid += Vec2(1e5, 0);
  model.place_vertices();
  EXPECT_TRUE(has(picture(model), "x / m"));
  model.blocks[0].centroid = Vec2(NAN, 0);
  model.place_vertices();
  EXPECT_FALSE(has(picture(model), "nan"));
}

TEST(Picture, LoadOnWhatHasFlownOffTakesNoRoom) {  // far enough, it left the frame a negative height
  Model model = two_squares();
  PointLoad load;
  load.force = {History(0), History(-5000)};
  model.scene.point_loads = {load};
  model.point_forces = {{.load = 0, .block = 0, .in_block = {0.5, 0.5}, .share = 1}};
  EXPECT_TRUE(has(picture(model), "kN"));
  model.blocks[0].centroid += Vec2(1e5, 1e5);
  model.place_vertices();
  const std::string svg = picture(model);
  EXPECT_FALSE(has(svg, "kN"));
  EXPECT_FALSE(has(svg, "height=\"-"));
}

TEST(Picture, UnknownFieldIsAnsweredWithTheNearest) {
  const Model model = two_squares();
  EXPECT_TRUE(has(refusal(model, "s1_smoth"), "did you mean \"s1_smooth\"")) << refusal(model, "s1_smoth");
  EXPECT_TRUE(has(refusal(model, "s1_smoth"), "output.picture: expected"));
  EXPECT_TRUE(has(refusal(model, "stress"), "output.picture: expected"));  // three numbers are no colour
  EXPECT_EQ(refusal(model, "velocity"), "");                               // a vector by its length
}

TEST(Picture, BlocksShowTheLargestOfTheirJoints) {
  Model model = two_squares();
  model.joints[0].utilisation = 0.75;
  const std::string svg = picture(model, {.field = "utilisation"});
  EXPECT_TRUE(has(svg, "joints: part of its strength that is used"));
  EXPECT_TRUE(has(svg, "0.75"));
  model.joints[0].state = JointState::failed;  // with what it had when it failed
  EXPECT_FALSE(has(picture(model, {.field = "utilisation"}), "0.75"));
  EXPECT_EQ(refusal(model, "opening"), "");
  EXPECT_TRUE(has(refusal(model, "utilization"), "did you mean \"utilisation\""));
}

TEST(Picture, UserArray) {
  Model model = two_squares();
  model.scene.output.fields = {{"my_heat", [](int block) { return block == 0 ? 10.0 : 20.0; }}};
  const std::string svg = picture(model, {.field = "my_heat"});
  EXPECT_TRUE(has(svg, "my_heat"));
  EXPECT_TRUE(has(svg, "fill=\"" + colour(ColourMap::sequential, 1 - 0.5 / ColourScale::levels) + "\""));
}

TEST(Plot, CurvesLegendAndUnits) {
  Plot plot = {.title = "Energy", .y_label = "energy", .y_unit = "J/m"};
  plot.series = {{.name = "kinetic", .x = {0, 1, 2}, .y = {0, 4000, 1000}},
                 {.name = "strain & more", .x = {0, 1, 2}, .y = {5000, NAN, 4000}, .markers = true}};
  const std::string svg = draw_plot(plot);
  EXPECT_TRUE(has(svg, "energy / (kJ/m)"));
  EXPECT_TRUE(has(svg, ">strain &amp; more<"));
  EXPECT_TRUE(has(svg, "t / s"));
  EXPECT_EQ(count(svg, "stroke=\"#0072b2\""), 2);  // legend and curve
  EXPECT_EQ(count(svg, "stroke=\"#d55e00\""), 1);  // two lone points make no curve
  EXPECT_EQ(count(svg, "<circle"), 3);             // legend and two finite points
  EXPECT_FALSE(has(svg, "nan"));
}

// A section ten times as wide as high comes out flat, with one scale for both axes; points without a line have none.
TEST(Plot, EqualScalesMakeTheFrameAsFlatAsTheValues) {
  const auto svg_of = [](bool equal) {
    return draw_plot({.series = {{.x = {0, 10}, .y = {0, 1}, .markers = true, .line = false}}, .equal = equal});
  };
  EXPECT_TRUE(has(svg_of(false), "height=\"500\""));
  EXPECT_FALSE(has(svg_of(true), "height=\"500\""));
  EXPECT_FALSE(has(svg_of(true), "stroke-linejoin=\"round\""));
}

TEST(Plot, LogarithmicAxesLeaveOutWhatIsNotPositive) {
  Plot plot = {.x_label = "blocks", .x_unit = "", .y_label = "error", .log_x = true, .log_y = true};
  plot.series = {{.name = "", .x = {10, 100, 1000}, .y = {1e-1, 1e-6, 0}, .markers = true}};
  const std::string svg = draw_plot(plot);
  EXPECT_EQ(count(svg, "<circle"), 2);
  EXPECT_TRUE(has(svg, "10⁻³"));
  EXPECT_FALSE(has(draw_plot({}), "nan"));
}

}  // namespace
}  // namespace talus
