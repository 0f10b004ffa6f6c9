#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/joint_set.h"
#include "geometry/polygon.h"
#include "scene/error.h"

namespace talus {
namespace {

constexpr double degree = std::numbers::pi / 180;
const Vec2 low(0, 0), high(20, 10);

JointSet joints(double dip, double spacing) {
  JointSet set;
  set.dip = dip;
  set.spacing = spacing;
  return set;
}

JointSet broken_joints(double spacing, double persistence, double trace_length) {
  JointSet set = joints(0, spacing);
  set.persistence = persistence;
  set.trace_length = trace_length;
  return set;
}

JointSet joints_through(double spacing, const Vec2& through, double scatter = 0, unsigned seed = 1) {
  JointSet set = joints(0, spacing);
  set.through = through;
  set.spacing_scatter = scatter;
  set.seed = seed;
  return set;
}

double angle_of(const Polyline& line) {
  const Vec2 along = line[1] - line[0];
  return std::atan2(along.y(), along.x());
}

// Of the line's middle, along the normal of the set.
double offset_of(const Polyline& line, double dip) {
  const Vec2 normal(-std::sin(dip), std::cos(dip));
  return normal.dot((line[0] + line[1]) / 2);
}

double total_length(const std::vector<Polyline>& lines) {
  double sum = 0;
  for (const Polyline& line : lines) sum += (line[1] - line[0]).norm();
  return sum;
}

bool on_box(const Vec2& p) {
  return std::abs(p.x() - low.x()) < 1e-9 || std::abs(p.x() - high.x()) < 1e-9 || std::abs(p.y() - low.y()) < 1e-9 ||
         std::abs(p.y() - high.y()) < 1e-9;
}

TEST(JointSet, DipSpacingAndThrough) {
  for (double dip : {0.0, 30 * degree, 90 * degree, 135 * degree, -20 * degree}) {
    const Vec2 through(3, 4), normal(-std::sin(dip), std::cos(dip));
    JointSet set = joints(dip, 0.7);
    set.through = through;
    const auto lines = joint_lines(set, low, high);
    // As many as the box is wide across the joints.
    const double width = std::abs(normal.x()) * 20 + std::abs(normal.y()) * 10;
    EXPECT_NEAR(double(lines.size()), width / 0.7, 1.001);
    for (const Polyline& line : lines) {
      ASSERT_EQ(line.size(), 2u);
      EXPECT_NEAR(std::remainder(angle_of(line) - dip, std::numbers::pi), 0, 1e-12);
      const double gaps = (offset_of(line, dip) - normal.dot(through)) / 0.7;
      EXPECT_NEAR(gaps, std::round(gaps), 1e-9);  // one of the joints passes `through`
      EXPECT_TRUE(on_box(line[0]) && on_box(line[1]));
    }
    for (std::size_t k = 1; k < lines.size(); ++k)
      EXPECT_NEAR(offset_of(lines[k], dip) - offset_of(lines[k - 1], dip), 0.7, 1e-9);
  }
}

TEST(JointSet, LevelAndUprightJointsAreExactlySo) {
  for (const Polyline& line : joint_lines(joints(0, 0.3), low, high)) EXPECT_EQ(line[0].y(), line[1].y());
  for (const Polyline& line : joint_lines(joints(90 * degree, 0.3), low, high)) EXPECT_EQ(line[0].x(), line[1].x());
}

TEST(JointSet, WithoutAPointOneJointPassesTheCentre) {
  const auto lines = joint_lines(joints(25 * degree, 3), low, high);
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [](const Polyline& l) {
    return distance_to_segment(l[0], l[1], {10, 5}) < 1e-12;
  }));
}

