#include "contact/narrow_phase.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "contact/detection.h"
#include "contact/outline.h"
#include "contact/way_out.h"

namespace talus {

namespace {

// Corners that meet within this part of an edge's length count as on it: rounding, not geometry.
constexpr double corner_part = 1e-9;
// Corners within this part of the smaller block's √area are in one place: a node of a mesh that has been shaken.
constexpr double meeting_part = 1e-3;
// An edge–edge contact is as stiff as one of at least this part of the smaller block's √area: what touches with a hair's
// breadth now and slides on must not stay as soft as a hair.
constexpr double least_shared = 0.1;
constexpr double grazing_slope = 0.1;  // it moves along the face, not onto it
// What comes to the line of an edge farther than this beyond the edge's ends passes it by, in units of the smaller block's √area.
constexpr double beside_part = passing_tolerance;
// A contact that is less deep than this part of what blocks lie in each other does not stand for that.
constexpr double known_part = 0.5;

double spin(const Model& model, int block) { return model.blocks[block].velocity[2] / model.shapes[block].length; }  // rad/s

class Pair {
 public:
  // way: m, of the pair past each other in the step, at most.
  Pair(const Model& model, const Surface& surface, const Faces& faces, int i, int j, double way, double dt)
      : model_(model),
        surface_(surface),
        outline_(model, surface),
        faces_(faces),
        i_(i),
        j_(j),
        dt_(dt),
        judged_(dt + judged_ahead(model.scene.numerics, dt)),
        least_(std::min(model.shapes[i].length, model.shapes[j].length)),
        way_(way),
        reach_(search_margin * least_ + way),
        fast_(way > beside()),
        turn_(judged_ * (spin(model, i) - spin(model, j))) {}

  int i() const { return i_; }
  int j() const { return j_; }
  double reach() const { return reach_; }

  Vec2 vertex(int block, int local) const { return model_.vertex[model_.shapes[block].vertex_begin + local]; }
  int next(int block, int local) const { return model_.next_vertex(block, local); }
  int previous(int block, int local) const { return local == 0 ? model_.vertex_count(block) - 1 : local - 1; }
  const Face& edge(int block, int local) const { return faces_[global(block, local)]; }

  bool free(int block, int edge) const { return surface_.free_edge[model_.shapes[block].vertex_begin + edge]; }
  bool free(const OutlineEdge& side) const { return free(side.block, side.edge); }
  bool exposed(int block, int v) const { return free(block, v) || free(block, previous(block, v)); }
  // Or the block has no more than a corner where the outline of its body comes by.
  bool on_outline(int block, int v) const { return exposed(block, v) || free(arriving(block, v)); }

  // The sides of the outline that leave and reach the corner `v` of `block`, and their directions away from it, of the whole body there: a node
  // on the flat side of a mesh is no corner, though the block is.
  const OutlineEdge& leaving(int block, int v) const { return outline_.leaving(global(block, v)); }
  const OutlineEdge& arriving(int block, int v) const { return outline_.arriving(global(block, v)); }
  Vec2 ahead(int block, int v) const { return outline_.ahead(global(block, v)); }
  Vec2 behind(int block, int v) const { return outline_.behind(global(block, v)); }
  int global(int block, int v) const { return model_.shapes[block].vertex_begin + v; }

