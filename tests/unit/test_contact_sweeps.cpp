#include <gtest/gtest.h>

#include <cmath>

#include "assembled.h"
#include "contact/detection.h"
#include "small_scene.h"
#include "step/contact_splitting.h"
#include "step/contact_sweeps.h"
#include "step/islands.h"

namespace talus {
namespace {

using test::rectangle;
using test::region;

constexpr double dt = 0.01;

// A step of loose blocks on a held floor, solved by sweeps.
struct Swept {
  Model model;
  Scheme scheme = Scheme::theta(dt, 0.75);
  std::unique_ptr<test::Assembled> assembled;
  ContactTerms terms;
  ContactProblem problem;
  ContactSweeps sweeps;
  ContactSweeps::Progress progress;
  std::vector<double> normal, shear;
  Vector d;

  Swept(const std::vector<Polyline>& blocks, double friction, const Vec2& gravity,
        ContactSweeps::Carry carry = ContactSweeps::Carry::momentum, const std::vector<Region>& meshed = {}) {
    std::vector<Region> regions = {region("floor", rectangle(-5, -1, 10, 1))};
    for (const Polyline& outline : blocks) regions.push_back(region("b" + std::to_string(regions.size()), outline));
    regions.insert(regions.end(), meshed.begin(), meshed.end());
    Scene scene = test::scene_of(regions);
    scene.regions[0].held = true;
    scene.gravity = gravity;
    scene.time.mode = Mode::dynamic;
    model = build(scene);
    for (auto& property : model.scene.properties) property.friction = friction;
    ContactSearch search;
    search.update(model, dt);
    std::vector<std::pair<int, int>> touching;
    for (const Contact& contact : model.contacts) touching.emplace_back(contact.i, contact.j);
    assembled = std::make_unique<test::Assembled>(model, scheme, true, touching);
    terms.linearise(model, assembled->poses, scheme, false, {});
    std::vector<int> place(model.shapes.size());
    Islands islands;
    islands.find(model, terms, true);
    problem.take(model, assembled->system, terms, islands.blocks(0), islands.rows(0), place);
    problem.take_matrix(assembled->system, place);
    sweeps.start(problem);
    normal.assign(model.contacts.size(), 0);
    shear = normal;
    d.setZero(model.dofs);
    progress = sweeps.run({.most = 2000, .enough = 1e-15}, carry, normal, shear, d);
  }
  double gap(size_t k) const {
    const ContactRows& row = terms.rows()[k];
    return row.gap0 + terms.factor() * row.along(row.normal_i, row.normal_j, d);
  }
  double slide(size_t k) const {
    const ContactRows& row = terms.rows()[k];
    return row.slide0 + terms.factor() * row.along(row.shear_i, row.shear_j, d);
  }
  // Momentum with the contacts' forces, N.
  double out_of_balance() const {
    Vector r = assembled->system.force - assembled->dense() * d;
    for (size_t k = 0; k < normal.size(); ++k) {
      const ContactRows& row = terms.rows()[k];
      row.add(row.normal_i, row.normal_j, normal[k], r);
      row.add(row.shear_i, row.shear_j, -shear[k], r);
    }
    return r.norm();
  }
};

// Coulomb's law at every contact, to `tolerance` N.
void expect_law(const Swept& s, double tolerance) {
  for (size_t k = 0; k < s.normal.size(); ++k) {
    const ContactRows& row = s.terms.rows()[k];
    const double n = row.kn * std::max(0.0, -s.gap(k)), limit = row.friction * n;
    EXPECT_NEAR(s.normal[k], n, tolerance) << k;
    EXPECT_NEAR(s.shear[k], std::clamp(row.ks * s.slide(k), -limit, limit), tolerance) << k;
  }
}

const std::vector<Polyline> heap = {
    rectangle(0, 0, 1, 1), rectangle(1, 0, 1, 1), rectangle(0.4, 1, 1, 1), {{1.4, 1}, {2.3, 1}, {1.9, 1.8}}};

TEST(ContactSweeps, MeetTheLawAndTheMomentum) {
  for (const double friction : {0.0, 0.2, 0.8}) {
    const Swept s(heap, friction, {3, -9});
    const double weight = 2 * 9 * 3.36;
    EXPECT_LT(s.progress.change, 1e-14) << friction;
    EXPECT_LT(s.out_of_balance(), 1e-11 * weight) << friction;
    expect_law(s, 1e-8 * weight);
  }
}

TEST(ContactSweeps, MomentumAndMixingEndInTheSameForces) {
  const Swept momentum(heap, 0.5, {3, -9}), mixing(heap, 0.5, {3, -9}, ContactSweeps::Carry::mixing);
  EXPECT_LT(mixing.progress.pairs, momentum.progress.pairs);
  for (size_t k = 0; k < momentum.normal.size(); ++k) {
    EXPECT_NEAR(mixing.normal[k], momentum.normal[k], 1e-8);
    EXPECT_NEAR(mixing.shear[k], momentum.shear[k], 1e-8);
  }
}

// g (1, -1): above 45 degrees of friction the block sticks, below it slides with T = N tan φ.
TEST(ContactSweeps, StickAndSlip) {
  for (const double friction : {0.9, 0.4}) {
    const Swept s({rectangle(0, 0, 4, 1)}, friction, {5, -5});
    double normal = 0, shear = 0;
    for (size_t k = 0; k < s.normal.size(); ++k) {
      const double way = s.model.contacts[k].i == 1 ? 1 : -1;
      normal += s.normal[k];
      shear += way * s.shear[k];
    }
    const double tangent = s.terms.rows()[0].friction;
    if (tangent < 1)
      EXPECT_NEAR(std::abs(shear), tangent * normal, 1e-9 * normal);
    else
      EXPECT_LT(std::abs(shear), tangent * normal);
  }
}

TEST(ContactSweeps, AFreeBlockNeedsNone) {
  const Swept s({rectangle(0, 5, 1, 1)}, 0.5, {0, -10});
  EXPECT_LT(s.out_of_balance(), 1e-13);
}

// The same forces from none, one factor for all that states are roughly known with and one for each set of springs
// after.
TEST(ContactSplitting, EndsInTheForcesOfTheSweeps) {
  for (const double friction : {0.0, 0.2, 0.8}) {
    SCOPED_TRACE(friction);
    const Swept swept(heap, friction, {3, -9});
    Swept split(heap, friction, {3, -9});
    const double weight = 2 * 9 * 3.36;
    split.normal.assign(split.normal.size(), 0);
    split.shear = split.normal;
    split.d.setZero();
    std::vector<char> closed(split.normal.size(), 0), stuck = closed;
    ContactSplitting splitting;
    const ContactSplitting::Contacts contacts{split.normal, split.shear, closed, stuck};
    EXPECT_TRUE(splitting.run(split.problem, true, 4, 100, contacts, split.d).settled);
    const auto progress = splitting.run(split.problem, false, 1000, 300, contacts, split.d);
    EXPECT_LT(progress.change, 1e-11 * weight) << friction;
    EXPECT_EQ(split.problem.solver.factorisations, 2);
    EXPECT_LT(split.out_of_balance(), 1e-9 * weight) << friction;
    expect_law(split, 1e-8 * weight);
    for (size_t k = 0; k < swept.normal.size(); ++k) {
      EXPECT_NEAR(split.normal[k], swept.normal[k], 1e-7 * weight) << k;
      EXPECT_NEAR(split.shear[k], swept.shear[k], 1e-7 * weight) << k;
      EXPECT_EQ(closed[k] != 0, split.normal[k] > 0);
    }
  }
}

// A beam of more bonded blocks than a patch holds, dropped on the floor with a loose stone on it.
TEST(ContactSweeps, BondedBlocksAreSweptTogether) {
  const Region beam = test::patterned("beam", rectangle(0, 0, 4, 0.5), MeshKind::cross, 8, 1);
  for (const double friction : {0.0, 0.6}) {
    const Swept s({rectangle(2, 0.5, 0.5, 0.5)}, friction, {3, -9}, ContactSweeps::Carry::momentum, {beam});
    const double weight = 2 * 9 * 2.25;
    EXPECT_GT(s.model.joints.size(), 30u);
    EXPECT_LT(s.progress.change, 1e-14) << friction;
    EXPECT_LT(s.out_of_balance(), 1e-10 * weight) << friction;
    expect_law(s, 1e-7 * weight);
  }
}

// Triangles round a point: each presses on its neighbours' faces, none on those across.
TEST(Contacts, BlocksThatMeetInAPointPressOnFacesOnly) {
  std::vector<Region> regions;
  const Vec2 centre(0.1, 0.2);
  const int count = 7;
  for (int k = 0; k < count; ++k) {
    const double from = 2 * M_PI * k / count, to = 2 * M_PI * (k + 1) / count;
    regions.push_back(region("t" + std::to_string(k), {centre, centre + Vec2(std::cos(from), std::sin(from)),
                                                       centre + Vec2(std::cos(to), std::sin(to))}));
  }
  Model model = build(test::scene_of(regions));
  ContactSearch search;
  search.update(model, 0.01);
  EXPECT_EQ(model.contacts.size(), 2u * count);
  for (const Contact& c : model.contacts) {
    const int apart = std::abs(c.i - c.j);
    EXPECT_TRUE(apart == 1 || apart == count - 1) << c.i << " " << c.j;
  }
}

}  // namespace
}  // namespace talus
