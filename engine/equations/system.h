#pragma once
// The linear part of a step: K d = f for everything but contacts.
#include <algorithm>
#include <limits>

#include "equations/block_matrix.h"
#include "equations/kinematics.h"

namespace talus {

// A block's part of a vector of all unknowns, padded with noughts; of one with more than n unknowns the first.
template <int n>
ColumnOf<n> of_block(const BlockShape& shape, const Vector& x) {
  ColumnOf<n> own = ColumnOf<n>::Zero();
  for (int k = 0; k < std::min(shape.dofs, n); ++k) own[k] = x[shape.dof_begin + k];
  return own;
}

struct System {
  BlockMatrix matrix;
  Vector force;  // at d = 0
  // Sum of the magnitudes of the forces that meet in a block (N): what its residual is compared with.
  std::vector<double> force_scale;
  // What the rounding of displacements does to them (N): stiff bonds multiply it, and no iteration removes it.
  std::vector<double> force_rounding;

  // But for the matrix, which add_block_terms() begins.
  void clear(const Model& model) {
    force.setZero(model.dofs);
    force_scale.assign(model.shapes.size(), 0.0);
    force_rounding.assign(model.shapes.size(), 0.0);
  }
  template <int n>
  void add_force(const BlockShape& shape, int block, const ColumnOf<n>& f) {
    for (int k = 0; k < shape.dofs; ++k) force[shape.dof_begin + k] += f[k];
    force_scale[block] += f.norm();
  }
  // A spring of `stiffness` N/m against displacements (m) of this size.
  void add_rounding(int block, double stiffness, double displacement) {
    force_rounding[block] += 8 * std::numeric_limits<double>::epsilon() * stiffness * displacement;
  }
};

}  // namespace talus
