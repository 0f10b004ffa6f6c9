#include "step/closure.h"

#include <Eigen/Geometry>

#include "equations/bridge_law.h"
#include "equations/jump.h"
#include "model/fragments.h"
#include "step/energies.h"

namespace talus {

namespace {

bool pushes(const Contact& c) { return c.normal_force != 0 || c.shear_force != 0; }

}  // namespace

Closure::Closure(const Model& model, const JointTerms& bonds, const std::vector<int>& joints)
    : bonds_(bonds), vertex_(model.vertex), blocks_(model.blocks), stored_(contact_energy(model.contacts)) {
  std::vector<char> fails(model.joints.size(), 0);
  for (const int j : joints) {
    fails[size_t(j)] = 1;
    before_.push_back({j, model.joints[j].points, fluxes(model, j)});
  }
  for (const Contact& c : model.contacts)
    if (pushes(c) && (c.joint < 0 || !fails[size_t(c.joint)])) pushed_.push_back({c, contact_push(model, c), foot(model, c)});
}

double Closure::work(const Model& model, double friction) const {
  const std::vector<Body> bodies = bodies_of(model);
  double sum = stored_ - contact_energy(model.contacts) - friction;
  for (const Before& before : before_) sum += of_bond(model, bodies, before);
  const auto work_of = [&](const Contact& c, const Vec2& force, const Vec2& foot, bool acts_then) {
    const size_t v = size_t(c.global_vertex);
    return force.dot(way(model, bodies, c.i, vertex_[v], model.vertex[v], acts_then) - way(model, bodies, c.j, foot, acts_then));
  };
  for (const auto& [c, force, foot] : pushed_) sum -= work_of(c, force, foot, true) / 2;
  for (const Contact& c : model.contacts)
    if (pushes(c)) sum -= work_of(c, contact_push(model, c), foot(model, c), false) / 2;
  return sum;
}

Vec2 Closure::foot(const Model& model, const Contact& c) {
  const int end = model.shapes[c.j].vertex_begin + model.next_vertex(c.j, c.edge);
  const Vec2& vertex = model.vertex[size_t(c.global_vertex)];
  const Vec2 from = model.vertex[size_t(c.global_edge)], edge = model.vertex[size_t(end)] - from;
  const double at = model.curved(c.j) ? model.curved_edge(c.j, c.edge).nearest(vertex) : (vertex - from).dot(edge) / edge.squaredNorm();
  return (1 - at) * model.reference_vertex[size_t(c.global_edge)] + at * model.reference_vertex[size_t(end)];
}

std::vector<Closure::Body> Closure::bodies_of(const Model& model) const {
  const std::vector<int> body = find_fragments(model);
  std::vector<Body> all(model.shapes.size());
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const double area = model.shapes[b].area;
    Body& of = all[size_t(body[b])];
    of.area += area;
    of.then += area * blocks_[b].centroid;
    of.now += area * model.blocks[b].centroid;
    of.turn += area * (model.blocks[b].angle - blocks_[b].angle);
  }
  for (Body& of : all)
    if (of.area > 0) of.then /= of.area, of.now /= of.area, of.turn /= of.area;
  const auto held = [&](int block) { all[size_t(body[size_t(block)])].turn = 0; };
  for (const PointFixity& of : model.point_fixities) held(of.block);
  for (const EdgeFixity& of : model.edge_fixities) held(of.block);
  std::vector<Body> result;
  for (const int of : body) result.push_back(all[size_t(of)]);
  return result;
}

// m, that a force on a point of a body works along: as the body moves, turns by φ, with the moment that the force has as it acts, and is strained in its own axes.
// Along the whole way, φ × r - ½ φ² r, stresses would do the work -½ φ² Σ f·r, though nothing but the body turns. One that is supported does not turn: a support's
// force, which does no work, is part of that sum.
Vec2 Closure::way(const Model& model, const std::vector<Body>& bodies, int block, const Vec2& then, const Vec2& now, bool acts_then) const {
  if (model.shapes[size_t(block)].dofs == 0) return now - then;
  const Body& of = bodies[size_t(block)];
  const Vec2 before = then - of.then, after = now - of.now;
  const Eigen::Rotation2Dd turn(of.turn);
  return of.now - of.then + of.turn * perp(acts_then ? before : after) + (acts_then ? turn.inverse() * after - before : after - turn * before);
}

Vec2 Closure::way(const Model& model, const std::vector<Body>& bodies, int block, const Vec2& in_block, bool acts_then) const {
  return way(model, bodies, block, model.place(block, blocks_[size_t(block)], in_block), model.place(block, in_block), acts_then);
}

double Closure::of_bond(const Model& model, const std::vector<Body>& bodies, const Before& before) const {
  const Joint& joint = model.joints[before.joint];
  const std::vector<BondTraction> flux = fluxes(model, before.joint);
  const auto then_of = [&](int block) { return flown(model.shapes[size_t(block)], blocks_[size_t(block)], 0); };
  const Vec2 normal = turned_normal(joint, then_of(joint.a), then_of(joint.b));
  double sum = 0;
  for (size_t p = 0; p < joint.points.size(); ++p) {
    const JointPoint& then = before.points[p];
    const BondTraction bridged = from_path(joint, {then.across.traction, then.along.traction});  // its work is the bridge's to book
    const Vec2 traction = (then.normal - bridged.normal) * normal + (then.shear - bridged.shear) * perp(normal);
    const Vec2 parted = way(model, bodies, joint.b, between(joint.in_b, then.at), true) - way(model, bodies, joint.a, between(joint.in_a, then.at), true);
    sum += then.weight / 2 *
           (traction.dot(parted) + (flux[p].normal - before.flux[p].normal) * then.opening + (flux[p].shear - before.flux[p].shear) * then.slip);
  }
  return sum;
}

std::vector<BondTraction> Closure::fluxes(const Model& model, int joint) const {
  std::vector<BondTraction> flux;
  for (const JointPoint& point : model.joints[joint].points) flux.push_back(bonds_.flux(model, joint, point.at));
  return flux;
}

}  // namespace talus
