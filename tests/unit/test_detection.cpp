#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "contact/detection.h"
#include "geometry/polygon.h"
#include "small_scene.h"

namespace talus {
namespace {

using test::rectangle;
using test::region;
using test::scene_of;

Polyline moved(Polyline points, const Vec2& by) {
  for (Vec2& p : points) p += by;
  return points;
}

// Blocks of one region each, touching or apart, after a search for the next `dt`.
Model searched(const std::vector<Polyline>& blocks, double dt = 0) {
  std::vector<Region> regions;
  for (const Polyline& outline : blocks) regions.push_back(region("r" + std::to_string(regions.size()), outline));
  Model model = build(scene_of(regions));
  ContactSearch search;
  search.update(model, dt);
  return model;
}

using Pairs = std::multiset<std::pair<int, int>>;  // (vertex's block, edge's block)
Pairs pairs_of(const Model& model) {
  Pairs pairs;
  for (const Contact& c : model.contacts) pairs.insert({c.i, c.j});
  return pairs;
}

const Polyline slab = rectangle(-5, -1, 10, 1);
const Polyline diamond = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};

TEST(Contacts, VertexOnEdge) {
  const Model model = searched({slab, moved(diamond, {0.3, 1.01})});
  ASSERT_EQ(model.contacts.size(), 1u);
  const Contact& c = model.contacts[0];
  EXPECT_EQ(c.kind, ContactKind::angle_edge);
  EXPECT_EQ(c.i, 1);
  EXPECT_EQ(c.vertex, 0);
  EXPECT_EQ(c.j, 0);
  EXPECT_EQ(c.edge, 2);
  EXPECT_NEAR(c.gap, 0.01, 1e-14);
  EXPECT_EQ(c.length, 0);
  EXPECT_EQ(c.offset, 0);
  EXPECT_EQ(c.state, ContactState::open);
  EXPECT_EQ(model.vertex[c.global_vertex], Vec2(0.3, 1.01 - 1));
}

TEST(Contacts, EdgeOnEdgeAreTwoVerticesOfHalfTheLengthEach) {
  const Model model = searched({slab, rectangle(1, 0, 2, 1)});
  ASSERT_EQ(model.contacts.size(), 2u);
  for (const Contact& c : model.contacts) {
    EXPECT_EQ(c.kind, ContactKind::edge_edge);
    EXPECT_EQ(c.i, 1);
    EXPECT_EQ(c.j, 0);
    EXPECT_EQ(c.edge, 2);
    EXPECT_NEAR(c.length, 1, 1e-14);
    EXPECT_NEAR(c.gap, 0, 1e-15);
    // α E / h for its length, h the length of the smaller block
    EXPECT_NEAR(c.normal_stiffness, 100 * 1000 / std::sqrt(2.0) * 1, 1e-6);
    EXPECT_NEAR(c.shear_stiffness, 0.4 * c.normal_stiffness, 1e-6);
  }
  // Overhanging, one end of either edge lies on the other.
  EXPECT_EQ(pairs_of(searched({slab, rectangle(4, 0, 2, 1)})), (Pairs{{0, 1}, {1, 0}}));
}

TEST(Contacts, CornerOnCornerIsOne) {
  const Model model = searched({rectangle(0, 0, 1, 1), rectangle(1.01, 1.01, 1, 1)});
  ASSERT_EQ(model.contacts.size(), 1u);
  EXPECT_EQ(model.contacts[0].kind, ContactKind::angle_angle);
  EXPECT_NEAR(model.contacts[0].gap, 0.01, 1e-14);
}

TEST(Contacts, FourSquaresAtAPoint) {
  const Model model =
      searched({rectangle(0, 0, 1, 1), rectangle(1, 0, 1, 1), rectangle(0, 1, 1, 1), rectangle(1, 1, 1, 1)});
  std::set<std::pair<int, int>> touching;
  for (const Contact& c : model.contacts) touching.insert(std::minmax(c.i, c.j));
  for (const auto& pair : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 3), std::pair(2, 3)})
    EXPECT_TRUE(touching.contains(pair)) << pair.first << pair.second;
  double length = 0;
  for (const Contact& c : model.contacts) length += c.length;
  EXPECT_NEAR(length, 4, 1e-12);  // the four common edges, none counted twice
}

