#pragma once
// Two blocks that come near each other in a step: their corners, edges and the outlines of their bodies, as the narrow
// phase asks for them.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "contact/detection.h"
#include "contact/outline.h"

namespace talus {

// Corners that meet within this part of an edge's length count as on it: rounding, not geometry.
constexpr double corner_part = 1e-9;
// Corners within this part of the smaller block's √area are in one place: a node of a mesh that has been shaken.
constexpr double meeting_part = 1e-3;
// An edge–edge contact is as stiff as one of at least this part of the smaller block's √area: what touches with a
// hair's breadth now and slides on must not stay as soft as a hair.
constexpr double least_shared = 0.1;
constexpr double closed_crack = 1e-4;  // rad: less than rock strains open a crack by at its tip
constexpr double grazing_slope = 0.1;  // it moves along the face, not onto it
// What comes to the line of an edge farther than this beyond the edge's ends passes it by, in units of the smaller
// block's √area.
constexpr double beside_part = passing_tolerance;

// rad/s
inline double block_spin(const Model& model, int block) {
  return model.blocks[size_t(block)].velocity[2] / model.shapes[size_t(block)].length;
}

class NearPair {
 public:
  // way: m, of the pair past each other in the step, at most.
  NearPair(const Model& model, const Surface& surface, const Faces& faces, int i, int j, double way, double dt)
      : model_(model),
        surface_(surface),
        faces_(faces),
        i_(i),
        j_(j),
        dt_(dt),
        judged_(dt + judged_ahead(model.scene.numerics, dt)),
        least_(std::min(model.shapes[i].length, model.shapes[j].length)),
        flush_(largest_flush_distance(model, faces, i, j)),
        way_(way),
        reach_(search_margin * least_ + way),
        fast_(way > beside()),
        turn_(judged_ * (block_spin(model, i) - block_spin(model, j))) {}

  int i() const { return i_; }
  int j() const { return j_; }
  double reach() const { return reach_; }

  Vec2 vertex(int block, int local) const { return model_.vertex[model_.shapes[block].vertex_begin + local]; }
  int next(int block, int local) const { return model_.next_vertex(block, local); }
  int previous(int block, int local) const { return local == 0 ? model_.vertex_count(block) - 1 : local - 1; }
  const Face& edge(int block, int local) const { return faces_[global(block, local)]; }
  const Face& edge(const OutlineEdge& side) const { return edge(side.block, side.edge); }

  bool free(int block, int edge) const { return surface_.free_edge[model_.shapes[block].vertex_begin + edge]; }
  bool free(const OutlineEdge& side) const { return free(side.block, side.edge); }
  bool exposed(int block, int v) const { return free(block, v) || free(block, previous(block, v)); }
  // Or the block has no more than a corner where the outline of its body comes by.
  bool on_outline(int block, int v) const { return exposed(block, v) || free(arriving(block, v)); }

  // The sides of the outline that leave and reach the corner `v` of `block`, and their directions away from it, of the
  // whole body there: a node on the flat side of a mesh is no corner, though the block is.
  const OutlineEdge& leaving(int block, int v) const { return surface_.leaving[size_t(global(block, v))]; }
  const OutlineEdge& arriving(int block, int v) const { return surface_.arriving[size_t(global(block, v))]; }
  const OutlineCorner& corner(int block, int v) const { return faces_.corner(global(block, v)); }
  int global(int block, int v) const { return model_.shapes[block].vertex_begin + v; }

  // Whether the corner `v` of `block` can rest on a face of outward normal `n`: both sides of the body lead away, and
  // the body is on that side of them: sides in line lead away on either. In a valley they stand above it.
  bool can_rest(int block, int v, const Vec2& n) const {
    const Vec2 &a = corner(block, v).ahead, &b = corner(block, v).behind, out = perp(b - a);
    return a.dot(n) >= -parallel_sine && b.dot(n) >= -parallel_sine && out.dot(n) <= parallel_sine * out.norm() &&
           !valley(block, v);
  }
  // Or will, as the blocks turn: it is above the face now.
  bool will_rest(int block, int v, const Vec2& n) const {
    if (std::abs(turn_) < parallel_sine) return false;
    return can_rest(block, v, Eigen::Rotation2Dd(block == i_ ? -turn_ : turn_) * n);
  }

