#include "contact/hand_over.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "contact/detection.h"
#include "contact/narrow_phase.h"
#include "contact/outline.h"
#include "equations/contact_terms.h"
#include "model/rates.h"

namespace talus {

namespace {

EdgeFoot foot_of(const Model& model, const Contact& c) {
  const Vec2& at = model.vertex[c.global_vertex];
  if (model.curved(c.j)) return model.curved_edge(c.j, c.edge).foot(at);
  return straight_foot(model.vertex[c.global_edge],
                       model.vertex[model.shapes[c.j].vertex_begin + model.next_vertex(c.j, c.edge)], at);
}

}  // namespace

Vec2 edge_normal(const Model& model, const Contact& c) {
  return foot_of(model, c).normal;
}

namespace {

void carry(const Contact& from, Contact& to) {
  to.state = from.state;
  // The force goes on, and what has slid in the search for equilibrium.
  to.stretch = from.stretch - from.shear_force / from.shear_stiffness + from.shear_force / to.shear_stiffness;
  to.slip = from.slip;
  to.slid = from.slid;
  to.offset = from.offset;
  to.height = from.height;
  to.slope = from.slope;
  to.lies = from.lies;
  to.normal_force = from.normal_force;
  to.shear_force = from.shear_force;
  to.may_part = from.may_part;
  to.parts = from.parts;
  to.lifted = from.lifted;
  to.parting = from.parting;
  to.load_normal = from.load_normal;
  to.load_shear = from.load_shear;
  to.load_slip = from.load_slip;
  to.load_climb = from.load_climb;
  to.coheres = from.coheres;
}

// Whether the loaded contact `old` ended where `c` begins: the same vertex on another edge, or the same two blocks with
// the parts of vertex and edge exchanged; at the same place within a tenth of the block, with the same normal.
bool follows(const Model& model, const Contact& c, const Contact& old) {
  const bool swapped = old.i == c.j && old.j == c.i;
  if (!(old.global_vertex == c.global_vertex || swapped)) return false;
  const double near = 0.1 * std::min(model.shapes[c.i].length, model.shapes[c.j].length);
  if ((model.vertex[old.global_vertex] - model.vertex[c.global_vertex]).norm() > near) return false;
  return edge_normal(model, old).dot(edge_normal(model, c)) * (swapped ? -1 : 1) > 0.999;
}

// What each of the contacts that begin takes over, or null. One that ended is taken over once: where a face has slid
// past the end of another and both the corner there and the face next to it are met now, by the longer of the two.
std::vector<const Contact*> predecessors(const Model& model, const std::vector<Contact*>& fresh,
                                         const std::vector<const Contact*>& ended) {
  std::unordered_map<std::int64_t, std::vector<const Contact*>> at;  // by vertex, and by pair of blocks
  for (const Contact* old : ended) {
    at[-1 - old->global_vertex].push_back(old);
    at[pair_key(old->i, old->j)].push_back(old);
  }
  struct Claim {
    size_t by;
    const Contact* of;
    bool same_vertex;
  };
  std::vector<Claim> claims;
  for (size_t k = 0; k < fresh.size(); ++k)
    for (const std::int64_t key : {std::int64_t(-1 - fresh[k]->global_vertex), pair_key(fresh[k]->i, fresh[k]->j)})
      if (const auto found = at.find(key); found != at.end())
        for (const Contact* old : found->second) {
          const bool same_vertex = key < 0;
          if (same_vertex != (old->global_vertex == fresh[k]->global_vertex) || !follows(model, *fresh[k], *old))
            continue;
          claims.push_back({k, old, same_vertex});
        }
  std::stable_sort(claims.begin(), claims.end(), [&](const Claim& a, const Claim& b) {
    if (fresh[a.by]->length != fresh[b.by]->length) return fresh[a.by]->length > fresh[b.by]->length;
    return a.same_vertex && !b.same_vertex;
  });
  std::vector<const Contact*> before(fresh.size(), nullptr);
  std::unordered_set<const Contact*> taken;
  for (const Claim& claim : claims)
    if (!before[claim.by] && taken.insert(claim.of).second) before[claim.by] = claim.of;
  return before;
}

// m, how deep a contact is at the places y = X + (θ-½)Δt v that the scheme looks at (theory, § 2), as the step begins.
double depth_ahead(const Model& model, const Contact& c, double dt) {
  const double shift = judged_ahead(model.scene.numerics, dt);
  const EdgeFoot on = foot_of(model, c);
  const Vec2 apart = model.corner_velocity(c.i, c.vertex) - model.rising(c.i) -
                     model.velocity_on_edge(c.j, c.edge, on.foot) + model.rising(c.j);
  return -(on.gap + c.offset) - shift * on.normal.dot(apart);
}

// Met already overlapping, or touching and so fast that y overlaps: not a load (docs/theory.md). What is still apart
// may well overlap in y: that is a hit, but where a bond has just failed, whose body met there by another corner.
double born_with(const Model& model, const Contact& c, double dt, bool cracked) {
  if (!cracked && c.gap > meeting_distance(model, c.i, c.j)) return 0;
  return std::max({0.0, -c.gap, depth_ahead(model, c, dt)});
}

// m, that an even pressure on its face has it bear: as its spring, which along an edge that bends is by Simpson's rule
// (theory, § 1).
double share(const Model& model, const Contact& c) {
  const JointProperty& property = model.scene.properties[size_t(c.property)];
  if (property.stiffness_kind == StiffnessKind::per_contact) return c.length;
  return std::min(c.normal_stiffness / model.stiffness_per_area(property, c.i, c.j), 4.0 / 3 * c.length);
}

// A bond that has just failed leaves to the faces what they can carry of its traction. Else they would first have to
// move into each other, and what the rock was pressed together with would shake it.
void take_over(const Model& model, Contact& c) {
  const BondTraction bond = mean_traction(model.joints[c.joint]), t = taken_over(bond, model.contact_strength(c));
  if (t.normal >= 0) return;
  const double length = share(model, c);
  c.normal_force = c.load_normal = -t.normal * length;
  c.shear_force = c.load_shear = t.shear * length;
  c.stretch = c.shear_force / c.shear_stiffness;
  c.offset = -c.gap - c.normal_force / c.normal_stiffness;
  c.state = t.shear == bond.shear ? ContactState::stick : ContactState::slip;
}

// A corner that slides from the face of one block on to that of the next, which stands out a little farther, is not
// pressed by that step, which it could not have climbed: its height is the contact's offset, until it has climbed or a
// step leads down again. Where the faces meet in an edge there is none, and the way along them bends. Returns how much
// farther, m.
double step_over(const Model& model, const Contact& old, Contact& c) {
  const auto corner = [&](const Contact& of, int k) {
    return model.vertex[size_t(model.shapes[size_t(of.j)].vertex_begin + k)];
  };
  const Vec2 from = corner(old, old.edge), to = corner(old, model.next_vertex(old.j, old.edge));
  const std::array ends{corner(c, c.edge), corner(c, model.next_vertex(c.j, c.edge))};
  const bool first = distance_to_segment(from, to, ends[0]) < distance_to_segment(from, to, ends[1]);
  const double up = -perp(to - from).normalized().dot(ends[first ? 0 : 1] - from);
  const double size = std::min(model.shapes[size_t(c.i)].length, model.shapes[size_t(c.j)].length);
  if (up > 0 && up <= passing_tolerance * size) c.offset += up;
  if (up < 0) c.offset = std::max(std::min(0.0, c.offset), c.offset + up);
  return std::max(0.0, up);
}

}  // namespace

double gap_now(const Model& model, const Contact& c) {
  return foot_of(model, c).gap;
}

double carry_over(const Model& model, double dt, bool cracked, std::vector<Contact>& now) {
  std::vector<Contact*> fresh;
  std::vector<const Contact*> ended;
  const std::span<const Contact> before = model.awake_contacts();
  auto old = before.begin();
  const auto end_those_before = [&](std::int64_t key) {
    for (; old != before.end() && old->key() < key; ++old) {
      if (old->state != ContactState::open) ended.push_back(&*old);
    }
  };
  for (Contact& c : now) {
    end_those_before(c.key());
    if (old == before.end() || old->key() != c.key()) {
      fresh.push_back(&c);
      continue;
    }
    if (old->state != ContactState::open) {  // a loaded spring keeps its stiffness
      if (c.kind != ContactKind::edge_edge || old->kind != ContactKind::edge_edge) c.length = old->length;
      c.kind = old->kind;
      c.normal_stiffness = old->normal_stiffness;
      c.shear_stiffness = old->shear_stiffness;
    }
    carry(*old++, c);
  }
  end_those_before(std::numeric_limits<std::int64_t>::max());
  const std::vector<const Contact*> predecessor = predecessors(model, fresh, ended);
  double stored = 0;
  for (const Contact* c : ended) stored += c->stored();
  for (size_t k = 0; k < fresh.size(); ++k) {
    Contact* const c = fresh[k];
    if (const Contact* const old = predecessor[k]) {
      // As stiff as the stiffer of the two, and with the same force: a softer spring would store more for it.
      const double stiffer = std::max(1.0, old->normal_stiffness / c->normal_stiffness);
      c->normal_stiffness *= stiffer;
      c->shear_stiffness *= stiffer;
      carry(*old, *c);
      // Deeper by the other block's face, which lies a little otherwise: not a load.
      const double deeper = gap_now(model, *old) - c->gap, pressed = c->offset;
      if (old->i == c->j) c->offset += std::max(0.0, deeper);
      if (old->global_vertex == c->global_vertex) {
        const double up = old->j != c->j ? step_over(model, *old, *c) : 0;
        // by which the face bends up: in motion its height is no load either
        if (dt > 0) c->offset += std::max(0.0, deeper - up);
      }
      c->height = std::clamp(c->height + c->offset - pressed, 0.0, std::max(0.0, c->offset));
      c->deeper = deeper + old->offset - c->offset;
      c->offset += old->normal_force / old->normal_stiffness - old->normal_force / c->normal_stiffness;
      c->load_normal = std::numeric_limits<double>::quiet_NaN();
      stored -= c->stored();
    } else {
      c->offset = born_with(model, *c, dt, cracked);
      if (!cracked && model.time > 0) c->height = c->offset;
      if (c->joint >= 0) take_over(model, *c);
    }
  }
  return stored;
}

// After a hit X lies deeper than y, by Δt/4 times the speed of the rebound; a step shorter than the last would find
// that depth as a load that nothing paid for. It is kept as an offset, which goes as the bodies part: nothing presses
// more at the start of a step than at the end of the last.
void forgive_depth(Model& model, double dt) {
  for (Contact& c : model.awake_contacts()) {
    if (stands_still(model, c.i) && stands_still(model, c.j)) continue;  // X is y
    if (c.gap + c.offset >= 0) continue;
    const double now = std::min(-(c.gap + c.offset), depth_ahead(model, c, dt));
    c.offset += std::max(0.0, now - c.normal_force / c.normal_stiffness);
  }
}

// What rests lies as its force says: that has all its digits. In small and stiff blocks it is pressed in by less than
// places are rounded to: the gap, off by the rounding of the places now and of those that the force is of, would be a
// load that nothing bears.
void lie_as_pressed(Model& model, double dt) {
  const auto rests = [&](int block, double rounding) {
    const auto& v = model.blocks[block].velocity;
    return std::ranges::all_of(v, [&](double rate) { return std::abs(rate) * dt <= rounding; });
  };
  for (Contact& c : model.awake_contacts()) {
    if (c.lies && dt > 0 && stands_still(model, c.i) && stands_still(model, c.j)) continue;
    const double rounding = rounding_of_gap(model, c);
    c.lies = c.normal_force > 0 && rests(c.i, rounding) && rests(c.j, rounding);
    if (!c.lies) continue;
    const double off = depth_ahead(model, c, dt) - c.normal_force / c.normal_stiffness;
    c.lies = std::abs(off) <= 4 * rounding;
    if (c.lies) c.offset += off;
  }
}

}  // namespace talus