  // Whether the corner `v` of `block` can rest on a face of outward normal `n`: both sides of the body lead away, and the body is on that side of them:
  // sides in line lead away on either.
  bool can_rest(int block, int v, const Vec2& n) const {
    const Vec2 a = ahead(block, v).normalized(), b = behind(block, v).normalized(), out = perp(b - a);
    return a.dot(n) >= -parallel_sine && b.dot(n) >= -parallel_sine && out.dot(n) <= parallel_sine * out.norm();
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
    c.gap = gap;
    const double shared = corner ? 0 : shared_length(block_v, v, edge(block_e, e));
    c.kind = corner ? ContactKind::angle_angle : shared > 0 ? ContactKind::edge_edge : ContactKind::angle_edge;
    c.joint = corner ? -1 : joint_between(block_v, v, c.global_edge);
    c.property = property_of(c);
    c.length = shared / 2;  // an edge–edge contact has two such pairs
    const JointProperty& property = model_.scene.properties[c.property];
    if (property.stiffness_kind == StiffnessKind::per_contact) {
      c.normal_stiffness = property.stiffness;
    } else {
      c.normal_stiffness = model_.stiffness_per_area(property, i_, j_) * (shared > 0 ? std::max(shared, least_shared * least_) : least_) / 2;
    }
    c.shear_stiffness = c.normal_stiffness * property.shear_ratio;
    return c;
  }

  double deepest() const { return -0.25 * least_; }
  double least() const { return least_; }
  double meeting() const { return meeting_part * least_; }
  double flush() const { return flush_part * least_; }
  double noise(int v) const { return 32 * std::numeric_limits<double>::epsilon() * model_.size_of(vertex(i_, v)); }
  double beside() const { return beside_part * least_; }
  bool fast() const { return fast_; }
  // Change of the place of corner `v` of `bv` on the block `be` until contacts are judged, at the present velocities, m.
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
    if (std::abs(face.gap(p)) > flush() || approach > std::max(flush(), grazing_slope * slide)) return false;
    if (!can_rest(bv, v, face.normal)) return false;
    return lies_along(ahead(bv, v), face.normal) || lies_along(behind(bv, v), face.normal);
  }

  // Whether corner `v` of `bv`, at the place `s` along edge `e` of `be`, passes its end flush with the face beyond it: at
  // an outer corner. At an inner one that face is a wall, and the corner slides down it onto the edge; at none it lies on both.
  bool passes_flush(int bv, int v, int be, int e, double s, double length) const {
    const auto on = [&](const OutlineEdge& beyond) {  // at the end of a crack that is the block's own side, or one that it is bonded to
      return free(beyond) && beyond.block != bv && !together(bv, beyond.block) && slides_on(bv, v, beyond.block, beyond.edge);
    };
    return (s <= flush() && on(arriving(be, e)) && outer(be, e)) ||
           (s >= length - flush() && on(leaving(be, next(be, e))) && outer(be, next(be, e)));
  }

  // Whether a face of one block has all of the other so far in front of it that nothing meets. Of blocks as parts of bodies, and where corners
  // are met on their way, that does not say so.
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

  bool plain(int block) const { return surface_.whole[size_t(block)] && surface_.convex[size_t(block)]; }
  bool together(int a, int b) const { return surface_.together(a, b); }
  bool both_convex() const { return surface_.convex[size_t(i_)] && surface_.convex[size_t(j_)]; }

  // Whether the outline turns inwards at corner `v` of `block`; outwards. Inwards also by little, where what goes by would come to lie under the face beyond.
  bool inner(int block, int v) const {
    const double turn = outline_.turn(global(block, v));
    return turn < -parallel_sine || -turn * way_ > climbed_part * least_;
  }
  bool outer(int block, int v) const { return outline_.turn(global(block, v)) > parallel_sine; }
  bool convex(int block, int v) const { return outline_.turn(global(block, v)) > 0; }

  // Whether a corner at the place `s` along edge `e` of `be` is on it. At an inner corner the edge goes on under the
  // wall, where a corner that presses on both is.
  bool within(int be, int e, double s, double length) const { return within(be, e, s, length, corner_part * length); }
  bool within(int be, int e, double s, double length, double slack) const {
    if (s < -slack) return -s < under_wall(be, e) && inner(be, e);
    if (s > length + slack) return s - length < under_wall(be, next(be, e)) && inner(be, next(be, e));
    return true;
  }
  // m, by which an edge goes on under the wall at an inner corner.
  double under_wall(int block, int v) const { return outline_.turn(global(block, v)) < -parallel_sine ? -deepest() : way_; }

