#include "step/overlooked.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/outline.h"
#include "contact/way_out.h"
#include "geometry/polygon.h"
#include "model/rates.h"
#include "model/tensor_norms.h"

namespace talus {

namespace {

using BlockPair = std::pair<int, int>;

// Where bodies are looked at: as the step begins, as it ends, and where contacts are judged, y.
enum Place { before, after, judged, places };

// Of the depth that contacts press to in a step: what begins to press by less moves nothing, wherever it touches.
constexpr double unfelt = 1e-4;

class Hindsight {
 public:
  Hindsight(const Model& model, const ContactSearch& search, const std::vector<BlockState>& moved, double dt,
            double deepest, double unasked)
      : model_(model),
        search_(search),
        moved_(moved),
        dt_(dt),
        deepest_(deepest),
        unasked_(unasked),
        ahead_(judged_ahead(model.scene.numerics, dt)) {
    for (const BlockPair& pair : search.near()) add(pair);
    if (thrown()) {
      for (const BlockPair& pair : near_on_the_way()) add(pair);
      std::sort(pairs_.begin(), pairs_.end());
      pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    }
    if (pairs_.empty()) return;
    asked_.assign(pairs_.size(), 0);
    known_.assign(pairs_.size(), 0);
    outlines_.resize(model.shapes.size());
  }
  bool any() const { return !pairs_.empty(); }

  std::optional<BlockPair> presses_apart(const ContactTerms& contacts, const Vector& d) {
    double most = 0;
    for (const ContactRows& row : contacts.rows()) most = std::max(most, -contacts.gap(row, d));
    for (const ContactRows& row : contacts.rows()) {
      const auto at = std::lower_bound(pairs_.begin(), pairs_.end(), BlockPair(std::minmax(row.i, row.j)));
      if (at == pairs_.end() || *at != BlockPair(std::minmax(row.i, row.j))) continue;
      const Contact& contact = model_.contacts[row.contact];
      asked_[size_t(at - pairs_.begin())] = 1;
      const double pressed = -contacts.gap(row, d);
      if (pressed <= 0) continue;
      double& known = known_[at - pairs_.begin()];
      known = std::max(known, pressed + contact.offset);
      if (pressed > unfelt * most && contact.normal_force <= 0 && !touches(contact, before) &&
          !touches(contact, judged))
        return *at;
    }
    return {};
  }

  // After presses_apart().
  std::optional<BlockPair> overlaps() {
    for (size_t k = 0; k < pairs_.size(); ++k) {
      const auto [a, b] = pairs_[k];
      for (const auto& [corners, block] : {BlockPair(a, b), BlockPair(b, a)})
        if (comes_in(corners, block, known_[k]) || goes_through(corners, block, known_[k])) return pairs_[k];
      if (crosses(a, b, known_[k], asked_[k])) return pairs_[k];
    }
    return {};
  }

 private:
  // m, that blocks may lie in each other: and as far as edges that contacts follow as they bend go off the lines
  // between their corners, which are asked here.
  double tolerance(int a, int b, bool asked = true) const {
    return (asked ? deepest_ : unasked_) * std::min(model_.shapes[a].length, model_.shapes[b].length) +
           model_.largest_rise(a, moved_[a]) + model_.largest_rise(b, moved_[b]);
  }

  // m, by which turning and straining moves what is in the block.
  double turning(int block) const {
    const BlockState &from = model_.blocks[block], &to = moved_[block];
    return model_.shapes[block].radius * (std::abs(to.angle - from.angle) + tensor_norm(to.strain - from.strain));
  }
  // What does not move past each other farther than may go wrong has nothing to be looked at.
  void add(const BlockPair& pair) {
    const auto [a, b] = pair;
    const Vec2 past = moved_[a].shift - model_.blocks[a].shift - (moved_[b].shift - model_.blocks[b].shift);
    if (past.norm() + turning(a) + turning(b) > tolerance(a, b, false) && !search_.bonded(a, b)) pairs_.push_back(pair);
  }
  // Whether something was hit so hard that the search could not foresee where to.
  bool thrown() const {
    for (const int b : model_.awake_blocks()) {
      const BlockState &from = model_.blocks[b], &to = moved_[b];
      const BlockShape& shape = model_.shapes[b];
      const Vec2 off = to.shift - from.shift - dt_ * Vec2(from.velocity[0], from.velocity[1]);
      const double turn = to.angle - from.angle - dt_ * from.velocity[2] / shape.length;
      if (off.norm() + shape.radius * std::abs(turn) > search_margin * shape.length) return true;
    }
    return false;
  }

  std::vector<BlockPair> near_on_the_way() const {
    if (dt_ > 0) return search_.near(model_, moved_, dt_ + ahead_);
    std::vector<BlockState> ways = moved_;  // of a static solve, as if they took a second
    for (const int b : model_.awake_blocks())
      ways[b].velocity = rates_of_way(model_.shapes[b], model_.blocks[b], moved_[b], 1);
    return search_.near(model_, ways, 1);
  }