// Of each line the jointed share is the persistence but for the part of a period that the box cuts off; phases are
// drawn evenly, so over 200 lines of 10 periods the deviations average out to some tenths of a per cent.
TEST(JointSet, PersistenceIsTheJointedShare) {
  for (double persistence : {0.3, 0.6, 0.9}) {
    const auto lines = joint_lines(broken_joints(0.05, persistence, 2 * persistence), low, high);
    const double whole = 20 * double(joint_lines(joints(0, 0.05), low, high).size());
    EXPECT_NEAR(total_length(lines) / whole, persistence, 0.01);
    std::size_t inner = 0;
    for (const Polyline& line : lines) {
      const double length = (line[1] - line[0]).norm();
      EXPECT_LE(length, 2 * persistence + 1e-9);
      if (on_box(line[0]) || on_box(line[1])) continue;
      EXPECT_NEAR(length, 2 * persistence, 1e-9);
      ++inner;
    }
    EXPECT_GT(inner, lines.size() / 2);
  }
}

// n whole parts and bridges, lengths uniform within ±s of L and ±g of G: the share of the parts has the standard
// deviation p (1-p) √((s² + g²)/3n). Four of them, beside what the ends of 81 lines of 100 periods make up for.
TEST(JointSet, ScatteredLengthsKeepThePersistence) {
  const Vec2 wide(400, 16);
  for (double persistence : {0.3, 0.6, 0.9}) {
    JointSet set = broken_joints(0.2, persistence, 4 * persistence);
    set.trace_length_scatter = 0.8;
    set.gap_scatter = 0.5;
    const auto lines = joint_lines(set, {0, 0}, wide);
    const double whole = 400 * double(joint_lines(joints(0, 0.2), {0, 0}, wide).size()), parts = whole / 4;
    const double deviation = persistence * (1 - persistence) * std::sqrt((0.8 * 0.8 + 0.5 * 0.5) / 3 / parts);
    const double ends = 1.0 / 100 / std::sqrt(81.0);  // a part of a period more or less at the ends of each line
    EXPECT_NEAR(total_length(lines) / whole, persistence, 4 * (deviation + ends)) << persistence;
    double least = 1e9, most = 0;
    for (const Polyline& line : lines) {
      if (line[0].x() < 1e-9 || line[1].x() > 400 - 1e-9) continue;
      least = std::min(least, line[1].x() - line[0].x());
      most = std::max(most, line[1].x() - line[0].x());
    }
    EXPECT_NEAR(least / set.trace_length, 0.2, 0.01);
    EXPECT_NEAR(most / set.trace_length, 1.8, 0.01);
  }
}

TEST(JointSet, ScatteredLengthsDoNotDependOnTheBox) {
  JointSet set = joints_through(0.5, {1, 1}, 0.3, 3);
  set.persistence = 0.6;
  set.trace_length = 0.8;
  set.trace_length_scatter = set.gap_scatter = 0.5;
  const auto small = joint_lines(set, low, high), large = joint_lines(set, {-40, -30}, {50, 40});
  std::size_t inner = 0;
  for (const Polyline& line : small) {
    if (on_box(line[0]) || on_box(line[1])) continue;
    ++inner;
    EXPECT_TRUE(std::any_of(large.begin(), large.end(), [&](const Polyline& l) {
      return (l[0] - line[0]).norm() < 1e-9 && (l[1] - line[1]).norm() < 1e-9;
    }));
  }
  EXPECT_GT(inner, 100u);
}

TEST(JointSet, BridgesAreStaggered) {
  const auto lines = joint_lines(broken_joints(1, 0.5, 2), low, high);
  std::vector<double> starts;
  for (const Polyline& line : lines)
    if (!on_box(line[0])) starts.push_back(std::fmod(std::min(line[0].x(), line[1].x()), 4.0));
  EXPECT_GT(*std::max_element(starts.begin(), starts.end()) - *std::min_element(starts.begin(), starts.end()), 1);
}