  // Whether the block `be` has another side between its face at `e` and a corner at `p` below it, or there: what the corner is away from
  // the face is no depth then.
  bool behind(int be, int e, const Face& face, const Vec2& p) const {
    const Vec2 foot = p - face.gap(p) * face.normal;
    for (int f = 0; f < model_.vertex_count(be); ++f) {
      if (f == e || !free(be, f)) continue;
      const Face& far = edge(be, f);
      const double from = far.gap(foot), to = far.gap(p);
      if (from > meeting() || to <= -meeting() || to <= from) continue;
      const double s = far.position(foot + std::max(0.0, from / (from - to)) * (p - foot));
      if (s >= -beside() && s <= far.length + beside()) return true;
    }
    return false;
  }

 private:
  // The face of a trace keeps its property where blocks of its region slide on, past those that lay against it at first.
  int property_of(const Contact& c) const {
    if (c.joint >= 0) return model_.joints[c.joint].property;
    const int face = surface_.joint[c.global_edge];
    const bool traced = face >= 0 && model_.joints[face].trace >= 0 && model_.shapes[c.i].region == model_.shapes[c.j].region;
    return traced ? model_.joints[face].property : model_.contact_property(c.i, c.j);
  }
  // The open joint one face of which is the edge at `face` and the other ends in corner `v` of `block`, or -1.
  int joint_between(int block, int v, int face) const {
    const int j = surface_.joint[face];
    if (j < 0) return -1;
    const Joint& joint = model_.joints[j];
    const int own = joint.a == block ? joint.edge_a : joint.b == block ? joint.edge_b : -1;
    return own >= 0 && (own == v || next(block, own) == v) ? j : -1;
  }
  static bool lies_along(const Vec2& d, const Vec2& n) { return std::abs(d.dot(n)) <= parallel_sine * d.norm(); }

  // Length over which an edge at corner `v` lies along `e`, or 0.
  double shared_length(int block, int v, const Face& e) const {
    const Vec2 p = vertex(block, v);
    double shared = 0;
    for (int other : {next(block, v), previous(block, v)}) {
      const Vec2 q = vertex(block, other);
      if (std::abs(e.normal.dot(q - p)) > parallel_sine * (q - p).norm()) continue;
      const double s0 = std::clamp(e.position(p), 0.0, e.length), s1 = std::clamp(e.position(q), 0.0, e.length);
      if (std::abs(s1 - s0) > corner_part * e.length) shared = std::max(shared, std::abs(s1 - s0));
    }
    return shared;
  }

  const Model& model_;
  const Surface& surface_;
  const Outline outline_;
  const Faces& faces_;
  int i_, j_;
  double dt_, judged_, least_, way_, reach_;  // s, s, m, m, m; judged_: from the start to the places that contacts are judged at
  bool fast_;                           // may pass an edge by in the step
  double turn_;                         // rad, of i as seen from j until contacts are judged
};

struct Candidate {
  int edge;
  double gap;
  bool on;  // or next to its end: it counts only beside others
};

enum class End { first, last };

// Place along an edge of a vertex that is at `s` now and goes `way`: where it comes to the edge's line from outside, if it does.
double place_met(const Face& edge, double gap, double s, const Vec2& way) {
  const double ahead = gap + edge.normal.dot(way);
  return gap > 0 && ahead < 0 ? s + edge.along.dot(way) * gap / (gap - ahead) : s;
}

// Where a vertex is inside two edges that share a convex corner it rests on the one it entered last.
void drop_deeper(const Pair& pair, int block, std::vector<Candidate>& candidates) {
  std::vector<Candidate> kept;
  for (const Candidate& c : candidates) {
    const bool deeper = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
      const bool follows = pair.next(block, c.edge) == other.edge, leads = pair.next(block, other.edge) == c.edge;
      if (!(follows || leads) || c.gap >= 0 || other.edge == c.edge) return false;
      if (!pair.convex(block, follows ? other.edge : c.edge)) return false;
      return other.gap > c.gap || (other.gap == c.gap && other.edge < c.edge);
    });
    if (!deeper && c.on) kept.push_back(c);
  }
  candidates = std::move(kept);
}