  struct Outline {
    Polyline corners;
    Bounds box;
  };
  const Outline& outline(int block, Place place) {
    Outline& outline = outlines_[block][place];
    if (!outline.corners.empty()) return outline;
    const BlockShape& shape = model_.shapes[block];
    const BlockState state = place == before ? model_.blocks[block] : state_ahead(block, place == judged ? ahead_ : 0);
    const Rotation rotation = Rotation::of(state.angle);
    outline.corners.reserve(size_t(model_.vertex_count(block)));
    for (int k = shape.vertex_begin; k < shape.vertex_end; ++k)
      outline.corners.push_back(model_.vertex_at(block, state, rotation, k));
    outline.box = bounds(outline.corners);
    return outline;
  }
  // Whether the circles round two blocks do not meet; those of second order have none.
  bool far(int a, int b, Place place) const {
    if (model_.shapes[a].second_order() || model_.shapes[b].second_order()) return false;
    const double time = place == judged ? ahead_ : 0;
    const auto centre = [&](const BlockState& state) {
      return Vec2(state.centroid + time * Vec2(state.velocity[0], state.velocity[1]));
    };
    const auto radius = [&](int block) {
      const BlockState& state = moved_[block];
      const Vec3 rate(state.velocity[3], state.velocity[4], state.velocity[5]);
      return model_.shapes[block].radius *
             (1 + tensor_norm(state.strain) + time / model_.shapes[block].length * tensor_norm(rate));
    };
    return (centre(moved_[a]) - centre(moved_[b])).norm() > radius(a) + radius(b);
  }
  // After the step and `time` more, at the velocities it ends with.
  BlockState state_ahead(int block, double time) const {
    const BlockShape& shape = model_.shapes[block];
    BlockState state = moved_[block];
    const auto& v = state.velocity;
    state.centroid += time * Vec2(v[0], v[1]);
    state.angle += time * v[2] / shape.length;
    state.strain += time / shape.length * Vec3(v[3], v[4], v[5]);
    for (size_t k = 0; state.bend && k < state.bend->size(); ++k) (*state.bend)[k] += time * v[first_order_dofs + k];
    return state;
  }

  struct Met {
    Vec2 at, from, to;  // the vertex; the edge's ends
    double gap, position, length;
  };
  Met met(const Contact& c, Place place) {
    const Polyline& edges = outline(c.j, place).corners;
    const Vec2 at = outline(c.i, place).corners[c.vertex], from = edges[c.edge],
               to = edges[model_.next_vertex(c.j, c.edge)];
    const double length = (to - from).norm();
    const Vec2 along = (to - from) / length;
    return {at, from, to, cross(at - from, along), along.dot(at - from), length};
  }

  // Whether the vertex and the edge of the contact are in one place: the vertex on the edge, or the edge's end on one
  // of the vertex's own edges.
  bool touches(const Contact& c, Place place) {
    const double near = tolerance(c.i, c.j);
    const Met side = met(c, place);
    if (side.gap <= near && side.position >= -near && side.position <= side.length + near) return true;
    const Polyline& corners = outline(c.i, place).corners;
    const size_t last = (size_t(c.vertex) + corners.size() - 1) % corners.size();
    for (const Vec2& end : {side.from, side.to})
      for (const Vec2& beside : {corners[last], corners[model_.next_vertex(c.i, c.vertex)]})
        if (distance_to_segment(side.at, beside, end) <= near) return true;
    return false;
  }

