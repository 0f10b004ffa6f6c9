#include <gtest/gtest.h>

#include <cmath>

#include "contact/detection.h"
#include "equations/contact_terms.h"
#include "small_scene.h"

namespace talus {
namespace {

using test::rectangle;
using test::region;

// A block on a held floor, and beside it one that stands a twentieth of its height above it.
struct Standing {
  Model model;
  ContactTerms terms;

  explicit Standing(bool stick) {
    Scene scene = test::scene_of({region("floor", rectangle(-5, -1, 10, 1)), region("on", rectangle(-2, 0, 1, 1)),
                                  region("above", rectangle(1, 0.05, 1, 1))});
    scene.regions[0].held = true;
    scene.properties[0].friction = 0.5;
    model = build(scene);
    ContactSearch search;
    search.update(model, 0.1);
    const Scheme scheme = Scheme::equilibrium();
    Poses poses;
    poses.predict(model, scheme);
    terms.linearise(model, poses, scheme, stick, {});
  }
  int holding_open() const {  // contacts that may carry shear without being pressed
    int count = 0;
    for (const ContactRows& row : terms.rows()) count += std::isinf(row.cohesion);
    return count;
  }
};

TEST(ContactTerms, WhatDoesNotSlideHoldsItsShearWhereItTouchesPressedOrNot) {
  const Standing standing(true);
  int touching = 0;
  for (const ContactRows& row : standing.terms.rows()) touching += std::abs(row.gap0) < 1e-6;
  ASSERT_GE(touching, 2);
  EXPECT_EQ(standing.holding_open(), touching);
}

TEST(ContactTerms, WithFrictionNothingHoldsThatIsNotPressed) {
  EXPECT_EQ(Standing(false).holding_open(), 0);
}

}  // namespace
}  // namespace talus