// Vertices of block `bv` on edges of block `be`.
void vertices_on_edges(const Pair& pair, const Model& model, int bv, int be, std::vector<Contact>& found) {
  std::vector<Candidate> candidates;
  for (int v = 0; v < model.vertex_count(bv); ++v) {
    if (!pair.exposed(bv, v)) continue;
    const Vec2 p = pair.vertex(bv, v);
    std::optional<Vec2> way;  // where it is needed
    candidates.clear();
    for (int e = 0; e < model.vertex_count(be); ++e) {
      if (!pair.free(be, e)) continue;
      const Face& edge = pair.edge(be, e);
      const double gap = edge.gap(p);
      if (gap > pair.reach() || gap < pair.deepest()) continue;
      double s = edge.position(p);
      if (pair.fast() && gap > 0) {
        if (!way) way = pair.way(bv, v, be);
        s = place_met(edge, gap, s, *way);
      }
      const bool on = pair.within(be, e, s, edge.length);
      if (!on && (std::abs(gap) > pair.flush() || !pair.within(be, e, s, edge.length, pair.meeting()))) continue;
      if (gap < -pair.meeting() && pair.behind(be, e, edge, p)) continue;
      if (gap > -pair.flush() && pair.passes_flush(bv, v, be, e, s, edge.length)) continue;
      if (pair.can_rest(bv, v, edge.normal) || (gap > 0 && pair.will_rest(bv, v, edge.normal))) candidates.push_back({e, gap, on});
    }
    drop_deeper(pair, be, candidates);
    for (const Candidate& c : candidates) found.push_back(pair.contact(bv, v, be, c.edge, c.gap, false));
  }
}

// The line of an edge at one of two corners, which the other corner can rest on.
struct Choice {
  int block_v, vertex, block_e, edge;
  double gap, ahead;   // m, now and where contacts are judged
  double from, until;  // parts of the way there between which the line keeps the corners apart; 2: to the end
  double beyond;       // m, from the edge's nearer end, outside it
};

// Of lines that separate two corners, the one that is penetrated last: what keeps them apart from now on the longest, or one that does
// before that ends, and to the end.
// `noise`: m, of places. What differs by that alone, as a corner on a face and the other corner on a face that is parallel to it, goes by the order
// of the choices, and so in a mirrored scene as in the scene.
Choice penetrated_last(std::vector<Choice>& choices, double rounding, double noise) {
  const auto farther = [&](const Choice& a, const Choice& b) {
    if (std::abs(a.ahead - b.ahead) > rounding) return a.ahead < b.ahead;
    return a.beyond > b.beyond + noise;
  };
  const auto sooner = [&](const Choice& a, const Choice& b) {
    return std::abs(a.until - b.until) > corner_part ? a.until < b.until : farther(a, b);
  };
  const auto begin = choices.begin(), end = choices.end();
  const auto later = std::partition(begin, end, [](const Choice& c) { return c.from == 0; });
  const auto now = std::max_element(begin, later, sooner), then = std::max_element(later, end, farther);
  if (begin == later) return *then;
  return then != end && then->from <= now->until && now->until < then->until ? *then : *now;
}