  Contact contact(int block_v, int v, int block_e, int e, double gap, bool corner) const {
    Contact c;
    c.i = block_v;
    c.vertex = v;
    c.j = block_e;
    c.edge = e;
    c.global_vertex = model_.shapes[block_v].vertex_begin + v;
    c.global_edge = model_.shapes[block_e].vertex_begin + e;
    c.gap = model_.curved(block_e) ? model_.curved_edge(block_e, e).foot(vertex(block_v, v)).gap : gap;
    const double shared = corner ? 0 : shared_length(block_v, v, block_e, e);
    c.kind = corner ? ContactKind::angle_angle : shared > 0 ? ContactKind::edge_edge : ContactKind::angle_edge;
    c.joint = corner ? -1 : joint_between(block_v, v, block_e, e);
    c.property = property_of(c);
    c.length = shared / 2;  // an edge–edge contact has two such pairs
    const JointProperty& property = model_.scene.properties[c.property];
    if (property.stiffness_kind == StiffnessKind::per_contact) {
      c.normal_stiffness = property.stiffness;
    } else {
      c.normal_stiffness = model_.stiffness_per_area(property, i_, j_) *
                           (shared > 0 ? std::max(shared, least_shared * least_) : least_) / 2;
      if (shared > 0) c.normal_stiffness *= simpson(block_v, v, block_e, e, shared);
    }
    c.shear_stiffness = c.normal_stiffness * property.shear_ratio;
    return c;
  }

  double deepest() const { return -0.25 * least_; }
  double least() const { return least_; }
  double meeting() const { return meeting_part * least_; }
  // Whether what is this far from a line of that normal, above or below, lies in it.
  bool flush(const Vec2& normal, double gap) const {
    const double far = std::abs(gap);
    return far <= flush_part * least_ || (far <= flush_ && far <= flush_distance(model_, faces_, i_, j_, normal));
  }
  double noise(int v) const { return 32 * std::numeric_limits<double>::epsilon() * model_.size_of(vertex(i_, v)); }
  double beside() const { return beside_part * least_; }
  bool fast() const { return fast_; }
  // Change of the place of corner `v` of `bv` on the block `be` until contacts are judged, at the present velocities,
  // m.
  Vec2 way(int bv, int v, int be) const {
    const Vec2 p = vertex(bv, v);
    return judged_ * (model_.velocity_at(bv, p) - model_.velocity_at(be, p));
  }
  // Whether corner `v` of `bv` is flush with edge `e` of `be`, at or beyond its ends, and stays so during the step.
  bool slides_on(int bv, int v, int be, int e) const {
    const Face& face = edge(be, e);
    const Vec2 p = vertex(bv, v);
    const Vec2 way = (model_.velocity_at(bv, p) - model_.velocity_at(be, p)) * dt_;
    const double approach = std::abs(face.normal.dot(way)), slide = std::abs(face.along.dot(way));
    if (approach > std::max(flush_part * least_, grazing_slope * slide) || !flush(face.normal, face.gap(p)))
      return false;
    if (!can_rest(bv, v, face.normal)) return false;
    return lies_along(corner(bv, v).ahead, face.normal) || lies_along(corner(bv, v).behind, face.normal);
  }

  // Whether corner `v` of `bv`, at the place `s` along edge `e` of `be`, passes its end flush with the face beyond it:
  // at an outer corner. At an inner one that face is a wall, and the corner slides down it onto the edge; at none it
  // lies on both.
  bool passes_flush(int bv, int v, int be, int e, double s, double length) const {
    // at the end of a crack that is the block's own side, or one that it is bonded to
    const auto on = [&](const OutlineEdge& beyond) {
      return free(beyond) && beyond.block != bv && !together(bv, beyond.block) &&
             slides_on(bv, v, beyond.block, beyond.edge);
    };
    const auto ends = [&](double before_end) { return before_end <= 0 || flush(edge(be, e).along, before_end); };
    return (ends(s) && on(arriving(be, e)) && outer(be, e)) ||
           (ends(length - s) && on(leaving(be, next(be, e))) && outer(be, next(be, e)));
  }

