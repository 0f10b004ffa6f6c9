#include "equations/contact_terms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "equations/boundary_terms.h"

namespace talus {

namespace {

constexpr double near_part = 1e-3;
// What slides climbs to the face's height within this part of the smaller block's √area, or twice its way in the step
// where that is more, but nowhere up a steeper slope than the second, nor one that would take more than these parts of
// its friction and of its momentum, of which every contact of a block takes some.
constexpr double climbed_within = 0.1, steepest_climb = 1e-3, of_friction = 0.5, of_momentum = 0.05;

// Change along `direction` of the place of the vertex `local` of a block under unit unknowns, beyond the turning of the
// block.
template <int n>
ColumnOf<n> vertex_row(const Model& model, const Poses& poses, int block, int local, const Vec2& direction) {
  const int v = model.shapes[block].vertex_begin + local;
  return poses.blocks[block].rows<n>(model.reference_vertex[v], poses.vertex[v]).transpose() * direction;
}

CurvedEdge curved_edge(const Model& model, const Poses& poses, int block, int edge) {
  const BlockShape& shape = model.shapes[block];
  const Pose& pose = poses.blocks[block];
  const int from = shape.vertex_begin + edge, to = shape.vertex_begin + model.next_vertex(block, edge);
  const Vec3 rise = pose.bend->shape.rise(model.reference_vertex[to] - model.reference_vertex[from]);
  return {poses.vertex[from], poses.vertex[to] - poses.vertex[from],
          pose.rotation.turn(Bend::sum(rise, pose.bend->now))};
}

// The same of what is `part` of the way along an edge: of one that stays straight it goes with the ends, of one that
// bends it is a material point, whose place, and so row, is quadratic in the part; and linear beyond the ends.
template <int n>
ColumnOf<n> edge_row(const Model& model, const Poses& poses, int block, int edge, double part, const Vec2& direction) {
  const int next = model.next_vertex(block, edge), begin = model.shapes[block].vertex_begin;
  const ColumnOf<n> from = vertex_row<n>(model, poses, block, edge, direction),
                    to = vertex_row<n>(model, poses, block, next, direction);
  if (!model.curved(block)) return (1 - part) * from + part * to;
  const Vec2 middle = (model.reference_vertex[begin + edge] + model.reference_vertex[begin + next]) / 2;
  const ColumnOf<n> rise =
      poses.blocks[block].rows<n>(middle, poses.blocks[block].place(middle)).transpose() * direction - (from + to) / 2;
  const double in = CurvedEdge::within(part);
  return (1 - part) * from + part * to + 4 * (in * (1 - in) + (part - in) * (1 - 2 * in)) * rise;
}

EdgeFoot foot_of(const Model& model, const Poses& poses, const Contact& contact, const Vec2& at) {
  if (model.curved(contact.j)) return curved_edge(model, poses, contact.j, contact.edge).foot(at);
  return straight_foot(poses.vertex[contact.global_edge],
                       poses.vertex[model.shapes[contact.j].vertex_begin + model.next_vertex(contact.j, contact.edge)],
                       at);
}

}  // namespace

double full_climb(const Model& model, const Contact& contact, double way) {
  const double size = std::min(model.shapes[contact.i].length, model.shapes[contact.j].length);
  return std::min(contact.height / std::max(climbed_within * size, 2 * way),
                  std::max(steepest_climb, 2 * contact.height / size));
}

namespace {

// A corner that has come on to a face which lies higher climbs to that as it slides on: the height, which its offset
// keeps from being a load, goes, and the force is that of the slope, so that what slides pays for what is lifted
// (theory, § 5). Which way it slides its friction says, also of what slips at rest; without friction the speed does.
double climb(const Model& model, const Contact& contact, double sliding, double dt) {
  if (contact.height <= 0 || contact.normal_force <= 0) return 0;
  // What the slope helps to hold would slide without it: in a search for equilibrium it would come and go.
  if (contact.state != ContactState::slip) return dt > 0 ? 0 : contact.slope;
  const double way = contact.shear_force != 0 ? contact.shear_force : sliding;
  double most = of_friction * std::abs(contact.shear_force);  // N
  if (dt > 0 && sliding * way > 0)
    most =
        std::max(most, of_momentum * std::min(model.mass(contact.i), model.mass(contact.j)) * std::abs(sliding) / dt);
  return std::copysign(std::min(full_climb(model, contact, std::abs(sliding) * dt), most / contact.normal_force), way);
}

void add_slope(ContactRows& row) {
  for (int k = 0; k < row.size_i; ++k) row.normal_i[size_t(k)] -= row.climb * row.shear_i[size_t(k)];
  for (int k = 0; k < row.size_j; ++k) row.normal_j[size_t(k)] -= row.climb * row.shear_j[size_t(k)];
}

}  // namespace

double rounding_of_gap(const Model& model, const Contact& contact) {
  return 8 * std::numeric_limits<double>::epsilon() * model.size_of(model.vertex[contact.global_vertex]);
}

// Both blocks feel shear at the vertex, be it a little off the edge: action and reaction on one line keep
// angular momentum, and what turns as one does not slide.
template <int n>
void ContactTerms::set_rows(const Model& model, const Contact& contact, const Poses& poses, const Vec2& at,
                            const EdgeFoot& on, ContactRows& row) {
  const auto& [foot, along, normal, gap] = on;
  if constexpr (n == first_order_dofs) {
    const Pose &pose_i = poses.blocks[contact.i], &pose_j = poses.blocks[contact.j];
    const auto set = [](Row& to, const FirstRow& from) { std::copy(from.begin(), from.end(), to.begin()); };
    set(row.normal_i, pose_i.row(at, normal));
    set(row.shear_i, pose_i.row(at, along));
    set(row.normal_j, pose_j.row(foot, -normal));
    set(row.shear_j, pose_j.row(at, -along));
  } else {
    const auto set = [](Row& to, const ColumnOf<n>& from) { std::copy_n(from.data(), std::size_t(n), to.begin()); };
    const int next = model.next_vertex(contact.j, contact.edge);
    const Vec2 from = poses.vertex[contact.global_edge],
               span = poses.vertex[model.shapes[contact.j].vertex_begin + next] - from;
    const double part = model.curved(contact.j) ? curved_edge(model, poses, contact.j, contact.edge).nearest(at)
                                                : along.dot(foot - from) / along.dot(span);
    for (const auto& [direction, of_i, of_j] :
         {std::tuple(normal, &row.normal_i, &row.normal_j), {along, &row.shear_i, &row.shear_j}}) {
      set(*of_i, vertex_row<n>(model, poses, contact.i, contact.vertex, direction));
      set(*of_j, -edge_row<n>(model, poses, contact.j, contact.edge, part, direction));
    }
    const ColumnOf<n> turns = (vertex_row<n>(model, poses, contact.j, contact.edge, normal) -
                               vertex_row<n>(model, poses, contact.j, next, normal)) /
                              span.norm();
    for (int k = 0; k < n; ++k) row.shear_j[size_t(k)] -= gap * turns[k];
  }
}

void ContactTerms::linearise(const Model& model, Poses& poses, const Scheme& scheme, bool stick,
                             std::span<const double> nearness, double pressed) {
  poses.place_vertices(model);
  factor_ = scheme.contact_d;
  rows_.resize(model.contacts.size() - size_t(model.sleeping_contacts));
  for (size_t k = 0; k < rows_.size(); ++k) {
    const Contact& contact = model.contacts[size_t(model.sleeping_contacts) + k];
    const Strength strength = model.contact_strength(contact);
    const BlockShape &shape_i = model.shapes[contact.i], &shape_j = model.shapes[contact.j];
    const Vec2 at = poses.vertex[contact.global_vertex];
    const EdgeFoot on = foot_of(model, poses, contact, at);

    ContactRows& row = rows_[k];
    row.contact = model.sleeping_contacts + int(k);
    row.i = contact.i;
    row.j = contact.j;
    row.dof_i = shape_i.dof_begin;
    row.dof_j = shape_j.dof_begin;
    row.size_i = shape_i.dofs;
    row.size_j = shape_j.dofs;
    const bool second = shape_i.second_order() || shape_j.second_order();
    with_size(second, [&](auto n) { set_rows<n>(model, contact, poses, at, on, row); });
    const Rates &vi = model.blocks[contact.i].velocity, &vj = model.blocks[contact.j].velocity;
    const double sliding = dot(row.shear_i, vi) + dot(row.shear_j, vj);
    const double approach = dot(row.normal_i, vi) + dot(row.normal_j, vj);
    row.climb = climb(model, contact, sliding, scheme.dt);
    if (row.climb != 0) add_slope(row);
    row.rounding = contact.lies ? 0 : rounding_of_gap(model, contact);
    row.faster = model.faster_along(contact.i, row.shear_i) + model.faster_along(contact.j, row.shear_j);
    // Springs are unstrained where blocks lie, at X: before the first step y is X, as if nothing had moved. What moves
    // with its floor has not slid then.
    if (model.time == 0)
      row.faster += (row.size_i > 0 ? dot(row.shear_i, vi) : 0) + (row.size_j > 0 ? dot(row.shear_j, vj) : 0);
    const double slid = scheme.step_v * sliding + scheme.bond_ahead * row.faster;
    row.slide0 = contact.stretch + slid;
    // What has climbed is what slides from y to y; from X a change of speed alone would lift it.
    row.gap0 =
        (contact.lies ? scheme.dt * approach - contact.normal_force / contact.normal_stiffness
                      : on.gap + contact.offset + scheme.contact_v * approach +
                            scheme.bond_ahead * on.normal.dot(model.rising(contact.i) - model.rising(contact.j))) -
        row.climb * slid;
    row.kn = contact.normal_stiffness;
    row.ks = contact.shear_stiffness;
    row.friction = stick ? std::numeric_limits<double>::infinity() : std::tan(strength.friction);
    // Cohesion belongs to faces that were pressed together when the step began: a law in which it came and went with
    // the force that depends on it has no solution at a wedge.
    const double cohesion = strength.cohesion * contact.length;
    row.cohesion = contact.coheres || contact.normal_force > pressed * cohesion ? cohesion : 0;
    const double touching = near_part * std::min(shape_i.length, shape_j.length);
    const double pushed = touching + 0.5 * scheme.contact_v * std::hypot(approach, sliding);
    // A joint that does not slide does not let go of its shear when it opens either: that would be a law with jumps,
    // which among bricks has no solution; so it is convex.
    if (stick && row.gap0 <= touching) row.cohesion = std::numeric_limits<double>::infinity();
    const double widened = nearness.empty() ? 1 : std::max(nearness[contact.i], nearness[contact.j]);
    row.near = scheme.dt == 0 || contact.normal_force > 0 || row.gap0 <= widened * pushed;
  }
}

void ContactTerms::take_part(const ContactTerms& whole, std::span<const int> rows, const std::vector<int>& place,
                             const std::vector<int>& dof_begin) {
  factor_ = whole.factor_;
  rows_.clear();
  for (const int k : rows) {
    ContactRows& row = rows_.emplace_back(whole.rows_[k]);
    row.i = place[row.i];
    row.j = place[row.j];
    row.dof_i = dof_begin[row.i];
    row.dof_j = dof_begin[row.j];
  }
}

void ContactTerms::find_slots(const BlockMatrix& matrix) {
  slots_.clear();
  for (const ContactRows& row : rows_)
    slots_.push_back(row.near ? Slots{matrix.slot(row.i, row.i), matrix.slot(row.j, row.j), matrix.slot(row.i, row.j)}
                              : Slots{});
}

template <typename Number>
void ContactTerms::add_stiffness(BlockMatrix& matrix, const std::vector<Number>& closed,
                                 const std::vector<Number>& stuck) const {
  for (size_t k = 0; k < rows_.size(); ++k) {
    const ContactRows& row = rows_[k];
    if (!row.near) continue;  // it has no slots; it may still bear the state of a contact that has let go
    const Slots& slots = slots_[k];
    const auto add = [&](double stiffness, const Row& i, const Row& j) {
      const double factor = factor_ * stiffness;
      if (row.size_i) matrix.add_outer(slots.ii, factor, i.data(), i.data());
      if (row.size_j) matrix.add_outer(slots.jj, factor, j.data(), j.data());
      if (row.size_i && row.size_j) {
        const bool i_is_row = slots.ij.row == slots.ii.row;
        matrix.add_outer(slots.ij, factor, i_is_row ? i.data() : j.data(), i_is_row ? j.data() : i.data());
      }
    };
    if (closed[k] > 0) add(closed[k] * row.kn, row.normal_i, row.normal_j);
    if (stuck[k] > 0) add(stuck[k] * row.ks, row.shear_i, row.shear_j);
  }
}

template void ContactTerms::add_stiffness(BlockMatrix&, const std::vector<char>&, const std::vector<char>&) const;
template void ContactTerms::add_stiffness(BlockMatrix&, const std::vector<double>&, const std::vector<double>&) const;

}  // namespace talus
