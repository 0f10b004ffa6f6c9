#pragma once
// What a few places of a structure give way under forces on each other, from its Cholesky factor.
#include <Eigen/Core>
#include <vector>

#include "equations/supernodal_solve.h"

namespace talus {

struct SparseColumn {
  std::vector<int> unknowns;
  std::vector<double> values;
};

// W = Aᵀ K⁻¹ A, columns × columns, for P K Pᵀ = L Lᵀ: the Gram matrix of L⁻¹ P A. All unknowns of a column belong to blocks that K couples
// with each other, as those of a contact do, and so lie on one path to the root of the elimination tree: of L that path alone is read, a tenth
// of what a solution would.
Eigen::MatrixXd compliance(const SupernodalFactor& factor, const std::vector<SparseColumn>& columns);

}  // namespace talus