// Corner `v` of i near corner `w` of j: one contact at most, unless edges lie along each other. Two convex corners are
// apart while any of the lines that one of them can rest on still separates them, so of all choices that one counts
// which is penetrated last (Shi 1988, entrance line), by this step's velocities: where corners coincide, as
// all do round a node of a mesh, the gaps themselves tell nothing, and any other choice would bar a way that is free.
void corner_on_corner(const Pair& pair, int v, int w, size_t first, std::vector<Contact>& found,
                      std::vector<MeetingCorners>& meeting) {
  const int i = pair.i(), j = pair.j();
  const double distance = (pair.vertex(i, v) - pair.vertex(j, w)).norm();
  if (distance > pair.reach()) return;
  if (pair.inner(i, v) || pair.inner(j, w)) return;  // two faces, each met by itself
  const int w0 = pair.previous(j, w), v0 = pair.previous(i, v);  // edges before the corners; those after bear its number
  if (distance <= pair.meeting()) meeting.push_back({i, pair.global(i, v), j, pair.global(j, w)});
  const auto is_here = [&](const Contact& c) {
    return (c.i == i && c.vertex == v && c.j == j && (c.edge == w || c.edge == w0)) ||
           (c.i == j && c.vertex == w && c.j == i && (c.edge == v || c.edge == v0));
  };
  for (size_t c = first; c < found.size(); ++c)
    if (is_here(found[c]) && found[c].kind == ContactKind::edge_edge) return;
  std::vector<Choice> choices;
  // `end`: of the edge, at which the corners are to meet.
  const auto consider = [&](int bv, int vertex, int be, int e, End end) {
    if (!pair.free(be, e)) return;
    const Face& edge = pair.edge(be, e);
    if (!pair.can_rest(bv, vertex, edge.normal)) return;
    const Vec2 p = pair.vertex(bv, vertex), way = pair.way(bv, vertex, be);
    const double gap = edge.gap(p), ahead = gap + edge.normal.dot(way), s = edge.position(p);
    if (gap < -pair.meeting() && pair.behind(be, e, edge, p)) return;
    if (gap > -pair.flush() && pair.passes_flush(bv, vertex, be, e, s, edge.length)) return;
    // Where it comes to the line there is no edge: nothing is met there, and nothing kept apart. Beyond the other end that is for
    // the corner there to say.
    const double met = place_met(edge, gap, s, way), past = end == End::first ? -met : met - edge.length;
    const auto comes_on = [&] { return past < edge.along.dot(way) * (end == End::first ? 1 : -1) && pair.slides_on(bv, vertex, be, e); };
    if (ahead < 0 && past > pair.beside() && !comes_on()) return;
    if (ahead < 0 && past < -edge.length && !pair.within(be, e, met, edge.length)) return;
    const double apart = std::max(0.0, gap - pair.meeting()), until = ahead < 0 ? apart / (apart - ahead) : 2;
    choices.push_back({bv, vertex, be, e, gap, ahead, 0, until, std::max({0.0, -s, s - edge.length})});
  };
  consider(i, v, j, w, End::first);
  consider(i, v, j, w0, End::last);
  consider(j, w, i, v, End::first);
  consider(j, w, i, v0, End::last);
  found.erase(std::remove_if(found.begin() + long(first), found.end(), is_here), found.end());
  if (choices.empty()) return;
  const auto flush = [&](const Choice& c) { return pair.slides_on(c.block_v, c.vertex, c.block_e, c.edge); };
  if (std::any_of(choices.begin(), choices.end(), flush)) {
    std::erase_if(choices, [&](const Choice& c) { return !flush(c); });
    // Flush with two faces: blocks that meet in one point across a crossing of joints. They press once one has moved.
    const Vec2 along = pair.edge(choices[0].block_e, choices[0].edge).along;
    for (const Choice& c : choices)
      if (std::abs(cross(along, pair.edge(c.block_e, c.edge).along)) > parallel_sine) return;
  }
  // Corners in one place may be under each other's lines by as much; others only as deep as they press.
  double pressed = pair.meeting();
  if (distance > pair.meeting())
    for (const Choice& c : choices) pressed = std::min(pressed, std::max(0.0, -c.gap) + corner_part * pair.least());
  for (Choice& c : choices)
    if (const double under = -c.gap - pressed; under > 0) c.from = under / (under + std::max(0.0, c.ahead));
  const Choice best = penetrated_last(choices, corner_part * pair.least(), pair.noise(v));
  if (best.gap > pair.reach() || best.gap < pair.deepest()) return;
  found.push_back(pair.contact(best.block_v, best.vertex, best.block_e, best.edge, best.gap, true));
}

