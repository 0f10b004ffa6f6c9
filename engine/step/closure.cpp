#include "step/closure.h"

#include <cmath>

#include "equations/block_terms.h"
#include "equations/bridge_law.h"
#include "equations/jump.h"
#include "step/energies.h"

namespace talus {

namespace {

bool pushes(const Contact& c) {
  return c.normal_force != 0 || c.shear_force != 0;
}

}  // namespace

Closure::Closure(const Model& model, const JointTerms& bonds, const std::vector<int>& joints)
    : bonds_(bonds),
      vertex_(model.vertex),
      blocks_(model.blocks),
      stored_(contact_energy(model.contacts)),
      virials_(virials(model, joints)) {
  for (const int j : joints) before_.push_back({j, model.joints[j].points, fluxes(model, j)});
  for (const Contact& c : model.contacts)
    if (pushes(c)) pushed_.push_back({c, contact_push(model, c), foot(model, c)});
}

double Closure::work(const Model& model, double friction) const {
  double sum = stored_ - contact_energy(model.contacts) - friction + of_turns(model);
  for (const Before& before : before_) sum += of_bond(model, before);
  const auto work_of = [&](const Contact& c, const Vec2& force, const Vec2& foot) {
    const size_t v = size_t(c.global_vertex);
    return force.dot(model.vertex[v] - vertex_[v] - way(model, c.j, foot));
  };
  for (const auto& [c, force, foot] : pushed_) sum -= work_of(c, force, foot) / 2;
  for (const Contact& c : model.contacts)
    if (pushes(c)) sum -= work_of(c, contact_push(model, c), foot(model, c)) / 2;
  return sum;
}

// Σ f·r of all forces on a block, by its equilibrium in strain: A tr σ of its stress and of what the jumps of its
// bonds, and of those that have just `failed`, strain it by. Of a rigid block by its bonds and contacts.
std::vector<double> Closure::virials(const Model& model, const std::vector<int>& failed) const {
  std::vector<double> virials(model.shapes.size(), 0);
  const auto rigid = [&](int block) { return model.shapes[size_t(block)].dofs == rigid_dofs; };
  const auto strained = [&](int block, const Vec3& strain) {
    const BlockShape& shape = model.shapes[size_t(block)];
    if (shape.dofs > rigid_dofs)
      virials[size_t(block)] += shape.area * (elasticity(model.material(block)) * strain).head<2>().sum();
  };
  const auto pushed = [&](int block, const Vec2& force, const Vec2& at) {
    if (rigid(block)) virials[size_t(block)] += force.dot(at - model.blocks[size_t(block)].centroid);
  };
  const auto bonded = [&](int j) {
    const Joint& joint = model.joints[size_t(j)];
    const auto [of_a, of_b] = bonds_.strain_of_jump(model, j, 0);
    strained(joint.a, of_a.head<3>());
    strained(joint.b, of_b.head<3>());
    if (!rigid(joint.a) && !rigid(joint.b)) return;
    const Vec2 normal = turned_normal(joint, flown(model, joint.a, 0), flown(model, joint.b, 0));
    for (const JointPoint& point : joint.points) {
      const Vec2 force = point.weight * (point.normal * normal + point.shear * perp(normal));
      pushed(joint.a, force, model.place(joint.a, between(joint.in_a, point.at)));
      pushed(joint.b, -force, model.place(joint.b, between(joint.in_b, point.at)));
    }
  };
  for (int b = 0; b < int(virials.size()); ++b) strained(b, model.blocks[size_t(b)].strain);
  for (int j = 0; j < int(model.joints.size()); ++j)
    if (model.joints[size_t(j)].state == JointState::intact) bonded(j);
  for (const int j : failed) bonded(j);
  for (const Contact& c : model.contacts) {
    if (!pushes(c) || (!rigid(c.i) && !rigid(c.j))) continue;
    const Vec2 force = contact_push(model, c);
    pushed(c.i, force, model.vertex[size_t(c.global_vertex)]);
    pushed(c.j, -force, model.place(c.j, foot(model, c)));
  }
  return virials;
}

// A block that turns by φ is strained in its own axes: of the work of all forces on it ½ (1 - cos φ) (Σ f·r after -
// before) is of its turn alone (docs/theory.md, § 12).
double Closure::of_turns(const Model& model) const {
  const std::vector<double> now = virials(model, {});
  double sum = 0;
  for (size_t b = 0; b < now.size(); ++b)
    sum += (1 - std::cos(model.blocks[b].angle - blocks_[b].angle)) / 2 * (now[b] - virials_[b]);
  return sum;
}

Vec2 Closure::foot(const Model& model, const Contact& c) {
  const int end = model.shapes[c.j].vertex_begin + model.next_vertex(c.j, c.edge);
  const Vec2& vertex = model.vertex[size_t(c.global_vertex)];
  const Vec2 from = model.vertex[size_t(c.global_edge)], edge = model.vertex[size_t(end)] - from;
  const double at = model.curved(c.j) ? model.curved_edge(c.j, c.edge).nearest(vertex)
                                      : (vertex - from).dot(edge) / edge.squaredNorm();
  return (1 - at) * model.reference_vertex[size_t(c.global_edge)] + at * model.reference_vertex[size_t(end)];
}

Vec2 Closure::way(const Model& model, int block, const Vec2& in_block) const {
  return model.place(block, in_block) - model.place(block, blocks_[size_t(block)], in_block);
}

double Closure::of_bond(const Model& model, const Before& before) const {
  const Joint& joint = model.joints[before.joint];
  const std::vector<BondTraction> flux = fluxes(model, before.joint);
  const auto then_of = [&](int block) { return flown(model.shapes[size_t(block)], blocks_[size_t(block)], 0); };
  const Vec2 normal = turned_normal(joint, then_of(joint.a), then_of(joint.b));
  double sum = 0;
  for (size_t p = 0; p < joint.points.size(); ++p) {
    const JointPoint& then = before.points[p];
    // its work is the bridge's to book
    const BondTraction bridged = from_path(joint, {then.across.traction, then.along.traction});
    const Vec2 traction = (then.normal - bridged.normal) * normal + (then.shear - bridged.shear) * perp(normal);
    const Vec2 parted =
        way(model, joint.b, between(joint.in_b, then.at)) - way(model, joint.a, between(joint.in_a, then.at));
    sum += then.weight / 2 *
           (traction.dot(parted) + (flux[p].normal - before.flux[p].normal) * then.opening +
            (flux[p].shear - before.flux[p].shear) * then.slip);
  }
  return sum;
}

std::vector<BondTraction> Closure::fluxes(const Model& model, int joint) const {
  std::vector<BondTraction> flux;
  for (const JointPoint& point : model.joints[joint].points) flux.push_back(bonds_.flux(model, joint, point.at));
  return flux;
}

}  // namespace talus
