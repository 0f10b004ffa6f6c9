#include "step/turning.h"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

double turn(const Model& model, const std::vector<BlockState>& moved, int block) {
  return std::abs(moved[size_t(block)].angle - model.blocks[size_t(block)].angle);
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
  const auto gap = [](const Vec2& at, const Vec2& from, const Vec2& to) {
    return cross(at - from, (to - from).normalized());
  };
  const auto after = [&](int block, int vertex) {
    const BlockState& state = moved[size_t(block)];
    return model.vertex_at(block, state, Rotation::of(state.angle), vertex);
  };
  TurningWork sum;
  for (const ContactRows& row : contacts.rows()) {
    const double turned = std::max(turn(model, moved, row.i), turn(model, moved, row.j));
    if (turned <= least) continue;
    const double pressed = -(row.gap0 + contacts.factor() * row.along(row.normal_i, row.normal_j, d));
    if (pressed <= 0) continue;
    const Contact& c = model.contacts[size_t(row.contact)];
    const int at = c.global_vertex, from = c.global_edge,
              to = model.shapes[size_t(c.j)].vertex_begin + model.next_vertex(c.j, c.edge);
    const double change = gap(after(c.i, at), after(c.j, from), after(c.j, to)) -
                          gap(model.vertex[size_t(at)], model.vertex[size_t(from)], model.vertex[size_t(to)]);
    const auto velocity = [&](int block, const Row& normal) {
      const int dofs = model.shapes[size_t(block)].dofs;
      return dot(normal, model.blocks[size_t(block)].velocity.data(), dofs > 0 ? dofs : rigid_dofs);
    };
    const double straight_on = scheme.step_v * (velocity(c.i, row.normal_i) + velocity(c.j, row.normal_j)) +
                               scheme.move_d * row.along(row.normal_i, row.normal_j, d);
    const double work = row.kn * pressed * std::abs(change - straight_on);
    sum.all += work;
    if (turned > straight) sum.of_turns += work;
  }
  return sum;
}

}  // namespace talus
