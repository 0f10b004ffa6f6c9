#pragma once
// What a few places of a structure give way under forces on each other, from its Cholesky factor.
#include <Eigen/Core>
#include <vector>

#include "equations/coarse_factor.h"

namespace talus {

struct SparseColumn {
  std::vector<int> unknowns;
  std::vector<double> values;
};

// W = Aᵀ K⁻¹ A, columns × columns, for K = P^T L Lᵀ P: the Gram matrix of L⁻¹ P A. Of L only the supernodes between a column's unknowns and
// the root of the elimination tree are read, a tenth of what solving for it would.
Eigen::MatrixXd compliance(const SupernodalFactor& factor, const std::vector<SparseColumn>& columns);

}  // namespace talus
