#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "equations/bridge_terms.h"
#include "fracture/cracks.h"
#include "fracture/criterion.h"
#include "fracture/fracture.h"
#include "fracture/reduction.h"
#include "hand_model.h"
#include "small_scene.h"

namespace talus {
namespace {

using test::patterned;
using test::rectangle;
using test::scene_of;

constexpr Strength rock = {0.6, 4e6, 0.5e6};

TEST(Criterion, TensionAndShearGrowWithTheLoad) {
  const Utilisation pulled = utilisation({0.25e6, 0}, rock);
  EXPECT_DOUBLE_EQ(pulled.tension, 0.5);
  EXPECT_DOUBLE_EQ(pulled.shear, 0.25e6 * std::tan(0.6) / 4e6);
  const Utilisation sheared = utilisation({-1e6, -3e6}, rock);
  EXPECT_EQ(sheared.tension, 0);
  EXPECT_DOUBLE_EQ(sheared.shear, (3e6 - 1e6 * std::tan(0.6)) / 4e6);
  EXPECT_DOUBLE_EQ(sheared.most(), sheared.shear);
  const Utilisation twice = utilisation({-2e6, -6e6}, rock);
  EXPECT_DOUBLE_EQ(twice.shear, 2 * sheared.shear);
}

TEST(Criterion, PressureAloneUsesNothing) {
  EXPECT_EQ(utilisation({-5e6, 1e6}, rock).most(), 0);
  EXPECT_EQ(utilisation(BondTraction{}, {0.6, 0, 0}).most(), 0);
}

TEST(Criterion, AStrengthOfZeroIsPassedByAnyLoad) {
  EXPECT_EQ(utilisation({1, 0}, {0, 1e6, 0}).tension, std::numeric_limits<double>::infinity());
  EXPECT_EQ(utilisation({0, 1}, {0, 0, 1e6}).shear, std::numeric_limits<double>::infinity());
}

// A row of n unit squares cut by both diagonals into 4 n triangles; all its bonds can break.
Model row(int n, FailureOrder order = FailureOrder::critical, double band = 0.05) {
  Scene scene = scene_of({patterned("row", rectangle(0, 0, n, 1), MeshKind::cross, n, 1)});
  JointProperty& joint = scene.properties[0];
  joint.breaks = true;
  joint.cohesion = 100;
  joint.tension = 1;
  scene.fracture.order = order;
  scene.fracture.band = band;
  return build(scene);
}

void pull(Model& model, int joint, double normal) {
  for (JointPoint& point : model.joints[joint].points) point.normal = normal;
}

TEST(Criterion, OfTheScriptIsAskedOnceForAllBondsAndKnowsWhereTheyLie) {
  Model model = row(4);
  int asked = 0;
  model.scene.properties[0].criterion = [&](std::span<JudgedBond> bonds, const BondPlaces& places) {
    ++asked;
    for (JudgedBond& bond : bonds) bond.used = places(bond.joint).middle.x() / 100;
  };
  Fracture fracture(model);
  EXPECT_DOUBLE_EQ(fracture.judge(), 0.0375);  // the last square's bonds from its right corners to its middle
  EXPECT_EQ(asked, 1);
  const Joint& first = model.joints[0];
  EXPECT_DOUBLE_EQ(utilisation(model, first), first.utilisation);
  EXPECT_EQ(asked, 2);
}

TEST(Criterion, OfTheScriptLeavesTheModeToTheTraction) {
  Model model = row(1);
  const Joint& joint = model.joints[0];
  EXPECT_EQ(failure_mode(model, joint, {1, 90}), FailureMode::tension);  // of 1 Pa in tension, 100 Pa of cohesion
  model.scene.properties[0].criterion = [](std::span<JudgedBond>, const BondPlaces&) {};
  EXPECT_EQ(failure_mode(model, joint, {1, 90}), FailureMode::shear);
  EXPECT_EQ(failure_mode(model, joint, {2, -2}), FailureMode::tension);
  EXPECT_EQ(failure_mode(model, joint, {-2, 0}), FailureMode::shear);
  EXPECT_EQ(failure_mode(model, joint, {0, 0}), FailureMode::shear);
}

std::vector<int> chosen(Model& model, bool motion = false) {
  Fracture fracture(model);
  fracture.judge();
  return fracture.choose(motion);
}

// A bond that has no corner in common with `joint`.
int apart_from(const Model& model, int joint) {
  for (size_t j = 0; j < model.joints.size(); ++j) {
    bool apart = true;
    for (const int node : model.joints[j].node)
      for (const int other : model.joints[joint].node) apart = apart && node != other;
    if (apart) return int(j);
  }
  return -1;
}

TEST(Choice, NothingBelowItsStrength) {
  Model model = row(2);
  pull(model, 0, 0.999);
  EXPECT_TRUE(chosen(model).empty());
  pull(model, 0, 1 - 1e-9);  // lacks no more than the solver leaves open
  EXPECT_EQ(chosen(model), std::vector<int>{0});
}

TEST(Choice, TheMostCriticalWithThoseInItsBand) {
  Model model = row(3);
  pull(model, 0, 2);
  pull(model, 1, 1.95);
  pull(model, 2, 1.5);
  EXPECT_EQ(chosen(model), (std::vector<int>{0, 1}));
  model.scene.fracture.order = FailureOrder::all;
  EXPECT_EQ(chosen(model), (std::vector<int>{0, 1, 2}));
  model.scene.fracture.order = FailureOrder::one;
  EXPECT_EQ(chosen(model), std::vector<int>{0});
  model.scene.fracture.order = FailureOrder::critical;
  model.scene.fracture.band = 0.5;
  EXPECT_EQ(chosen(model), (std::vector<int>{0, 1, 2}));
}

// Equal bonds fail together, also where they are equal to round-off only and one after the other at the edge of the
// band.
TEST(Choice, TiesFailTogether) {
  Model model = row(3, FailureOrder::one);
  for (int j = 0; j < 5; ++j) pull(model, j, 2 * (1 - 5e-7 * j));
  EXPECT_EQ(chosen(model), (std::vector<int>{0, 1, 2, 3, 4}));
  pull(model, 4, 1.9);
  EXPECT_EQ(chosen(model), (std::vector<int>{0, 1, 2, 3}));
}

TEST(Choice, InMotionABondWaitsForItsNeighboursOnly) {
  Model model = row(5);
  const int far = apart_from(model, 0);
  ASSERT_GE(far, 0);
  pull(model, 0, 3);
  pull(model, far, 1.2);
  EXPECT_EQ(chosen(model, false), std::vector<int>{0});
  EXPECT_EQ(chosen(model, true), (std::vector<int>{0, far}));
}

TEST(Cracks, InitiatedPropagatedCoalesced) {
  Model model = row(4);
  Fracture fracture(model);
  const auto shares = [&](int j, int k) {
    int common = 0;
    for (const int node : model.joints[j].node)
      for (const int other : model.joints[k].node) common += node == other;
    return common;
  };
  // Three bonds in a chain: the ends first, then the one between.
  int middle = -1, left = -1, right = -1;
  for (int m = 0; m < int(model.joints.size()) && middle < 0; ++m)
    for (int l = 0; l < int(model.joints.size()); ++l)
      for (int r = 0; r < int(model.joints.size()); ++r)
        if (l != r && l != m && r != m && shares(m, l) == 1 && shares(m, r) == 1 && shares(l, r) == 0)
          middle = m, left = l, right = r;
  ASSERT_GE(middle, 0);
  fracture.fail({left}, 0.5);
  EXPECT_EQ(model.joints[left].crack, CrackKind::initiated);
  EXPECT_EQ(model.joints[left].failed_at, 0.5);
  fracture.fail({right}, 0.6);
  EXPECT_EQ(model.joints[right].crack, CrackKind::initiated);
  fracture.fail({middle}, 0.7);
  EXPECT_EQ(model.joints[middle].crack, CrackKind::coalesced);
  EXPECT_EQ(fracture.events(), (std::vector<int>{left, right, middle}));
  EXPECT_DOUBLE_EQ(crack_lengths(model).tension,
                   model.joints[left].length + model.joints[middle].length + model.joints[right].length);
  fracture.heal();
  EXPECT_EQ(model.joints[middle].state, JointState::intact);
  EXPECT_TRUE(fracture.events().empty());
  fracture.fail({left}, 0.8);
  fracture.clear_events();
  fracture.fail({middle}, 0.9);
  EXPECT_EQ(model.joints[middle].crack, CrackKind::propagated);
}

TEST(Cracks, FragmentsHangTogetherByIntactBonds) {
  Model model = row(2);
  Fracture fracture(model);
  EXPECT_EQ(fragments(model).size(), 1u);
  std::vector<int> all(model.joints.size());
  std::iota(all.begin(), all.end(), 0);
  fracture.fail(all, 0);
  const std::vector<Fragment> found = fragments(model);
  ASSERT_EQ(found.size(), model.shapes.size());
  EXPECT_EQ(model.fragment[0], 0);
  EXPECT_DOUBLE_EQ(found[0].area, 0.25);
  EXPECT_DOUBLE_EQ(found[0].mass, 0.5);
  EXPECT_NEAR(found[0].size(), std::sqrt(1 / 3.14159265358979), 1e-12);
}

// Area under strength against opening or slip, by the trapezoidal rule up to `end`.
double area(const ReductionLaw& law, bool slip, double end) {
  constexpr int steps = 200000;
  double sum = 0;
  const auto at = [&](int k) {
    const double x = end * k / steps;
    const Strength left = law(rock, slip ? JointWear{x, 0, 0} : JointWear{0, x, 0});
    return slip ? left.cohesion : left.tension;
  };
  for (int k = 0; k < steps; ++k) sum += (at(k) + at(k + 1)) / 2;
  return sum * end / steps;
}

TEST(Reduction, TheAreaUnderASofteningCurveIsItsFractureEnergy) {
  for (const bool exponential : {false, true}) {
    const Softening law = {exponential, 50, 80, {0.6, 0, 0}};
    const double end = exponential ? 40 : 1.5;  // of 2 G/f: the tail left out is e^-80
    EXPECT_NEAR(area(softening(law), false, end * 2 * 50 / rock.tension), 50, 1e-3 * 50) << exponential;
    EXPECT_NEAR(area(softening(law), true, end * 2 * 80 / rock.cohesion), 80, 1e-3 * 80) << exponential;
  }
  const Softening to_residual = {false, 50, 80, {0.6, 1e6, 0.1e6}};
  EXPECT_NEAR(area(softening(to_residual), false, 1e-3) - 0.1e6 * 1e-3, 50, 1e-3 * 50);
  EXPECT_EQ(softening(to_residual)(rock, {1, 1, 0}).cohesion, 1e6);
}

// Linear criterion of mixed modes: works in proportion to their fracture energies where the tractions go along the
// jump.
TEST(Reduction, InMixedModesTheWorksAddUp) {
  const ReductionLaw law = softening({false, 50, 80, {0.6, 0, 0}});
  const double slip = 2 * 80 / rock.cohesion, opening = 2 * 50 / rock.tension;
  const Strength half = law(rock, {slip / 4, opening / 4, 0});
  EXPECT_NEAR(half.tension, rock.tension / 2, 1e-9 * rock.tension);
  EXPECT_NEAR(half.cohesion, rock.cohesion / 2, 1e-9 * rock.cohesion);
  EXPECT_EQ(law(rock, {0.51 * slip, 0.5 * opening, 0}).tension, 0);
}

// A vertical joint of a tracked crack, on a path turned by `turn`, that has failed in tension `with` a traction and
// moves along `way`, normal and slip: what its bridge takes.
double work_of_bridge(double turn, const BondTraction& with, const Vec2& way) {
  Model model = test::two_squares();
  model.scene.fracture.path = CrackPath::tracked;
  JointProperty& property = model.scene.properties[0];
  property.cohesion = rock.cohesion;
  property.tension = rock.tension;
  property.friction = rock.friction;
  property.stiffness = 1e5;  // to its strength in no time
  property.reduction = softening({false, 50, 50, {0.6, 0, 0}});
  Joint& joint = model.joints[0];
  joint.state = JointState::failed;
  joint.mode = FailureMode::tension;
  joint.failed_with = with;
  joint.path_turn = turn;
  joint.remaining = property.reduction(rock, {});
  for (JointPoint& point : joint.points) {
    point.normal = with.normal;
    point.shear = with.shear;
  }
  begin_bridges(model, joint);
  const BridgeTerms terms;
  constexpr int steps = 4000;
  const Vec2 step = way * 4 * 50 / rock.tension / steps;
  double work = 0;
  terms.store_tractions(model);
  for (int k = 0; k < steps; ++k) {
    const BondTraction before = mean_traction(joint);
    for (JointPoint& point : joint.points) {
      point.opening += step.x();
      point.slip += step.y();
    }
    terms.store_tractions(model);
    const BondTraction after = mean_traction(joint);
    work += joint.length / 2 * ((before.normal + after.normal) * step.x() + (before.shear + after.shear) * step.y());
    wear_bridges(model, joint);
  }
  EXPECT_FALSE(joint.bridged);
  return work;
}

// G_I for each length of its path, which is shorter than the joint that lies aslant of it.
TEST(Bridge, AcrossAPathTakesItsFractureEnergyForThePathsLength) {
  for (const double turn : {0.0, 0.5, -0.7}) {
    const Vec2 way(std::cos(turn), std::sin(turn));
    const Vec2 pull = rock.tension * std::cos(turn) * way;  // of a stress across the path
    EXPECT_NEAR(work_of_bridge(turn, {pull.x(), pull.y()}, way), 50 * std::cos(turn), 50e-3) << turn;
  }
}

// Whatever the shear that it failed with: of the cohesion, eight times the tension, it holds no more than that.
TEST(Bridge, OfABondThatFailedInTensionAndShearTakesItsFractureEnergy) {
  for (const double shear : {0.0, 0.5, 2.0})
    for (const double slip : {0.0, 0.3, 1.0})
      EXPECT_NEAR(work_of_bridge(0, {rock.tension, shear * rock.tension}, Vec2(1, slip).normalized()), 50, 0.1)
          << shear << ' ' << slip;
}

TEST(Reduction, SlipWeakeningIsLinearInSlip) {
  const ReductionLaw law = slip_weakening(0.01, {0.2, 1e6, 0});
  EXPECT_EQ(law(rock, {0, 0, 0}).tension, 0);
  EXPECT_DOUBLE_EQ(law(rock, {0, 0, 0}).cohesion, 4e6);
  EXPECT_DOUBLE_EQ(law(rock, {0.005, 0, 0}).cohesion, 2.5e6);
  EXPECT_DOUBLE_EQ(law(rock, {0.005, 0, 0}).friction, 0.4);
  EXPECT_DOUBLE_EQ(law(rock, {0.02, 0, 0}).friction, 0.2);
}

TEST(Reduction, BartonBandisOverTheNormalPressure) {
  constexpr double degree = 3.14159265358979 / 180;
  const ReductionLaw law = barton_bandis(10, 100e6, 30 * degree);
  EXPECT_NEAR(law(rock, {0, 0, -1e6}).friction, 50 * degree, 1e-12);
  EXPECT_NEAR(law(rock, {0, 0, -100e6}).friction, 30 * degree, 1e-12);
  EXPECT_NEAR(law(rock, {0, 0, -1}).friction, 70 * degree, 1e-12);  // at most
  EXPECT_NEAR(law(rock, {0, 0, 0}).friction, 70 * degree, 1e-12);
  EXPECT_EQ(law(rock, {0, 0, -1e6}).cohesion, 0);
}

TEST(Reduction, LargestSofteningBlock) {
  EXPECT_DOUBLE_EQ(10e9 * softening_compliance({false, 50, 50, {}}, 0.5e6), 4);
  EXPECT_DOUBLE_EQ(10e9 * softening_compliance({true, 50, 50, {0, 0, 0.25e6}}, 0.5e6), 8);
}

// Mean 1 and coefficient of variation of Weibull's distribution: sqrt(Γ(1+2/m)/Γ(1+1/m)² - 1); bounds: four standard
// errors.
TEST(Scatter, MeanAndSpreadAreWeibulls) {
  constexpr double modulus = 5;
  Scene scene = scene_of({patterned("plate", rectangle(0, 0, 10, 10), MeshKind::cross, 60, 60)});
  scene.properties[0].weibull = modulus;
  scene.properties[0].seed = 3;
  const Model model = build(scene);
  const double n = double(model.joints.size());
  ASSERT_GT(n, 20000);
  double mean = 0, square = 0;
  for (const Joint& joint : model.joints) {
    EXPECT_GT(joint.scatter, 0);
    mean += joint.scatter / n;
    square += joint.scatter * joint.scatter / n;
  }
  const double first = std::tgamma(1 + 1 / modulus);
  const double deviation = std::sqrt(std::tgamma(1 + 2 / modulus) / (first * first) - 1);
  EXPECT_NEAR(mean, 1, 4 * deviation / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(square - mean * mean), deviation, 0.02 * deviation);
}

}  // namespace
}  // namespace talus