TEST(JointSet, ScatterStaysWithinItsBounds) {
  JointSet set = joints(40 * degree, 0.02);
  set.spacing_scatter = 0.4;
  auto lines = joint_lines(set, low, high);
  double least = 1, most = 0, sum = 0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double gap = (offset_of(lines[k], set.dip) - offset_of(lines[k - 1], set.dip)) / set.spacing;
    least = std::min(least, gap);
    most = std::max(most, gap);
    sum += gap;
  }
  // 700 gaps: the ends of the range are met within a per cent, the mean within 4 σ/√n = 4 · 0.4/√3/√700.
  EXPECT_GE(least, 0.6 - 1e-9);
  EXPECT_LT(least, 0.61);
  EXPECT_LE(most, 1.4 + 1e-9);
  EXPECT_GT(most, 1.39);
  EXPECT_NEAR(sum / double(lines.size() - 1), 1, 0.035);

  set.spacing_scatter = 0;
  set.dip_scatter = 5 * degree;
  lines = joint_lines(set, low, high);
  double largest = 0, mean = 0;
  for (const Polyline& line : lines) {
    const double tilt = std::remainder(angle_of(line) - set.dip, std::numbers::pi);
    largest = std::max(largest, std::abs(tilt));
    mean += tilt / double(lines.size());
  }
  EXPECT_LE(largest, 5 * degree + 1e-12);
  EXPECT_GT(largest, 4.9 * degree);
  EXPECT_NEAR(mean, 0, 0.5 * degree);
}

TEST(JointSet, TheSeedDecides) {
  JointSet set = broken_joints(0.5, 0.7, 1.5);
  set.dip = 20 * degree;
  set.spacing_scatter = 0.3;
  set.dip_scatter = 4 * degree;
  set.seed = 5;
  const auto lines = joint_lines(set, low, high);
  EXPECT_EQ(joint_lines(set, low, high), lines);
  set.seed = 6;
  EXPECT_NE(joint_lines(set, low, high), lines);
}

// splitmix64 is defined to the bit, so these gaps hold on every machine; computed apart from the engine.
TEST(JointSet, TheSeedGivesTheSameOnEveryMachine) {
  const auto mix = [](std::uint64_t state) {
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  };
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
  const JointSet set = joints_through(1, {0, 0}, 0.5, 42);
  const auto lines = joint_lines(set, low, high);
  double y = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    EXPECT_NEAR(lines[k][0].y(), y, 1e-12) << k;
    const double unit = double(mix(mix(42 + golden) + k + golden) >> 11) * 0x1p-53;
    y += 1 + 0.5 * (2 * unit - 1);
  }
  EXPECT_GT(lines.size(), 5u);
}

// A region that is drawn larger keeps the joints that it had.
TEST(JointSet, ALargerBoxAddsLinesAndChangesNone) {
  const JointSet set = joints_through(0.5, {1, 1}, 0.3, 3);
  const auto small = joint_lines(set, low, high), large = joint_lines(set, {0, -30}, {20, 40});
  EXPECT_GT(large.size(), 3 * small.size());
  for (const Polyline& line : small)
    EXPECT_TRUE(std::any_of(large.begin(), large.end(),
                            [&](const Polyline& l) { return std::abs(l[0].y() - line[0].y()) < 1e-9; }));
}

TEST(JointSet, RefusesWhatCannotBe) {
  EXPECT_THROW(joint_lines(joints(0, 0), low, high), InputError);
  EXPECT_THROW(joint_lines(joints(0, NAN), low, high), InputError);
  EXPECT_THROW(joint_lines(broken_joints(1, 0, 1), low, high), InputError);
  EXPECT_THROW(joint_lines(joints(0, 1e-7), low, high), InputError);
  EXPECT_THROW(joint_lines(broken_joints(1, 0.5, 1e-7), low, high), InputError);
  EXPECT_THROW(joint_lines(joints_through(1, {1e12, 1e12}), low, high), InputError);
  JointSet far = broken_joints(1, 0.5, 0.01);
  far.through = Vec2(1e7, 5);
  far.gap_scatter = 0.1;
  EXPECT_THROW(joint_lines(far, low, high), InputError);
}

}  // namespace
}  // namespace talus
