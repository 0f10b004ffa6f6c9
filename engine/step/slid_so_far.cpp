#include "step/slid_so_far.h"

#include <cmath>

#include "contact/hand_over.h"
#include "contact/narrow_phase.h"
#include "equations/kinematics.h"

namespace talus {

void slid_so_far(Model& model, const std::vector<BlockState>& start) {
  const auto moved = [&](int block, const Vec2& in_block) -> Vec2 {
    return flown(model, block, 0).displacement(in_block) -
           flown(model.shapes[size_t(block)], start[size_t(block)], 0).displacement(in_block);
  };
  for (Contact& c : model.contacts) {
    if (c.state != ContactState::open || c.stretch != 0) continue;
    const double near = meeting_distance(model, c.i, c.j);
    if (std::abs(c.gap) > near) continue;
    const int from = c.global_edge, to = model.shapes[size_t(c.j)].vertex_begin + model.next_vertex(c.j, c.edge);
    const auto of = [](const std::vector<Vec2>& all, int k) { return all[size_t(k)]; };
    const Vec2 span = of(model.vertex, to) - of(model.vertex, from);
    const double part = (of(model.vertex, c.global_vertex) - of(model.vertex, from)).dot(span) / span.squaredNorm();
    const Vec2 on_edge = (1 - part) * of(model.reference_vertex, from) + part * of(model.reference_vertex, to);
    const Vec2 normal = edge_normal(model, c),
               past = moved(c.i, of(model.reference_vertex, c.global_vertex)) - moved(c.j, on_edge);
    if (std::abs(c.gap - normal.dot(past)) <= near) c.stretch = perp(normal).dot(past);
  }
}

}  // namespace talus