TEST(Contacts, NoneBeyondWhatCanClose) {
  const auto two = [](double gap) { return std::vector<Polyline>{slab, moved(diamond, {0.3, 1 + gap})}; };
  EXPECT_EQ(searched(two(0.5)).contacts.size(), 0u);
  // within reach when it flies there: 0.5 m at 10 m/s in 0.06 s
  Model model = searched(two(0.5));
  ContactSearch search;
  model.blocks[1].velocity = {0, -10, 0, 0, 0, 0};
  search.update(model, 0.06);
  EXPECT_EQ(pairs_of(model), (Pairs{{1, 0}}));
}

// A corner meets the edge that is there where it comes to the edge's line, not the one that it is above as the step
// begins.
TEST(Contacts, WhereTheStepLeads) {
  const auto flown = [](double from, double speed) {
    Model model = searched({slab, moved(diamond, {from, 1.2})});
    ContactSearch search;
    model.blocks[1].velocity = {speed, -2, 0, 0, 0, 0};
    search.update(model, 0.1);
    return pairs_of(model);
  };
  EXPECT_FALSE(flown(4.5, 10).contains({1, 0}));  // beyond the slab's end before it is as low as its top
  EXPECT_TRUE(flown(5.5, -10).contains({1, 0}));
}

// The tip of a wedge close below another is under the upper face of that one too, but not in it.
TEST(Contacts, NotThroughTheFarSide) {
  const Model model = searched({{{-3, -0.22}, {1, -0.02}, {-3, -0.02}}, {{0, 0}, {4, 0}, {4, 0.2}}});
  EXPECT_EQ(pairs_of(model), (Pairs{{0, 1}, {1, 0}}));
  for (const Contact& c : model.contacts) EXPECT_NEAR(c.gap, 0.02, 1e-12);
}

// m, by which a convex polygon is in front of the best of the faces of another; negative: how deep the other is below
// all of them.
double before_a_face(const Polyline& polygon, const Polyline& other) {
  double most = -std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < other.size(); ++k) {
    const Vec2 along = (other[(k + 1) % other.size()] - other[k]).normalized();
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& p : polygon) least = std::min(least, cross(p - other[k], along));
    most = std::max(most, least);
  }
  return most;
}

// Two blocks that were apart at first, after a search where they overlap.
Model overlapping(const Polyline& a, const Polyline& b) {
  const Vec2 far(0, 100);
  Model model = searched({a, moved(b, far)});
  model.blocks[1].centroid -= far;
  model.place_vertices();
  ContactSearch search;
  search.update(model, 0);
  return model;
}

double deepest_contact(const Model& model) {
  double least = 0;
  for (const Contact& c : model.contacts) least = std::min(least, c.gap);
  return least;
}

// Two tips, each of which has its point beyond the far side of the other.
TEST(Contacts, TipsThatHaveGoneThroughEachOther) {
  const Polyline a = {{0, 0}, {4, 0.2}, {0, 0.4}}, b = {{3.98, 0.19}, {4.18, 4.19}, {3.78, 4.19}};
  const double depth = -std::max(before_a_face(a, b), before_a_face(b, a));
  ASSERT_GT(depth, 0.005);
  const Model model = overlapping(a, b);
  ASSERT_EQ(model.contacts.size(), 1u);
  EXPECT_NEAR(model.contacts[0].gap, -depth, 1e-12);
  EXPECT_NEAR(model.contacts[0].offset, depth, 1e-12);
}

// A tip that has gone right through the foot of an L, 0.2 thick, none of its own corners in it.
TEST(Contacts, TipThroughABlockThatIsNotConvex) {
  const Polyline l = {{0, 0}, {4, 0}, {4, 0.2}, {0.2, 0.2}, {0.2, 4}, {0, 4}}, tip = {{2, -0.05}, {2.05, 3}, {1.95, 3}};
  const Model model = overlapping(l, tip);
  ASSERT_EQ(model.contacts.size(), 1u);
  const Contact& c = model.contacts[0];
  EXPECT_EQ(std::make_tuple(c.i, c.vertex, c.j, c.edge), std::make_tuple(1, 0, 0, 2));
  EXPECT_NEAR(c.gap, -0.25, 1e-12);
}