  static bool looks_away(const Face& far, const Face& face) { return far.normal.dot(face.normal) < -0.9; }

  bool loaded_before(std::int64_t key) const {  // Contact::key
    const std::span<const Contact> before = model_.awake_contacts();
    const auto same = std::lower_bound(before.begin(), before.end(), key,
                                       [](const Contact& old, std::int64_t sought) { return old.key() < sought; });
    return same != before.end() && same->key() == key && same->state != ContactState::open;
  }
  bool loaded_before(int bv, int v, int be, int e) const {
    return loaded_before(Contact::key(global(bv, v), global(be, e)));
  }

  // Whether a face of one block has all of the other so far in front of it that nothing meets. Of blocks as parts of
  // bodies, and where corners are met on their way, that does not say so.
  bool apart() const {
    if (fast() || !plain(i_) || !plain(j_)) return false;
    const auto before_a_face = [this](int block, int of) {
      for (int e = 0; e < model_.vertex_count(of); ++e) {
        const Face& face = edge(of, e);
        int v = 0;
        while (v < model_.vertex_count(block) && face.gap(vertex(block, v)) > reach_) ++v;
        if (v == model_.vertex_count(block)) return true;
      }
      return false;
    };
    return before_a_face(i_, j_) || before_a_face(j_, i_);
  }

  // m, from a face of `block` outwards: what is farther in front of one than this comes to none of them. What is on a
  // face, or beyond its end by what counts as on it, is in front of no other face of a convex block by more than of
  // that one and as much again.
  double out_of_reach(int block) const {
    return fast() || !plain(block) ? std::numeric_limits<double>::infinity()
                                   : reach_ + slack(0, -deepest()) + meeting();
  }

  bool plain(int block) const { return surface_.whole[size_t(block)] && surface_.convex[size_t(block)]; }
  bool together(int a, int b) const { return surface_.together(a, b); }
  const std::vector<ConvexPart>* parts_of(int block) const { return surface_.parts_of(block); }

  // Whether the outline turns inwards at corner `v` of `block`; outwards. Inwards also by little, where what goes by
  // would come to lie under the face beyond.
  bool inner(int block, int v) const {
    const double turn = corner(block, v).turn;
    return (turn < -parallel_sine || -turn * way_ > level_part * least_ || notch(block, v) || valley(block, v)) &&
           !smooth(block, v);
  }
  // and no other of its body
  bool own(int block, int v) const { return leaving(block, v).block == block && arriving(block, v).block == block; }
  bool notch(int block, int v) const {
    return own(block, v) && corner(block, v).turn < -closed_crack &&
           corner(block, v).ahead.dot(corner(block, v).behind) > 0;
  }
  // By however little, where it is more than what lies on its sides is pressed in. Of a block of its own: a body's
  // sides bend as it deforms.
  bool valley(int block, int v) const {
    const OutlineCorner& at = corner(block, v);
    return at.turn < 0 && own(block, v) && -at.turn * at.shorter > level_part * least_ && !smooth(block, v);
  }
  // Whether a side that bends goes on there, whatever the angle between its chords: of what is quadratic the parts of a
  // straight side share their tangents.
  bool smooth(int block, int v) const {
    if (!model_.curved(block)) return false;
    const auto at = [&](int local) { return model_.reference_vertex[size_t(global(block, local))]; };
    const Vec2 behind = at(v) - at(previous(block, v)), ahead = at(next(block, v)) - at(v);
    return std::abs(cross(behind, ahead)) <= corner_part * behind.norm() * ahead.norm() && behind.dot(ahead) > 0;
  }
  // Whether a side of the block goes straight on there, as near as two faces count as along each other.
  bool straight(int block, int v) const {
    const OutlineCorner& at = corner(block, v);
    return own(block, v) && (smooth(block, v) ||
                             (std::abs(at.turn) <= parallel_sine && at.ahead.dot(at.behind) < 0 && !valley(block, v)));
  }
  // Whether a side of the block turns outwards into the next at a corner, `e` part of the one and `f` of the other.
  bool turns_into(int block, int e, int f) const {
    int corner = next(block, e);
    while (straight(block, corner) && corner != e) corner = next(block, corner);
    if (straight(block, corner) || !convex(block, corner)) return false;
    int part = corner;
    while (part != f && straight(block, next(block, part))) part = next(block, part);
    return part == f;
  }
  bool outer(int block, int v) const { return corner(block, v).turn > parallel_sine; }
  bool convex(int block, int v) const { return corner(block, v).turn > 0; }