// Corners that coincide along a face, however deep they press, give the same contact twice, once from each block: the second is
// dropped. Else the two would share a load, half of which is lost where one of them goes.
void drop_twins(const Pair& pair, size_t first, std::vector<Contact>& found) {
  for (size_t c = first; c < found.size(); ++c) {
    const Face& face = pair.edge(found[c].j, found[c].edge);
    const Vec2 p = pair.vertex(found[c].i, found[c].vertex);
    for (size_t other = c + 1; other < found.size();) {
      const Face& facing = pair.edge(found[other].j, found[other].edge);
      const Vec2 apart = pair.vertex(found[other].i, found[other].vertex) - p;
      const double near = 2 * corner_part * std::max(face.length, facing.length);
      const bool twin = found[other].i == found[c].j && std::abs(face.along.dot(apart)) <= near &&
                        std::abs(face.normal.dot(apart)) <= pair.meeting() && face.normal.dot(facing.normal) < -0.99;
      if (twin)
        found.erase(found.begin() + long(other));
      else
        ++other;
    }
  }
}

// Where blocks lie in each other and none of these contacts is as deep, as with thin tips that have gone through each other, they stand by the
// face that is to be left by the shortest way.
void least_deep(const Pair& pair, const Model& model, size_t first, std::vector<Contact>& found) {
  if (!pair.both_convex()) return;
  const std::array blocks{pair.i(), pair.j()};
  const auto out = way_out({model.vertex_count(blocks[0]), model.vertex_count(blocks[1])}, pair.meeting(), [&](int of, int face, int corner) {
    return pair.edge(blocks[size_t(of)], face).gap(pair.vertex(blocks[size_t(1 - of)], corner));
  });
  if (!out) return;
  const auto knows = [&](const Contact& c) { return c.gap <= known_part * out->gap; };
  if (std::any_of(found.begin() + long(first), found.end(), knows)) return;
  const int bv = blocks[size_t(1 - out->of)], be = blocks[size_t(out->of)];
  if (pair.free(be, out->face) && pair.on_outline(bv, out->corner))
    found.push_back(pair.contact(bv, out->corner, be, out->face, out->gap, true));
}

}  // namespace

void find_contacts(const Model& model, const Surface& surface, const Faces& faces, int a, int b, double dt, std::vector<Contact>& found,
                   std::vector<MeetingCorners>& meeting) {
  const auto rim = [&](int k) { return std::abs(spin(model, k)) * model.shapes[k].radius; };
  const Vec2 approach(model.blocks[a].velocity[0] - model.blocks[b].velocity[0],
                      model.blocks[a].velocity[1] - model.blocks[b].velocity[1]);
  const Pair pair(model, surface, faces, a, b, 1.5 * dt * (approach.norm() + rim(a) + rim(b)), dt);
  if (pair.apart()) return;
  const size_t first = found.size();
  vertices_on_edges(pair, model, a, b, found);
  vertices_on_edges(pair, model, b, a, found);
  for (int v = 0; v < model.vertex_count(a); ++v)
    if (pair.exposed(a, v))
    for (int w = 0; w < model.vertex_count(b); ++w)
      if (pair.exposed(b, w)) corner_on_corner(pair, v, w, first, found, meeting);
  drop_twins(pair, first, found);
  least_deep(pair, model, first, found);
}

double meeting_distance(const Model& model, int a, int b) {
  return meeting_part * std::min(model.shapes[a].length, model.shapes[b].length);
}

}  // namespace talus
