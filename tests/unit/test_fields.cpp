#include <gtest/gtest.h>

#include <set>

#include "hand_model.h"
#include "model/fields.h"

namespace talus {
namespace {

using test::moved_squares;
using test::two_squares;

std::vector<double> get(const Model& model, std::span<const Field> fields, const std::string& name, int id = 0) {
  const Field* field = find_field(fields, name);
  EXPECT_NE(field, nullptr) << name;
  if (!field) return {};
  std::vector<double> values(field->components, -99.0);
  field->get({model, nullptr}, id, values.data());
  return values;
}

double block(const Model& model, const std::string& name, int id = 0) {
  return get(model, block_fields(), name, id).at(0);
}
double joint(const Model& model, const std::string& name) {
  return get(model, joint_fields(), name).at(0);
}
double contact(const Model& model, const std::string& name) {
  return get(model, contact_fields(), name).at(0);
}
double probe(const Model& model, const std::string& name) {
  return get(model, probe_fields(), name).at(0);
}

TEST(Fields, NamesAreUniqueAndEveryFieldHasAMeaning) {
  for (const auto fields : {block_fields(), joint_fields(), contact_fields(), probe_fields()}) {
    std::set<std::string> names;
    for (const Field& field : fields) {
      EXPECT_TRUE(names.insert(field.name).second) << field.name;
      EXPECT_FALSE(field.meaning.empty()) << field.name;
      EXPECT_TRUE(field.components >= 1 && field.components <= 3) << field.name;
    }
  }
}

TEST(Fields, UnknownNameIsNull) {
  EXPECT_EQ(find_field(block_fields(), "sigma"), nullptr);
}

TEST(BlockFields, WhatABlockIs) {
  const Model model = two_squares();
  EXPECT_EQ(block(model, "id", 1), 1);
  EXPECT_EQ(block(model, "region", 1), 1);
  EXPECT_EQ(block(model, "material", 1), 0);
  EXPECT_EQ(block(model, "order", 0), 1);
  EXPECT_EQ(block(model, "order", 1), 0);
  EXPECT_EQ(block(model, "fixed", 0), 0);
  EXPECT_EQ(block(model, "fixed", 1), 1);
  EXPECT_EQ(block(model, "density"), 2000);
  EXPECT_DOUBLE_EQ(block(model, "mass"), 2000);
  EXPECT_DOUBLE_EQ(block(moved_squares(), "area"), 1.001 * 0.998 - 0.0002 * 0.0002);
}

TEST(BlockFields, MotionAndPlaceInUserCoordinates) {
  const Model model = moved_squares();
  EXPECT_EQ(get(model, block_fields(), "centroid"), (std::vector<double>{100.6, 50.7}));
  EXPECT_NEAR(block(model, "ux"), 0.1, 1e-15);
  EXPECT_NEAR(block(model, "uy"), 0.2, 1e-15);
  EXPECT_NEAR(block(model, "u"), std::sqrt(0.05), 1e-15);
  EXPECT_EQ(get(model, block_fields(), "velocity"), (std::vector<double>{3, 4}));
  EXPECT_DOUBLE_EQ(block(model, "speed"), 5);
  EXPECT_DOUBLE_EQ(block(model, "rotation"), std::acos(0.0));
  EXPECT_DOUBLE_EQ(block(model, "spin"), 0.5);
}

TEST(BlockFields, StrainTurnsWithTheBlock) {
  const Model model = moved_squares();
  const auto strain = get(model, block_fields(), "strain");
  EXPECT_NEAR(strain[0], -0.002, 1e-15);
  EXPECT_NEAR(strain[1], 0.001, 1e-15);
  EXPECT_NEAR(strain[2], -0.0004, 1e-15);
  EXPECT_EQ(block(model, "exx"), strain[0]);
  EXPECT_EQ(block(model, "eyy"), strain[1]);
  EXPECT_EQ(block(model, "gxy"), strain[2]);
}

TEST(BlockFields, StressAndWhatFollowsFromIt) {
  Model model = two_squares();
  model.shapes[0].initial_stress = {3e6, -1e6, 2e6};
  EXPECT_DOUBLE_EQ(block(model, "sxx"), 3e6);
  EXPECT_DOUBLE_EQ(block(model, "syy"), -1e6);
  EXPECT_DOUBLE_EQ(block(model, "sxy"), 2e6);
  EXPECT_DOUBLE_EQ(block(model, "szz"), 0.25 * 2e6);
  EXPECT_NEAR(block(model, "s1"), 1e6 + std::sqrt(8.) * 1e6, 1e-6);
  EXPECT_NEAR(block(model, "s2"), 1e6 - std::sqrt(8.) * 1e6, 1e-6);
  EXPECT_NEAR(block(model, "s1_direction"), std::atan(1.0) / 2, 1e-12);  // 2·sxy = sxx - syy: 22.5°
  // ((3+1)² + (-1-0.5)² + (0.5-3)²)/2 + 3·2²
  EXPECT_NEAR(block(model, "mises"), 1e6 * std::sqrt((16 + 2.25 + 6.25) / 2 + 12), 1e-3);
  model.scene.materials[0].plane = Plane::stress;
  EXPECT_EQ(block(model, "szz"), 0);
  EXPECT_EQ(get(model, block_fields(), "stress_smooth"), get(model, block_fields(), "stress"));  // no recovery
  EXPECT_EQ(block(model, "s1_smooth"), block(model, "s1"));
}

TEST(Principals, MostTensileFirstAlsoInCompression) {
  const Principals p = principals({-5, -2, 0});
  EXPECT_DOUBLE_EQ(p.first, -2);
  EXPECT_DOUBLE_EQ(p.second, -5);
  EXPECT_DOUBLE_EQ(p.direction, std::acos(0.0));
}

TEST(JointFields, MeansAreWeighted) {
  Model model = two_squares();
  EXPECT_DOUBLE_EQ(joint(model, "normal_traction"), 0.75 * 400 + 0.25 * 800);
  EXPECT_DOUBLE_EQ(joint(model, "shear_traction"), -0.75 * 8 + 0.25 * 16);
  EXPECT_DOUBLE_EQ(joint(model, "opening"), 0.005);
  EXPECT_DOUBLE_EQ(joint(model, "slip"), 0.05);
  EXPECT_EQ(joint(model, "block_b"), 1);
  EXPECT_EQ(joint(model, "trace"), -1);
  EXPECT_EQ(joint(model, "state"), 0);
  model.joints[0].state = JointState::failed;
  EXPECT_EQ(joint(model, "state"), 1);
}

TEST(JointFields, MiddleLiesBetweenTheBlocks) {
  Model model = two_squares();
  model.blocks[1].centroid += Vec2(0.2, 0);
  const auto mid = get(model, joint_fields(), "mid");
  EXPECT_NEAR(mid[0], 101.1, 1e-12);
  EXPECT_NEAR(mid[1], 50.5, 1e-12);
}

TEST(ContactFields, ForcesTractionsAndState) {
  Model model = two_squares();
  EXPECT_EQ(contact(model, "kind"), 2);
  EXPECT_EQ(contact(model, "state"), 2);
  EXPECT_EQ(contact(model, "normal_force"), 1000);
  EXPECT_DOUBLE_EQ(contact(model, "normal_traction"), -2000);  // pressed: not tension
  EXPECT_DOUBLE_EQ(contact(model, "shear_traction"), 500);
  EXPECT_EQ(contact(model, "gap"), -1e-4);
  EXPECT_EQ(contact(model, "stretch"), 2e-5);
  EXPECT_EQ(get(model, contact_fields(), "point"), (std::vector<double>{101, 50}));
  model.contacts[0].length = 0;
  EXPECT_EQ(contact(model, "normal_traction"), 0);
}

TEST(ProbeFields, FollowTheMaterialPoint) {
  const Model model = moved_squares();
  // in_block (0.5, 0.5), strained to (0.5006, 0.4991), turned by 90° to (-0.4991, 0.5006).
  EXPECT_NEAR(probe(model, "x"), 100.6 - 0.4991, 1e-12);
  EXPECT_NEAR(probe(model, "y"), 50.7 + 0.5006, 1e-12);
  EXPECT_NEAR(probe(model, "ux"), 0.6 - 0.4991 - 1, 1e-12);
  EXPECT_NEAR(probe(model, "uy"), 0.7 + 0.5006 - 1, 1e-12);
  EXPECT_NEAR(probe(model, "vx"), 3 - 0.5 * 0.5006, 1e-12);
  EXPECT_NEAR(probe(model, "vy"), 4 - 0.5 * 0.4991, 1e-12);
  EXPECT_NEAR(probe(model, "speed"), std::hypot(probe(model, "vx"), probe(model, "vy")), 1e-12);
  EXPECT_EQ(probe(model, "sxx"), model.stress(0)[0]);
  EXPECT_EQ(probe(model, "raw_sxy"), model.stress(0)[2]);
  EXPECT_EQ(probe(model, "s1"), principals(model.stress(0)).first);
}

}  // namespace
}  // namespace talus
