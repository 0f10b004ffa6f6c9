#include "contact/detection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "contact/hand_over.h"
#include "contact/hidden.h"
#include "contact/meeting_points.h"
#include "contact/narrow_phase.h"
#include "model/groups.h"
#include "model/rates.h"
#include "model/sort_large.h"

namespace talus {

namespace {

constexpr double shorter = 0.99;  // part of the last step: the same but for rounding

std::span<const Vec2> reference_outline(const Model& model, int block) {
  return std::span(model.reference_vertex)
      .subspan(size_t(model.shapes[size_t(block)].vertex_begin), size_t(model.vertex_count(block)));
}

bool convex(std::span<const Vec2> corners) {
  for (size_t v = 0; v < corners.size(); ++v) {
    const Vec2 &next = corners[(v + 1) % corners.size()], &then = corners[(v + 2) % corners.size()];
    if (cross(next - corners[v], then - next) <= 0) return false;
  }
  return true;
}

// Adds the blocks that hang together round a corner through intact joints at that corner, but not those that
// face each other across an open joint that ends there.
void bond_corners(const Model& model, std::unordered_set<std::int64_t>& bonded) {
  const Nodes& nodes = model.nodes;
  const std::unordered_set<std::int64_t> by_edge = bonded;
  std::vector<int> group;
  for (size_t n = 0; n + 1 < nodes.begin.size(); ++n) {
    const int* blocks = &nodes.blocks[nodes.begin[n]];
    const int count = nodes.begin[n + 1] - nodes.begin[n];
    find_groups(
        count, [&](int k, int m) { return by_edge.contains(pair_key(blocks[k], blocks[m])); }, group);
    for (int k = 0; k < count; ++k)
      for (int m = 0; m < k; ++m)
        if (group[k] == group[m]) bonded.insert(pair_key(blocks[k], blocks[m]));
  }
  for (const auto& [pair, property] : model.pair_property) bonded.erase(pair);
  for (const Joint& joint : model.joints)
    if (joint.state == JointState::failed) bonded.erase(pair_key(joint.a, joint.b));
}

// Lends the blocks the mean velocities of a step that led to `ends`, if any.
class OnTheWay {
 public:
  OnTheWay(Model& model, const std::vector<BlockState>& ends, double dt) : model_(model) {
    if (ends.empty()) return;
    for (const int b : model.awake_blocks()) {
      BlockState& from = model.blocks[b];
      kept_.emplace_back(b, from.velocity);
      from.velocity = rates_of_way(model.shapes[b], from, ends[b], dt);
    }
  }
  OnTheWay(const OnTheWay&) = delete;
  OnTheWay& operator=(const OnTheWay&) = delete;
  ~OnTheWay() {
    for (const auto& [block, velocity] : kept_) model_.blocks[block].velocity = velocity;
  }

 private:
  Model& model_;
  std::vector<std::pair<int, Rates>> kept_;
};

}  // namespace

void ContactSearch::find_surface(const Model& model) {
  const int intact = int(std::count_if(model.joints.begin(), model.joints.end(),
                                       [](const Joint& joint) { return joint.state == JointState::intact; }));
  if (intact == intact_joints_) return;
  intact_joints_ = intact;
  surface_.free_edge.assign(model.reference_vertex.size(), 1);
  surface_.joint.assign(model.reference_vertex.size(), -1);
  surface_.bonded.clear();
  for (size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const bool holds = joint.state == JointState::intact;
    for (const int face :
         {model.shapes[joint.a].vertex_begin + joint.edge_a, model.shapes[joint.b].vertex_begin + joint.edge_b})
      for (int side = 0; side < joint.sides; ++side) {
        if (holds)
          surface_.free_edge[size_t(face + side)] = 0;
        else
          surface_.joint[size_t(face + side)] = int(j);
      }
    if (holds) surface_.bonded.insert(pair_key(joint.a, joint.b));
  }
  bond_corners(model, surface_.bonded);
  find_outlines(model);
  surface_blocks_.clear();
  const bool first = surface_.convex.empty();
  surface_.whole.clear();
  least_length_ = std::numeric_limits<double>::infinity();
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const auto edges =
        std::span(surface_.free_edge).subspan(size_t(model.shapes[b].vertex_begin), size_t(model.vertex_count(int(b))));
    const auto free = std::count(edges.begin(), edges.end(), 1);
    if (free > 0) surface_blocks_.push_back(int(b));
    if (first) {
      const std::span<const Vec2> outline = reference_outline(model, int(b));
      surface_.convex.push_back(convex(outline));
      if (!surface_.convex.back()) surface_.parts.emplace(int(b), convex_parts({outline.begin(), outline.end()}));
    }
    least_length_ = std::min(least_length_, model.shapes[b].length);
    surface_.whole.push_back(size_t(free) == edges.size());
  }
}