  // m, of a point below the surface of the body whose block it is in, or 0.
  double depth(const Vec2& point, int block, Place place) {
    const auto& [corners, box] = outline(block, place);
    if ((point.array() < box.min.array()).any() || (point.array() > box.max.array()).any() || !contains(corners, point))
      return 0;
    const Surface& surface = search_.surface();
    const talus::Outline sides(model_, surface);
    double least = model_.shapes[block].length;
    for (int k = 0; k < int(corners.size()); ++k) {
      const int corner = model_.shapes[block].vertex_begin + k;
      for (const OutlineEdge& side : {sides.leaving(corner), sides.arriving(corner)}) {
        if (!surface.free_edge[size_t(sides.first(side))]) continue;
        const Polyline& of = outline(side.block, place).corners;
        least =
            std::min(least, distance_to_segment(of[side.edge], of[model_.next_vertex(side.block, side.edge)], point));
      }
    }
    return least;
  }
  // Carries points as a block carried them in the step: affinely, but for what is of second order.
  struct Carried {
    Vec2 from, to;
    Eigen::Matrix2d by;
    Vec2 operator()(const Vec2& point) const { return to + by * (point - from); }
  };
  Carried carried(int block) {
    const Polyline &then = outline(block, before).corners, &now = outline(block, after).corners;
    size_t third = 2;  // the farthest from the line through the first two
    const auto area = [&](size_t k) { return std::abs(cross(then[1] - then[0], then[k] - then[0])); };
    for (size_t k = 3; k < then.size(); ++k)
      if (area(k) > area(third)) third = k;
    Eigen::Matrix2d sides, moved;
    sides << then[1] - then[0], then[third] - then[0];
    moved << now[1] - now[0], now[third] - now[0];
    return {then[0], now[0], moved * sides.inverse()};
  }
  // m, below the face by which a corner came into a block that it left again in the step, on this way in the block's
  // own frame: through a thin tip. What passes a corner of the block nearer than `allowed` passes it by.
  double gone_through(const Vec2& start, const Vec2& end, int block, double allowed) {
    const auto& [corners, box] = outline(block, after);
    if ((start.array().max(end.array()) < box.min.array()).any() ||
        (start.array().min(end.array()) > box.max.array()).any())
      return 0;
    if (contains(corners, start) || contains(corners, end)) return 0;
    const Vec2 way = end - start;
    double first = 1, below = 0;  // part of the way
    for (int k = 0; k < int(corners.size()); ++k) {
      const Vec2 side = corners[model_.next_vertex(block, k)] - corners[k], off = corners[k] - start;
      const double both = cross(way, side);
      if (both == 0) continue;
      const double part = cross(off, side) / both, along = cross(off, way) / both;
      if (part < 0 || part >= first || along < 0 || along > 1) continue;
      first = part;
      const bool by = std::min(along, 1 - along) * side.norm() <= allowed;
      below = by || !search_.surface().free_edge[model_.shapes[block].vertex_begin + k]
                  ? 0
                  : cross(side, end - corners[k]) / side.norm();
    }
    return below;
  }
  // Whether a corner of `a` has come into `b` farther than `known`.
  bool comes_in(int a, int b, double known) {
    for (const Place place : {after, judged}) {
      if (far(a, b, place)) continue;
      const Polyline &then = outline(a, before).corners, &corners = outline(a, place).corners;
      for (size_t v = 0; v < corners.size(); ++v) {
        const double come = depth(corners[v], b, place) - tolerance(a, b);
        if (come > known && come > depth(then[v], b, before)) return true;
      }
    }
    return false;
  }
  // Whether a corner of `a` has gone right through `b`, and lies farther below the face by which it came.
  bool goes_through(int a, int b, double known) {
    if (far(a, b, after)) return false;
    const Polyline &then = outline(a, before).corners, &corners = outline(a, after).corners;
    const double allowed = tolerance(a, b);
    const Carried with = carried(b);
    for (size_t v = 0; v < corners.size(); ++v)
      if (gone_through(with(then[v]), corners[v], b, allowed) > known + allowed) return true;
    return false;
  }

  // m, that two blocks lie in each other, or 0 where it is no more than `enough` or where their bodies hide the way
  // out.
  double lie_in(int a, int b, Place place, double enough) {
    const std::array blocks{a, b};
    const std::array<const Polyline*, 2> outlines{&outline(a, place).corners, &outline(b, place).corners};
    const auto out =
        way_out({search_.surface().parts_of(a), search_.surface().parts_of(b)},
                {model_.vertex_count(a), model_.vertex_count(b)}, enough,
                [&](int of, int corner) -> const Vec2& { return (*outlines[size_t(of)])[size_t(corner)]; });
    if (!out ||
        !search_.surface().free_edge[size_t(model_.shapes[size_t(blocks[size_t(out->of)])].vertex_begin + out->face)])
      return 0;
    return -out->gap;
  }
  // Whether two blocks have come into each other, be it with all of their corners outside, as tips that cross.
  bool crosses(int a, int b, double known, bool asked) {
    const double enough = known + tolerance(a, b, asked);
    for (const Place place : {after, judged}) {
      if (far(a, b, place)) continue;
      const double now = lie_in(a, b, place, enough);
      if (now > 0 && now > lie_in(a, b, before, enough)) return true;
    }
    return false;
  }

  const Model& model_;
  const ContactSearch& search_;
  const std::vector<BlockState>& moved_;
  double dt_, deepest_, unasked_;  // s, of the step; part of √area, also of pairs without a contact
  double ahead_;                   // s, from its end to y
  std::vector<BlockPair> pairs_;   // that move past each other, sorted
  std::vector<char> asked_;        // per pair: whether it has a contact, open or not
  std::vector<double> known_;      // m, per pair: depth of the deepest of its contacts that press, as they know it
  std::vector<std::array<Outline, places>> outlines_;  // per block, those that have been asked for
};

}  // namespace

std::optional<std::pair<int, int>> overlooked(const Model& model, const ContactSearch& search,
                                              const ContactTerms& contacts, const Vector& d,
                                              const std::vector<BlockState>& moved, double dt, double displacement,
                                              double deepest, double unasked) {
  if (2 * displacement <= unasked * search.least_length()) return {};
  Hindsight hindsight(model, search, moved, dt, deepest, unasked);
  if (!hindsight.any()) return {};
  const auto apart = hindsight.presses_apart(contacts, d);
  return apart ? apart : hindsight.overlaps();
}

}  // namespace talus
