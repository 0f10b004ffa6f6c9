#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "step/swept_law.h"

namespace talus {
namespace {

// Gap and slide that are left under the forces, less what the contact itself gives way.
struct Left {
  double gap, slide;
};

Left left(const SweptLaw& law, double gap0, double slide0, ContactForces f) {
  return {gap0 + law.nn * f.n - law.ns * f.t, slide0 + law.ns * f.n - law.ss * f.t};
}

struct Case {
  SweptLaw law;
  double gap0, slide0;
};

Case random_case(std::mt19937& random) {
  std::uniform_real_distribution<double> part(-1, 1), kind(0, 1);
  const double nn = 1 + 0.9 * part(random), ss = 1 + 0.9 * part(random), ns = 0.9 * part(random) * std::sqrt(nn * ss);
  const double friction = kind(random) < 0.2 ? 0 : 1 + part(random),
               cohesion = kind(random) < 0.5 ? 0 : 0.3 * (1 + part(random));
  return {{nn, ns, ss, friction, cohesion}, part(random), part(random)};
}

// Coulomb's law with cohesion, at one of the states that it may be in; where a contact would wedge itself no force may
// do.
TEST(SweptLaw, MeetsCoulombsLaw) {
  std::mt19937 random(7);
  int met = 0, count = 20000;
  for (int k = 0; k < count; ++k) {
    const auto [law, gap0, slide0] = random_case(random);
    const ContactForces f = law.meet(gap0, slide0);
    const auto [gap, slide] = left(law, gap0, slide0, f);
    const double limit = law.friction * f.n + law.cohesion, same = 1e-9;
    const bool normal = f.n > 0 ? std::abs(gap) < same : gap > -same;
    const bool shear =
        std::abs(f.t) < limit - same ? std::abs(slide) < same : std::abs(f.t) <= limit + same && slide * f.t >= -same;
    met += normal && shear;
  }
  EXPECT_GT(met, 0.999 * count);
}

TEST(SweptLaw, FourAtOnceAreAsOneByOne) {
  std::mt19937 random(11);
  int found = 0, count = 20000;
  for (int k = 0; k < count; k += 4) {
    FourLaws laws = FourLaws::open();
    Four gap0{}, slide0{}, n, t;
    std::array<Case, 4> cases;
    for (size_t c = 0; c < 4; ++c) {
      cases[c] = random_case(random);
      laws.put(c, cases[c].law);
      gap0[c] = cases[c].gap0;
      slide0[c] = cases[c].slide0;
    }
    laws.meet(gap0, slide0, n, t);
    for (size_t c = 0; c < 4; ++c) {
      if (std::isnan(n[c])) continue;
      ++found;
      const auto [law, own_gap, own_slide] = cases[c];
      const ContactForces one = law.meet(own_gap, own_slide);
      EXPECT_NEAR(n[c], one.n, 1e-12 * (1 + std::abs(one.n)));
      EXPECT_NEAR(t[c], one.t, 1e-12 * (1 + std::abs(one.t)));
    }
  }
  EXPECT_GT(found, 0.9 * count);
}

TEST(SweptLaw, NothingStaysOpen) {
  const Four gap = {1, 2, 3, 4}, slide{};
  Four n, t;
  FourLaws::open().meet(gap, slide, n, t);
  for (size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(n[c], 0);
    EXPECT_EQ(t[c], 0);
  }
}

}  // namespace
}  // namespace talus
