#include <gtest/gtest.h>

#include "assembled.h"
#include "contact/detection.h"
#include "small_scene.h"
#include "step/islands.h"
#include "step/simulation.h"

namespace talus {
namespace {

using test::rectangle;
using test::region;

constexpr double island_dt = 0.01;

// Blocks on one held floor, in motion.
Scene on_floor(const std::vector<Polyline>& blocks) {
  std::vector<Region> regions = {region("floor", rectangle(-10, -1, 30, 1))};
  for (const Polyline& outline : blocks) regions.push_back(region("b" + std::to_string(regions.size()), outline));
  Scene scene = test::scene_of(regions);
  scene.regions[0].held = true;
  scene.gravity = {0, -9};
  scene.time.mode = Mode::dynamic;
  scene.time.t_end = 1;
  scene.time.dt = island_dt;
  return scene;
}

const std::vector<Polyline> left = {rectangle(-8, 0, 1, 1), rectangle(-7.7, 1, 1, 1)};
const std::vector<Polyline> right = {rectangle(8, 0, 2, 1), rectangle(8.2, 1, 1, 1), rectangle(8.3, 2, 1, 1)};
const Polyline flier = rectangle(0, 5, 1, 1);

std::vector<Polyline> together(std::vector<Polyline> a, const std::vector<Polyline>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Found {
  Model model;
  ContactTerms terms;
  Islands islands;
  explicit Found(const std::vector<Polyline>& blocks, bool as_one = false) : model(build(on_floor(blocks))) {
    ContactSearch search;
    search.update(model, island_dt);
    Poses poses;
    const Scheme scheme = Scheme::theta(island_dt, 0.75);
    poses.predict(model, scheme);
    terms.linearise(model, poses, scheme, false, {});
    islands.find(model, terms, as_one);
  }
  std::vector<int> blocks(int island) const { return {islands.blocks(island).begin(), islands.blocks(island).end()}; }
};

TEST(Islands, StacksOnOneFloorAreApart) {
  const Found found(together(together(left, {flier}), right));
  ASSERT_EQ(found.islands.count(), 3);
  EXPECT_EQ(found.blocks(0), (std::vector<int>{0, 1, 2}));  // with the floor, which ties nothing
  EXPECT_EQ(found.blocks(1), (std::vector<int>{3}));
  EXPECT_EQ(found.blocks(2), (std::vector<int>{0, 4, 5, 6}));
  EXPECT_EQ(found.islands.first(2), 4);
  EXPECT_TRUE(found.islands.single(1));
  EXPECT_FALSE(found.islands.single(0));
  EXPECT_EQ(found.islands.of(0), -1);
  EXPECT_EQ(found.islands.rows(0).size() + found.islands.rows(2).size(), found.terms.rows().size());
  EXPECT_TRUE(found.islands.rows_between().empty());
}

TEST(Islands, AsOneForStudy) {
  const Found found(together(left, right), true);
  ASSERT_EQ(found.islands.count(), 1);
  EXPECT_EQ(found.islands.blocks(0).size(), 6u);
  EXPECT_EQ(found.islands.rows(0).size(), found.terms.rows().size());
}

TEST(Islands, BondsTieAndFailedOnesDoNot) {
  Model model = build(test::scene_of({test::patterned("plate", rectangle(0, 0, 2, 1), MeshKind::cross, 1, 1)}));
  Islands islands;
  islands.find(model, {}, false);
  EXPECT_EQ(islands.count(), 1);
  EXPECT_FALSE(islands.single(0));
  for (Joint& joint : model.joints) joint.state = JointState::failed;
  islands.find(model, {}, false);
  EXPECT_EQ(islands.count(), int(model.shapes.size()));
  EXPECT_TRUE(islands.single(0));
}

TEST(Islands, APartOfTheMatrixIsTheMatrixOfThePart) {
  Model model = build(test::irregular());
  const test::Assembled all(model);
  std::vector<int> place(model.shapes.size()), every;
  for (size_t b = 0; b < place.size(); ++b) every.push_back(place[b] = int(b));
  BlockMatrix part;
  EXPECT_TRUE(part.take_part(all.system.matrix, every, place));
  EXPECT_EQ(part.values, all.system.matrix.values);
  EXPECT_EQ(part.row_index(), all.system.matrix.row_index());
  EXPECT_FALSE(part.take_part(all.system.matrix, every, place));
}

// Places and speeds of the listed blocks after some steps.
std::vector<double> run(const Scene& scene, int first, int count) {
  Simulation simulation(scene);
  simulation.model.blocks[size_t(first)].velocity[0] = 0.3;
  for (int i = 0; i < 40; ++i) simulation.step();
  std::vector<double> end;
  for (int b = first; b < first + count; ++b) {
    const BlockState& state = simulation.model.blocks[size_t(b)];
    end.insert(end.end(), {state.shift.x(), state.shift.y(), state.angle, state.strain[0], state.strain[2]});
    end.insert(end.end(), state.velocity.begin(), state.velocity.end());
  }
  return end;
}

// A block high up keeps the box of the scene, from whose middle lengths are measured, the same.
TEST(Islands, EachMovesAsIfItWereAlone) {
  const Polyline top = rectangle(0, 20, 1, 1);
  const auto both = together(together({top}, left), right);
  EXPECT_EQ(run(on_floor(both), 2, 2), run(on_floor(together({top}, left)), 2, 2));
  EXPECT_EQ(run(on_floor(both), 4, 3), run(on_floor(together({top}, right)), 2, 3));
}

TEST(Islands, EachWayOfSolvingEndsInTheSamePlace) {
  Scene scene = on_floor(together(left, right));
  const std::vector<double> automatic = run(scene, 1, 5);
  scene.numerics.islands = false;
  for (const ContactSolver solver : {ContactSolver::automatic, ContactSolver::factor, ContactSolver::sweeps}) {
    scene.numerics.solver = solver;
    const std::vector<double> other = run(scene, 1, 5);
    for (size_t k = 0; k < other.size(); ++k) EXPECT_NEAR(other[k], automatic[k], 1e-6);
  }
}

TEST(Islands, CountedByHowTheyWereSolved) {
  Scene scene = on_floor(together(left, {flier}));
  Simulation by_itself(scene);
  by_itself.step();
  EXPECT_EQ(by_itself.totals.islands.single, 1);
  EXPECT_EQ(by_itself.totals.islands.by_sweeps, 1);
  EXPECT_EQ(by_itself.totals.islands.with_factor, 0);
  scene.numerics.solver = ContactSolver::factor;
  Simulation factored(scene);
  factored.step();
  EXPECT_EQ(factored.totals.islands.with_factor, 2);
  EXPECT_EQ(factored.totals.sweeps, 0);
}

}  // namespace
}  // namespace talus
