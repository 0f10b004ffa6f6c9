#include "step/closure.h"

#include "equations/bridge_law.h"
#include "step/energies.h"

namespace talus {

namespace {

bool pushes(const Contact& c) { return c.normal_force != 0 || c.shear_force != 0; }

}  // namespace

Closure::Closure(const Model& model, const JointTerms& bonds, const std::vector<int>& joints)
    : bonds_(bonds), vertex_(model.vertex), stored_(contact_energy(model.contacts)) {
  std::vector<char> fails(model.joints.size(), 0);
  for (const int j : joints) {
    fails[size_t(j)] = 1;
    before_.push_back({j, model.joints[j].points, fluxes(model, j)});
  }
  for (const Contact& c : model.contacts)
    if (pushes(c) && (c.joint < 0 || !fails[size_t(c.joint)])) pushed_.push_back({c, contact_push(model, c)});
}

double Closure::work(const Model& model, double friction) const {
  double sum = stored_ - contact_energy(model.contacts) - friction;
  for (const Before& before : before_) sum += of_bond(model, before);
  for (const auto& [c, force] : pushed_) sum -= force.dot(moved(model, c, vertex_)) / 2;
  for (const Contact& c : model.contacts)
    if (pushes(c)) sum -= contact_push(model, c).dot(moved(model, c, model.vertex)) / 2;
  return sum;
}

// A corner from the point of the edge that it lies beside when the force acts, m: what slides by s along an edge that turns by φ would do work N s φ / 2 otherwise.
Vec2 Closure::moved(const Model& model, const Contact& c, const std::vector<Vec2>& as_it_acts) const {
  const int end = model.shapes[c.j].vertex_begin + model.next_vertex(c.j, c.edge);
  const Vec2 from = as_it_acts[size_t(c.global_edge)], edge = as_it_acts[size_t(end)] - from;
  const double at = (as_it_acts[size_t(c.global_vertex)] - from).dot(edge) / edge.squaredNorm();
  const auto way = [&](int v) -> Vec2 { return model.vertex[v] - vertex_[v]; };
  return way(c.global_vertex) - (1 - at) * way(c.global_edge) - at * way(end);
}

double Closure::of_bond(const Model& model, const Before& before) const {
  const Joint& joint = model.joints[before.joint];
  const std::vector<BondTraction> flux = fluxes(model, before.joint);
  double sum = 0;
  for (size_t p = 0; p < joint.points.size(); ++p) {
    const JointPoint &now = joint.points[p], &then = before.points[p];
    const BondTraction bridged = from_path(joint, {then.across.traction, then.along.traction});  // its work is the bridge's to book
    sum += now.weight / 2 *
           ((then.normal - bridged.normal) * (now.opening - then.opening) + (then.shear - bridged.shear) * (now.slip - then.slip) +
            (flux[p].normal - before.flux[p].normal) * then.opening + (flux[p].shear - before.flux[p].shear) * then.slip);
  }
  return sum;
}

std::vector<BondTraction> Closure::fluxes(const Model& model, int joint) const {
  std::vector<BondTraction> flux;
  for (const JointPoint& point : model.joints[joint].points) flux.push_back(bonds_.flux(model, joint, point.at));
  return flux;
}

}  // namespace talus