// Where a block ends in a bond, the outline goes on along the block beyond it, and so on round the corner to a free
// edge.
void ContactSearch::find_outlines(const Model& model) {
  std::unordered_map<int, OutlineEdge> beyond;  // by global edge
  for (const Joint& joint : model.joints) {
    if (joint.state != JointState::intact) continue;
    for (int side = 0; side < joint.sides; ++side) {
      const OutlineEdge of_a{joint.a, joint.edge_a + side}, of_b{joint.b, joint.facing(of_a.edge)};
      beyond[model.shapes[joint.a].vertex_begin + of_a.edge] = of_b;
      beyond[model.shapes[joint.b].vertex_begin + of_b.edge] = of_a;
    }
  }
  surface_.leaving.resize(model.reference_vertex.size());
  surface_.arriving.resize(model.reference_vertex.size());
  const auto previous = [&](int b, int v) { return v == 0 ? model.vertex_count(b) - 1 : v - 1; };
  for (int b = 0; b < int(model.shapes.size()); ++b)
    for (int v = 0; v < model.vertex_count(b); ++v) {
      OutlineEdge leaving{b, v}, arriving{b, previous(b, v)};
      const auto global = [&](const OutlineEdge& side) { return model.shapes[side.block].vertex_begin + side.edge; };
      // A corner inside a body is met again: it keeps its own edges, which touch nothing.
      for (auto next = beyond.find(global(leaving)); next != beyond.end(); next = beyond.find(global(leaving))) {
        leaving = {next->second.block, model.next_vertex(next->second.block, next->second.edge)};
        if (leaving.block == b) break;
      }
      for (auto last = beyond.find(global(arriving)); last != beyond.end(); last = beyond.find(global(arriving))) {
        arriving = {last->second.block, previous(last->second.block, last->second.edge)};
        if (arriving.block == b) break;
      }
      const size_t corner = size_t(model.shapes[b].vertex_begin + v);
      surface_.leaving[corner] = leaving;
      surface_.arriving[corner] = arriving;
    }
}

// Whether the last search found all there is: nothing moves, and places and step are the same to the last bit, and the
// same blocks sleep.
bool ContactSearch::unmoved(const Model& model, double dt) {
  if (std::ranges::any_of(model.awake_blocks(), [&model](int b) { return !stands_still(model, b); })) {
    forget_last();
    return false;
  }
  bool same = dt == seen_dt_;
  size_t count = 0;
  const auto see = [&](std::span<const double> now) {
    if (count + now.size() > seen_.size()) {
      same = false;
      seen_.resize(count + now.size());
    }
    double* const before = seen_.data() + count;
    same = same && std::equal(now.begin(), now.end(), before);
    std::copy(now.begin(), now.end(), before);
    count += now.size();
  };
  for (const int k : model.awake_blocks()) {
    const BlockState& b = model.blocks[k];
    see(std::array{b.shift.x(), b.shift.y(), b.angle, b.strain[0], b.strain[1], b.strain[2]});
    if (b.bend) see(*b.bend);
  }
  see(std::array{double(model.revision), double(model.sleep_changes)});
  same = same && count == seen_.size();
  seen_.resize(count);
  seen_dt_ = dt;
  return same;
}

std::vector<int> ContactSearch::awake(const Model& model) const {
  std::vector<int> awake;
  for (const int b : surface_blocks_)
    if (!model.sleeps(b)) awake.push_back(b);
  return awake;
}

std::vector<std::pair<int, int>> ContactSearch::near(const Model& model, const std::vector<BlockState>& states,
                                                     double dt) const {
  return NearBlocks().find(model, states, awake(model), dt);
}

void ContactSearch::update(Model& model, double dt, const std::vector<BlockState>& seen, bool cracked) {
  const int intact = intact_joints_;
  find_surface(model);
  if (model.time > time_) {
    last_dt_ = model.time - time_;
    time_ = model.time;
  }
  found_as_before_ = unmoved(model, dt) && intact == intact_joints_ && seen.empty();
  ended_ = 0;
  if (found_as_before_) {
    if (dt == 0) lie_as_pressed(model, dt);  // loads press harder on what stays where it is
    return;
  }
  std::vector<Contact> now;
  std::vector<MeetingCorners> meeting;
  {
    const OnTheWay lent(model, seen, dt);
    near_ = near_blocks_.find(model, model.blocks, awake(model), dt);
    faces_.find(model, surface_, near_);
    for (const auto& [a, b] : near_)
      if (!bonded(a, b)) find_contacts(model, surface_, faces_, a, b, dt, now, meeting);
  }
  if (!seen.empty()) forget_last();  // it was of other velocities
  drop_points(model, surface_, meeting, now);
  sort_large(now, [](const Contact& c) { return c.key(); });
  drop_hidden(model, surface_, faces_, now);
  ended_ = carry_over(model, dt, cracked, now);
  model.contacts.resize(size_t(model.sleeping_contacts));
  model.contacts.insert(model.contacts.end(), now.begin(), now.end());
  if (dt > 0 && dt < shorter * last_dt_) forgive_depth(model, dt);
  lie_as_pressed(model, dt);
}

}  // namespace talus