  // Whether a corner at the place `s` along edge `e` of `be` is on it. At an inner corner the edge goes on under the
  // wall, where a corner that presses on both is, and ends where the wall does: what falls past a thin one outside is
  // not held by the floor inside.
  bool within(int be, int e, double s, double length) const { return within(be, e, s, length, corner_part * length); }
  bool within(int be, int e, double s, double length, double slack) const {
    const auto in_wall = [&](int v, double beyond, const OutlineEdge& wall) {
      return beyond < under_wall(be, v) && inner(be, v) &&
             !behind(wall.block, wall.edge, edge(wall), edge(be, e).at(s));
    };
    if (s < -slack) return in_wall(e, -s, arriving(be, e));
    if (s > length + slack) return in_wall(next(be, e), s - length, leaving(be, next(be, e)));
    return true;
  }
  // m, by which what presses `deep` may have come beyond the end of an edge and still be on it: shear that goes over
  // from one of two corners that press on each other to the other moves them by the square of that.
  double slack(double length, double deep) const { return corner_part * length + deep * deep / least_; }
  // Sine by which the side of corner `v` of `block` that lies along that normal's face is aslant to it; 0 where none
  // does.
  double aslant(int block, int v, const Vec2& n) const {
    const double a = std::abs(corner(block, v).ahead.dot(n)), b = std::abs(corner(block, v).behind.dot(n)),
                 least = std::min(a, b);
    return least <= parallel_sine ? least : 0;
  }
  // m, of the sides at corner `v` that lies along a face, which goes on by so much at its ends.
  double overlap(int block, int v, const Face& face, double before, double beyond) const {
    const Vec2 p = vertex(block, v);
    const auto on_face = [&](const Vec2& q) { return std::clamp(face.position(q), -before, face.length + beyond); };
    double forwards = 0, backwards = 0;
    for (int other : {next(block, v), previous(block, v)}) {
      const Vec2 q = vertex(block, other);
      if (std::abs(face.normal.dot(q - p)) > parallel_sine * (q - p).norm()) continue;
      const double along = on_face(q) - on_face(p);
      if (std::abs(along) > corner_part * face.length)
        forwards = std::max(forwards, along), backwards = std::max(backwards, -along);
    }
    return forwards + backwards;
  }
  // m, by which an edge goes on under the wall at an inner corner; what lies in a shallow one is out of both edges by
  // the sine of its depth.
  double under_wall(int block, int v) const {
    return corner(block, v).turn < -parallel_sine || notch(block, v) ? -deepest() : std::max(way_, meeting());
  }

