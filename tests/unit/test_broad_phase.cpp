#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/detection.h"
#include "geometry/polygon.h"
#include "hand_model.h"

namespace talus {
namespace {

using test::rectangle;

// Boxes grown by their motion and by a part of the block, as detection.h tells; all pairs.
std::vector<std::pair<int, int>> brute_force(const Model& model, double dt) {
  const int count = int(model.shapes.size());
  std::vector<Bounds> boxes;
  for (int b = 0; b < count; ++b) {
    const BlockShape& s = model.shapes[b];
    const auto& v = model.blocks[b].velocity;
    Polyline outline(model.vertex.begin() + s.vertex_begin, model.vertex.begin() + s.vertex_end);
    const Polyline now = outline;
    for (const Vec2& p : now) outline.push_back(p + dt * Vec2(v[0], v[1]));
    Bounds box = bounds(outline);
    const double margin = search_margin * s.length + std::abs(v[2]) / s.length * s.radius * dt;
    box.min.array() -= margin;
    box.max.array() += margin;
    boxes.push_back(box);
  }
  std::vector<std::pair<int, int>> pairs;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b)
      if ((boxes[a].min.array() <= boxes[b].max.array()).all() &&
          (boxes[b].min.array() <= boxes[a].max.array()).all() && model.shapes[a].dofs + model.shapes[b].dofs > 0)
        pairs.push_back({a, b});
  return pairs;
}

// 400 blocks with sizes over four decades, moving and turning, some held.
TEST(BroadPhase, FindsWhatBruteForceFinds) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    Model model;
    std::vector<int> all;
    for (int b = 0; b < 400; ++b) {
      const double width = std::pow(10, 2 * unit(random) - 1), height = width * std::pow(10, unit(random));
      test::add_block(model, rectangle(20 * unit(random) - 7, 20 * unit(random), width, height), b % 7 ? 6 : 0, 0);
      model.blocks[b].angle = 3 * unit(random);
      model.blocks[b].velocity = {10 * unit(random), 10 * unit(random), width * unit(random), 0, 0, 0};
      all.push_back(b);
    }
    model.place_vertices();
    for (double dt : {0.0, 0.1}) {
      const auto expected = brute_force(model, dt);
      ASSERT_GT(expected.size(), 100u);
      EXPECT_EQ(NearBlocks().find(model, model.blocks, all, dt), expected) << seed << " " << dt;
    }
  }
}

// One list is kept for several steps, in which blocks go on, some faster than they did when it was made.
TEST(BroadPhase, FindsTheSameFromStepToStep) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  Model model;
  std::vector<int> all;
  for (int b = 0; b < 200; ++b) {
    test::add_block(model, rectangle(10 * unit(random), 10 * unit(random), 1, 1), b % 7 ? 6 : 0, 0);
    model.blocks[size_t(b)].velocity = {unit(random), unit(random), unit(random), 0, 0, 0};
    all.push_back(b);
  }
  NearBlocks near;
  std::vector<std::pair<int, int>> before;
  int changes = 0;
  const double dt = 0.02;
  for (int step = 0; step < 60; ++step) {
    model.place_vertices();
    const auto found = near.find(model, model.blocks, all, dt);
    EXPECT_EQ(found, brute_force(model, dt)) << step;
    changes += found != before;
    before = found;
    for (int b = 0; b < 200; ++b) {
      BlockState& state = model.blocks[size_t(b)];
      if (step % 10 == 9) state.velocity[0] += 3 * unit(random);
      state.centroid += dt * Vec2(state.velocity[0], state.velocity[1]);
    }
  }
  EXPECT_GT(changes, 20);
}

TEST(BroadPhase, LooksOnlyAtTheBlocksOfTheList) {
  Model model;
  for (int b = 0; b < 6; ++b) test::add_block(model, rectangle(b, 0, 1, 1), 6, 0);
  model.place_vertices();
  using List = std::vector<std::pair<int, int>>;
  EXPECT_EQ(NearBlocks().find(model, model.blocks, {0, 1, 3, 4}, 0), (List{{0, 1}, {3, 4}}));
  EXPECT_EQ(NearBlocks().find(model, model.blocks, {}, 0), List{});
}

}  // namespace
}  // namespace talus