// However convex blocks have come to lie in each other, one of their contacts knows of it.
TEST(Contacts, NoneOverlapWithoutAContact) {
  std::mt19937 random(7);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  const auto polygon = [&] {
    const int corners = 3 + int(between(0, 3));
    const double turn = between(0, 6.3), thin = between(0.05, 1);
    Polyline points;
    for (int k = 0; k < corners; ++k) {
      const double a = 6.283 * (k + between(-0.3, 0.3)) / corners;
      points.push_back(Eigen::Rotation2Dd(turn) * Vec2(std::cos(a), thin * std::sin(a)));
    }
    return points;
  };
  int pairs = 0;
  for (int n = 0; n < 4000; ++n) {
    const Polyline a = polygon(), b = moved(polygon(), {between(-2, 2), between(-2, 2)});
    const double depth = -std::max(before_a_face(a, b), before_a_face(b, a));
    const double size = std::sqrt(std::min(signed_area(a), signed_area(b)));
    if (depth < 0.002 * size || depth > 0.5 * size) continue;
    ++pairs;
    EXPECT_LT(deepest_contact(overlapping(a, b)), -0.49 * depth) << "pair " << n << ", depth " << depth / size;
  }
  EXPECT_GT(pairs, 500);
}

// A block in the notch of a U touches its floor and walls from within, not the outside of the walls.
TEST(Contacts, NonConvexBlocks) {
  const Polyline u = {{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Model model = searched({u, rectangle(1.01, 1.01, 1.98, 1)});
  std::set<int> edges;
  for (const Contact& c : model.contacts) {
    EXPECT_EQ(c.i, 1);  // no convex corner of the U is near
    EXPECT_EQ(c.kind, ContactKind::edge_edge);
    EXPECT_NEAR(c.gap, 0.01, 1e-13);
    edges.insert(c.edge);
  }
  EXPECT_EQ(edges, (std::set<int>{3, 4, 5}));
  EXPECT_EQ(model.contacts.size(), 6u);
}

// Nor does one beside it, whose walls are thinner than what presses on floor and wall may be under the wall.
TEST(Contacts, FloorEndsWithTheWallOnIt) {
  const Polyline bin = {{0, 0}, {4, 0}, {4, 3}, {3.9, 3}, {3.9, 1}, {0.1, 1}, {0.1, 3}, {0, 3}};
  for (const double y : {0.99, 1.0, 1.01}) {
    const Model model = searched({bin, rectangle(4.01, y, 1, 1)});
    EXPECT_GT(model.contacts.size(), 0u);
    for (const Contact& c : model.contacts) EXPECT_EQ(c.edge, c.j == 0 ? 1 : 3) << y;
  }
}

// Blocks round a corner of the boundary that points into the rock face each other, and hang together all the same.
TEST(Contacts, BondedBlocksRoundACornerHaveNone) {
  Region plate = test::meshed("plate", {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 0.4);
  plate.holes.resize(1);
  plate.holes[0].outline = {{0.4, 0.4}, {0.7, 0.4}, {0.55, 0.7}};
  Model model = build(scene_of({plate}));
  ContactSearch search;
  search.update(model, 0);
  EXPECT_TRUE(model.contacts.empty());
}

// A node in the flat side of a bonded plate is a corner of its blocks but none of the plate: a point below presses on
// edges, and no block rests with that "corner" on the point's slanting faces.
TEST(Contacts, ANodeOnAFlatSideIsNoCorner) {
  Model model = build(scene_of({test::patterned("plate", rectangle(0, 0, 4, 1), MeshKind::cross, 8, 2),
                                region("point", {{1, 0}, {0.7, -0.5}, {1.3, -0.5}})}));
  ContactSearch search;
  search.update(model, 0);
  ASSERT_EQ(model.contacts.size(), 2u);
  for (const Contact& c : model.contacts) {
    EXPECT_EQ(model.shapes[c.i].region, 1);
    EXPECT_EQ(model.shapes[c.j].region, 0);
  }
}

// In the inner corner of a slot a corner presses on the wall and on the bottom, however little it has entered the wall.
TEST(Contacts, InnerCornersHaveTwoFaces) {
  const Polyline fork = {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double into : {-1e-6, 0.0, 1e-6}) {
    const Model model = searched({fork, rectangle(1 - into, 1 + 1e-6, 0.9, 1.5)});
    int wall = 0, bottom = 0;
    for (const Contact& c : model.contacts) {
      if (c.i != 1 || c.vertex != 0) continue;
      wall += c.edge == 5;
      bottom += c.edge == 4;
    }
    EXPECT_EQ(wall, 1) << into;
    EXPECT_EQ(bottom, 1) << into;
  }
}

TEST(Contacts, BondedNeighboursHaveNone) {
  Model model = build(scene_of({test::meshed("plate", rectangle(0, 0, 3, 2), 0.5)}));
  ContactSearch search;
  search.update(model, 1);
  EXPECT_TRUE(model.contacts.empty());
  // A joint fails: its two blocks may touch, and at its ends nothing else does that hangs together round them.
  Joint& joint = *std::find_if(model.joints.begin(), model.joints.end(), [&](const Joint& j) {
    return distance_to_boundary(rectangle(0, 0, 3, 2), model.reference_place(j.a, j.in_a[0])) > 0.3 &&
           distance_to_boundary(rectangle(0, 0, 3, 2), model.reference_place(j.a, j.in_a[1])) > 0.3;
  });
  joint.state = JointState::failed;
  search.update(model, 0);
  ASSERT_FALSE(model.contacts.empty());
  for (const Contact& c : model.contacts) EXPECT_EQ(std::minmax(c.i, c.j), std::minmax(joint.a, joint.b));
  joint.state = JointState::intact;
  search.update(model, 0);
  EXPECT_TRUE(model.contacts.empty());
}

TEST(Contacts, CarryTheirStateOn) {
  Model model = searched({slab, rectangle(1, 0, 2, 1)});
  const auto load = [](Contact& c) {
    c.state = ContactState::stick;
    c.normal_force = 100;
    c.shear_force = 30;
    c.stretch = c.shear_force / c.shear_stiffness;
    c.slip = 0.2;
  };
  for (Contact& c : model.contacts) load(c);
  ContactSearch search;
  search.update(model, 0);
  ASSERT_EQ(model.contacts.size(), 2u);
  for (const Contact& c : model.contacts) {
    EXPECT_EQ(c.state, ContactState::stick);
    EXPECT_EQ(c.slip, 0.2);
    EXPECT_NEAR(c.stretch * c.shear_stiffness, 30, 1e-12);
  }
  EXPECT_TRUE(std::is_sorted(model.contacts.begin(), model.contacts.end(),
                             [](const Contact& a, const Contact& b) { return a.key() < b.key(); }));
}

// A corner that slides past a point in the middle of a straight face goes on with the next edge, loaded as it was.
TEST(Contacts, HandOverToTheNextEdge) {
  Model model = searched({{{-5, -1}, {5, -1}, {5, 0}, {0.31, 0}, {-5, 0}}, moved(diamond, {0.3, 1})});
  ASSERT_EQ(model.contacts.size(), 1u);
  Contact& before = model.contacts[0];
  const int edge = before.edge;
  before.state = ContactState::slip;
  before.shear_force = 30;
  before.stretch = 30 / before.shear_stiffness;
  before.slip = 0.2;
  model.blocks[1].centroid.x() += 0.02;
  model.place_vertices();
  ContactSearch search;
  search.update(model, 0);
  ASSERT_EQ(model.contacts.size(), 1u);
  const Contact& after = model.contacts[0];
  EXPECT_NE(after.edge, edge);
  EXPECT_EQ(after.state, ContactState::slip);
  EXPECT_EQ(after.slip, 0.2);
  EXPECT_NEAR(after.stretch * after.shear_stiffness, 30, 1e-12);
}

TEST(Contacts, MetAlreadyOverlappingIsNoLoad) {
  Model model = searched({slab, moved(diamond, {0.3, 2})});
  ASSERT_TRUE(model.contacts.empty());
  model.blocks[1].centroid.y() -= 1.02;
  model.place_vertices();
  ContactSearch search;
  search.update(model, 0);
  ASSERT_EQ(model.contacts.size(), 1u);
  EXPECT_NEAR(model.contacts[0].gap, -0.02, 1e-14);
  EXPECT_NEAR(model.contacts[0].offset, 0.02, 1e-14);
}

}  // namespace
}  // namespace talus