  // Whether the block `be` has another side between its face at `e` and a corner at `p` below it: what the corner is
  // away from the face is no depth then. Also where the corner is on that side, if it looks away from the face; one
  // that stands up from it ends there.
  bool behind(int be, int e, const Face& face, const Vec2& p) const {
    const Vec2 foot = p - face.gap(p) * face.normal;
    const auto across_a_notch = [&](int f) {  // under the face the block goes on there
      return (f == next(be, e) && !convex(be, f)) || (next(be, f) == e && !convex(be, e));
    };
    for (int f = 0; f < model_.vertex_count(be); ++f) {
      if (f == e || !free(be, f) || across_a_notch(f)) continue;
      const Face& far = edge(be, f);
      const double from = far.gap(foot), to = far.gap(p);
      if (from > meeting() || to <= (looks_away(far, face) ? -meeting() : meeting()) || to <= from) continue;
      const double s = far.position(foot + std::max(0.0, from / (from - to)) * (p - foot));
      if (s >= -beside() && s <= far.length + beside()) return true;
    }
    return false;
  }

 private:
  // The face of a trace keeps its property where blocks of its region slide on, past those that lay against it at
  // first.
  int property_of(const Contact& c) const {
    if (c.joint >= 0) return model_.joints[c.joint].property;
    const int face = surface_.joint[c.global_edge];
    const bool traced =
        face >= 0 && model_.joints[face].trace >= 0 && model_.shapes[c.i].region == model_.shapes[c.j].region;
    return traced ? model_.joints[face].property : model_.contact_property(c.i, c.j);
  }
  // The open joint one of whose sides is edge `e` of `of`, with one across it that ends in corner `v` of `block`; or
  // -1.
  int joint_between(int block, int v, int of, int e) const {
    const int j = surface_.joint[size_t(global(of, e))];
    if (j < 0) return -1;
    const Joint& joint = model_.joints[size_t(j)];
    if (joint.a != block && joint.b != block) return -1;
    const int across = joint.facing(e);
    return across == v || next(block, across) == v ? j : -1;
  }
  static bool lies_along(const Vec2& d, const Vec2& n) { return std::abs(d.dot(n)) <= parallel_sine; }  // unit vectors

  // By how much the spring of a corner of a side that bends is stiffer than by its share of it: one of an even pressure
  // is pressed in evenly where springs are as Simpson's weights, the work that such pressure does (theory, § 1). Sides
  // have an even number of parts, and every other corner is the middle of two. Where all that lies along the corner's
  // sides is the face, and has no corners there or the same ones; else by its share.
  double simpson(int block_v, int v, int block_e, int e, double shared) const {
    if (!model_.curved(block_v)) return 1;
    double own = 0;
    for (const int side : {v, previous(block_v, v)})
      if (std::abs(cross(edge(block_v, side).along, edge(block_e, e).along)) <= parallel_sine)
        own += edge(block_v, side).length;
    if (std::abs(shared - own) > 2 * meeting()) return 1;
    const auto meets = [&](int w) { return (vertex(block_v, v) - vertex(block_e, w)).norm() <= 2 * meeting(); };
    if (model_.curved(block_e) && !(meets(e) && v % 2 == e % 2) &&
        !(meets(next(block_e, e)) && v % 2 == next(block_e, e) % 2))
      return 1;
    return v % 2 == 0 ? 2.0 / 3 : 4.0 / 3;
  }
  // m, of the edges at corner `v` that lies along `e`, or 0; at an end where that goes straight on, along what it goes
  // on in too. Halves of the shares of all corners on a face add up to it, as weights of the trapezoidal rule.
  double shared_length(int block, int v, int be, int e) const {
    const Face& face = edge(be, e);
    const double at = face.position(vertex(block, v));
    const double before = std::abs(at) <= meeting() && straight(be, e) ? edge(be, previous(be, e)).length : 0;
    const double beyond =
        std::abs(at - face.length) <= meeting() && straight(be, next(be, e)) ? edge(be, next(be, e)).length : 0;
    return overlap(block, v, face, before, beyond);
  }

  const Model& model_;
  const Surface& surface_;
  const Faces& faces_;
  int i_, j_;
  // s, s, m, m, m, m; judged_: from the start to the places that contacts are judged at
  double dt_, judged_, least_, flush_, way_, reach_;
  bool fast_;    // may pass an edge by in the step
  double turn_;  // rad, of i as seen from j until contacts are judged
};

}  // namespace talus
