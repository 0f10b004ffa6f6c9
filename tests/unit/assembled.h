#pragma once
#include <Eigen/Dense>
#include <utility>
#include <vector>

#include "equations/block_terms.h"
#include "equations/boundary_terms.h"
#include "equations/joint_terms.h"

namespace talus::test {

using Dense = Eigen::MatrixXd;

// K and f of a model without contacts, as a step assembles them; with room for those between `touching` blocks.
struct Assembled {
  Poses poses;
  System system;
  JointTerms joints;
  Supports supports;

  explicit Assembled(const Model& model, const Scheme& scheme = Scheme::equilibrium(), bool bonds = true,
                     std::vector<std::pair<int, int>> touching = {}) {
    std::vector<std::pair<int, int>> pairs = std::move(touching);
    std::vector<int> sizes;
    for (const Joint& joint : model.joints) pairs.push_back({joint.a, joint.b});
    for (const BlockShape& shape : model.shapes) sizes.push_back(shape.dofs);
    system.matrix.set_pattern(sizes, pairs);
    joints.prepare(model);
    joints.find_slots(model, system.matrix);
    system.clear(model);
    poses.predict(model, scheme);
    add_block_terms(model, poses, scheme, system);
    if (bonds) {
      joints.add(model, poses, scheme, system);
      supports.prepare(model, joints.ground_stiffness());
      supports.add(model, poses, scheme, system);
    }
    add_loads(model, poses, scheme, system);
  }
  Dense dense() const {
    const int n = system.matrix.dimension();
    Dense k = Dense::Zero(n, n);
    for (int j = 0; j < n; ++j) {
      Vector column = Vector::Zero(n);
      system.matrix.multiply(Vector::Unit(n, j), column);
      k.col(j) = column;
    }
    return k;
  }
};

}  // namespace talus::test
