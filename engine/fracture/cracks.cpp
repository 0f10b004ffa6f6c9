#include "fracture/cracks.h"

#include <cmath>
#include <numbers>

#include "model/disjoint_sets.h"

namespace talus {

std::vector<int> cracks_at_nodes(const Model& model) {
  std::vector<int> crack(model.nodes.position.size(), -1);
  DisjointSets sets(crack.size());
  for (const Joint& joint : model.joints)
    if (joint.state == JointState::failed) sets.join(joint.node[0], joint.node[1]);
  for (const Joint& joint : model.joints)
    if (joint.state == JointState::failed)
      for (const int node : joint.node) crack[node] = sets.root(node);
  return counted(std::move(crack));
}

const char* failure_word(FailureMode mode) {
  return mode == FailureMode::none ? "none" : mode == FailureMode::tension ? "tension" : "shear";
}

const char* crack_word(CrackKind kind) {
  constexpr const char* words[] = {"none", "initiated", "propagated", "coalesced"};
  return words[int(kind)];
}

CrackKind crack_kind(const std::vector<int>& crack_at_node, const Joint& joint) {
  const int touched = (crack_at_node[joint.node[0]] >= 0) + (crack_at_node[joint.node[1]] >= 0);
  return touched == 0 ? CrackKind::initiated : touched == 1 ? CrackKind::propagated : CrackKind::coalesced;
}

double Fragment::size() const {
  return std::sqrt(4 * area / std::numbers::pi);
}

std::vector<Fragment> fragments(const Model& model) {
  const std::vector<int>& fragment = model.fragment;
  std::vector<Fragment> found;
  for (std::size_t b = 0; b < fragment.size(); ++b) {
    if (fragment[b] >= int(found.size())) {
      found.resize(fragment[b] + 1);
      found.back().first = int(b);
    }
    Fragment& f = found[fragment[b]];
    const double mass = model.mass(int(b));
    ++f.blocks;
    f.held = f.held || model.shapes[b].dofs == 0;
    f.shift += mass * model.blocks[b].shift;
    f.angle += mass * model.blocks[b].angle;
    f.area += model.area(int(b));
    f.mass += mass;
    f.centroid += mass * model.blocks[b].centroid;
    f.velocity += mass * Vec2(model.blocks[b].velocity[0], model.blocks[b].velocity[1]);
  }
  for (Fragment& f : found) {
    f.centroid /= f.mass;
    f.shift /= f.mass;
    f.angle /= f.mass;
    f.velocity /= f.mass;
  }
  for (const PointFixity& point : model.point_fixities) found[fragment[point.block]].held = true;
  for (const EdgeFixity& edge : model.edge_fixities) found[fragment[edge.block]].held = true;
  for (const ViscousEdge& edge : model.viscous_edges) found[fragment[edge.block]].held = true;
  return found;
}

CrackLengths crack_lengths(const Model& model) {
  CrackLengths lengths;
  for (const Joint& joint : model.joints) {
    if (joint.mode == FailureMode::none) continue;
    ++lengths.joints;
    (joint.mode == FailureMode::tension ? lengths.tension : lengths.shear) += joint.length;
  }
  return lengths;
}

}  // namespace talus
