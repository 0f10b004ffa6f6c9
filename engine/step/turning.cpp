#include "step/turning.h"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

double turn(const Model& model, const std::vector<BlockState>& moved, int block) {
  return std::abs(moved[size_t(block)].angle - model.blocks[size_t(block)].angle);
}

double larger_turn(const Model& model, const std::vector<BlockState>& moved, const ContactRows& row) {
  return std::max(turn(model, moved, row.i), turn(model, moved, row.j));
}

// A contact's corner and the ends of its edge.
struct Meeting {
  Vec2 at, from, to;

  Vec2 along() const { return (to - from).normalized(); }
  double gap() const { return cross(at - from, along()); }
};

Meeting before(const Model& model, const Contact& c) {
  const int end = model.shapes[size_t(c.j)].vertex_begin + model.next_vertex(c.j, c.edge);
  return {model.vertex[size_t(c.global_vertex)], model.vertex[size_t(c.global_edge)], model.vertex[size_t(end)]};
}

Meeting after(const Model& model, const std::vector<BlockState>& moved, const Contact& c) {
  const auto place = [&](int block, int vertex) {
    const BlockState& state = moved[size_t(block)];
    return model.vertex_at(block, state, Rotation::of(state.angle), vertex);
  };
  const int end = model.shapes[size_t(c.j)].vertex_begin + model.next_vertex(c.j, c.edge);
  return {place(c.i, c.global_vertex), place(c.j, c.global_edge), place(c.j, end)};
}

// m/s, of the gap, as the step begins.
double opening(const Model& model, const Contact& c, const ContactRows& row) {
  const auto speed = [&](int block, const Row& normal) {
    const int dofs = model.shapes[size_t(block)].dofs;
    return dot(normal, model.blocks[size_t(block)].velocity.data(), dofs > 0 ? dofs : rigid_dofs);
  };
  return speed(c.i, row.normal_i) + speed(c.j, row.normal_j);
}

// m, by which the straight line of this step begins above the end of that of the last, of a contact that pressed then:
// both are read at y as the step begins.
double parted(const Model& model, const Scheme& scheme, const Contact& c, const ContactRows& row) {
  const double faster = model.faster_along(c.i, row.normal_i) + model.faster_along(c.j, row.normal_j);
  const double gap = row.gap0 - scheme.step_v * opening(model, c, row) - scheme.bond_ahead * faster;
  const double parted = gap + c.normal_force / c.normal_stiffness;
  return std::abs(parted) > row.rounding ? parted : 0;
}

}  // namespace

double largest_turn_of_pressed(const Model& model, const std::vector<BlockState>& moved) {
  double largest = 0;
  for (const Contact& c : model.awake_contacts())
    if (c.normal_force > 0)
      for (const int b : {c.i, c.j}) largest = std::max(largest, turn(model, moved, b));
  return largest;
}

TurningWork work_of_turning(const Model& model, const ContactTerms& contacts, const Scheme& scheme, const Vector& d,
                            const std::vector<BlockState>& moved, double least, double straight) {
  TurningWork sum;
  for (const ContactRows& row : contacts.rows()) {
    const double turned = larger_turn(model, moved, row);
    if (turned <= least) continue;
    const double pressed = -contacts.gap(row, d);
    if (pressed <= 0) continue;
    const Contact& c = model.contacts[size_t(row.contact)];
    const double change = after(model, moved, c).gap() - before(model, c).gap();
    const double straight_on =
        scheme.step_v * opening(model, c, row) + scheme.move_d * row.along(row.normal_i, row.normal_j, d);
    const double work = row.kn * pressed * std::abs(change - straight_on);
    sum.all += work;
    if (turned > straight) sum.of_turns += work;
  }
  return sum;
}

Lift lift_of_turning(const Model& model, const ContactTerms& contacts, const Scheme& scheme, const Vector& d,
                     const std::vector<BlockState>& moved, double least) {
  // m/s at which the blocks part by the mean of the step's rates, were they where `blocks` has them and as rigid.
  const auto parting = [&](const Contact& c, const Meeting& meeting, const std::vector<BlockState>& blocks) {
    const Vec2 along = meeting.along(), normal = -perp(along), foot = meeting.at - meeting.gap() * normal;
    const auto speed = [&](int block, const Vec2& point) {
      const Rates &first = model.blocks[size_t(block)].velocity, &last = moved[size_t(block)].velocity;
      const auto mean = [&](int k) { return (first[k] + last[k]) / 2; };
      const double spin = mean(2) / model.shapes[size_t(block)].length;
      return normal.dot(Vec2(mean(0), mean(1)) + spin * perp(point - blocks[size_t(block)].centroid));
    };
    return speed(c.i, meeting.at) - speed(c.j, foot);
  };
  Lift lift;
  for (const ContactRows& row : contacts.rows()) {
    const double pressed = -contacts.gap(row, d);
    if (pressed <= 0) continue;
    const Contact& c = model.contacts[size_t(row.contact)];
    double by_bend = 0;
    if (larger_turn(model, moved, row) > least)
      by_bend = -scheme.bond_ahead * row.kn * pressed *
                (parting(c, after(model, moved, c), moved) - parting(c, before(model, c), model.blocks));
    const bool smooth = row.friction == 0 && row.cohesion == 0,
               went_on = c.normal_force > 0 && c.deeper == 0 && model.time > 0;
    lift.by_bend += by_bend;
    lift.by_law += smooth && went_on ? -row.kn * pressed * parted(model, scheme, c, row) : by_bend;
  }
  return lift;
}

}  // namespace talus
