// The registry of state: every registered value counts in the hash, and comes back from the bytes.
#include <gtest/gtest.h>

#include "hand_model.h"
#include "model/registry.h"
#include "model/saved_state.h"

namespace talus {
namespace {

// Changes the n-th value of what it goes through.
class Nudge : public StateVisitor {
 public:
  Nudge(long target, Part part) : StateVisitor(part), target_(target) {}
  long count() const { return next_; }
  std::string name() const { return name_; }

 protected:
  void enter(const char* name) override {
    if (next_ <= target_) name_ = name;
  }
  void take(double& value) override {
    if (next_++ == target_) value += 1;
  }
  void take(std::int64_t& value) override {
    if (next_++ == target_) value ^= 1;
  }
  void take(std::string& value) override {
    if (next_++ == target_) value += "x";
  }
  void take_law(std::function<double(double)>& function) override {
    if (next_++ != target_) return;
    if (function)
      function = nullptr;
    else
      function = [](double) { return 1.0; };
  }
  void resize(std::size_t&) override {}
  void check_length(std::size_t) override {}

 private:
  long target_, next_ = 0;
  std::string name_;
};

Model loaded() {
  Model model = test::moved_squares();
  model.shapes[0].dof_begin = 0;
  PointLoad load;
  load.force[0] = History({{0, 1}, {2, 3}});
  model.scene.point_loads = {load};
  model.scene.edge_loads.resize(1);
  model.scene.fixities.resize(1);
  model.point_forces.resize(1);
  model.edge_forces.resize(1);
  model.point_fixities.resize(1);
  model.edge_fixities.resize(1);
  model.viscous_edges.resize(1);
  return model;
}

std::string bytes_of(Model& model, StateVisitor::Part part = StateVisitor::Part::state) {
  StateWriter writer(part);
  visit_state(model, writer);
  return writer.bytes;
}

std::uint64_t hash_of(Model& model, StateVisitor::Part part = StateVisitor::Part::state) {
  StateHasher hasher(part);
  visit_state(model, hasher);
  return hasher.value();
}

class EveryValue : public testing::TestWithParam<StateVisitor::Part> {};

TEST_P(EveryValue, CountsInTheHash) {
  Model model = loaded();
  Nudge counter(-1, GetParam());
  visit_state(model, counter);
  EXPECT_GT(counter.count(), 80);
  const std::uint64_t before = hash_of(model, GetParam());
  for (long k = 0; k < counter.count(); ++k) {
    Model changed = loaded();
    Nudge nudge(k, GetParam());
    visit_state(changed, nudge);
    EXPECT_NE(hash_of(changed, GetParam()), before) << "value " << k << ", " << nudge.name();
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryValue,
                         testing::Values(StateVisitor::Part::state, StateVisitor::Part::constant));

TEST(Registry, EveryStateComesBackFromItsBytes) {
  Model model = loaded();
  const std::string before = bytes_of(model);
  Nudge counter(-1, StateVisitor::Part::state);
  visit_state(model, counter);
  for (long k = 0; k < counter.count(); ++k) {
    Nudge nudge(k, StateVisitor::Part::state);
    visit_state(model, nudge);
    ASSERT_NE(bytes_of(model), before) << nudge.name();
    StateReader reader(before);
    visit_state(model, reader);
    EXPECT_TRUE(reader.done());
    ASSERT_EQ(bytes_of(model), before) << "value " << k << ", " << nudge.name();
  }
}

TEST(Registry, ConstantsAreNotPartOfTheState) {
  Model model = loaded();
  const std::uint64_t state = hash_of(model), constants = hash_of(model, StateVisitor::Part::constant);
  model.shapes[0].area = 3;
  EXPECT_EQ(hash_of(model), state);
  EXPECT_NE(hash_of(model, StateVisitor::Part::constant), constants);
}

TEST(Registry, NegativeZeroIsZeroInTheHashAndItselfInTheBytes) {
  Model model = loaded();
  model.blocks[0].shift = {0, 0};
  const std::uint64_t hash = hash_of(model);
  const std::string bytes = bytes_of(model);
  model.blocks[0].shift = {-0.0, 0};
  EXPECT_EQ(hash_of(model), hash);
  EXPECT_NE(bytes_of(model), bytes);
}

TEST(Registry, ContactsComeAndGo) {
  Model model = loaded();
  const std::string one = bytes_of(model);
  model.contacts.push_back(model.contacts[0]);
  const std::string two = bytes_of(model);
  StateReader back(one), forth(two);
  visit_state(model, back);
  EXPECT_EQ(model.contacts.size(), 1u);
  visit_state(model, forth);
  EXPECT_EQ(model.contacts.size(), 2u);
  EXPECT_EQ(bytes_of(model), two);
}

TEST(Registry, BytesCutAnywhereAreRefused) {
  Model model = loaded();
  const std::string whole = bytes_of(model);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    Model target = loaded();
    StateReader reader(std::string_view(whole).substr(0, length));
    EXPECT_THROW(visit_state(target, reader), StateError) << length;
  }
}

TEST(Registry, ABlockMoreIsRefused) {
  Model model = loaded(), larger = loaded();
  larger.blocks.resize(3);
  const std::string bytes = bytes_of(larger);
  StateReader reader(bytes);
  EXPECT_THROW(visit_state(model, reader), StateError);
}

TEST(Registry, FunctionsAreTheScriptsToGive) {
  Model with = loaded(), without = loaded();
  with.scene.point_loads[0].force[1] = History([](double t) { return 7 * t; });
  const std::string bytes = bytes_of(with);
  StateReader missing(bytes), present(bytes);
  EXPECT_THROW(visit_state(without, missing), StateError);
  visit_state(with, present);
  EXPECT_EQ(with.scene.point_loads[0].force[1].at(1), 7);
}

TEST(Layout, FollowsTheTablesNotTheirLengths) {
  Model model = loaded();
  LayoutHasher first, second;
  visit_state(model, first);
  model.contacts.clear();
  model.scene.point_loads.clear();
  visit_state(model, second);
  EXPECT_EQ(first.value(), second.value());
  LayoutHasher values;
  visit_values(model.scene, values);
  EXPECT_NE(values.value(), first.value());
}

TEST(Fingerprint, TellsWhatDiffers) {
  Model model = loaded(), moved = loaded(), softer = loaded(), larger = loaded();
  moved.reference_vertex[2].x() += 1e-12;
  softer.scene.materials[0].young *= 2;
  larger.shapes.emplace_back();
  const Fingerprint here = fingerprint(model);
  check_same_scene(here, fingerprint(model));
  const auto reason = [&](Model& other) {
    try {
      check_same_scene(fingerprint(other), here);
    } catch (const StateError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(reason(moved).find("blocks, supports or gravity"), std::string::npos) << reason(moved);
  EXPECT_NE(reason(softer).find("materials, joints, supports or loads"), std::string::npos) << reason(softer);
  EXPECT_NE(reason(larger).find("of 3 blocks, 1 bonds and 8 corners; this one has 2 blocks"), std::string::npos)
      << reason(larger);
}

}  // namespace
}  // namespace talus
