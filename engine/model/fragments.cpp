#include "model/fragments.h"

#include "model/disjoint_sets.h"

namespace talus {

std::vector<int> find_fragments(const Model& model) {
  DisjointSets sets(model.shapes.size());
  for (const Joint& joint : model.joints)
    if (joint.state == JointState::intact) sets.join(joint.a, joint.b);
  std::vector<int> fragment(model.shapes.size());
  for (std::size_t b = 0; b < fragment.size(); ++b) fragment[b] = sets.root(int(b));
  return counted(std::move(fragment));
}

}  // namespace talus
