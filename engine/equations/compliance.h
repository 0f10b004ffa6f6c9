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

// W = Aᵀ K⁻¹ A, columns × columns, for P K Pᵀ = L Lᵀ: the Gram matrix of L⁻¹ P A. All unknowns of a column belong to
// blocks that K couples with each other, as those of a contact do, and so lie on one path to the root of the
// elimination tree: of L that path alone is read, a tenth of what a solution would. Columns may join those that are
// there, whose part is kept.
class Compliance {
 public:
  // Of no columns. The factor is read as long as some are added.
  explicit Compliance(const SupernodalFactor& factor);
  void add(const std::vector<SparseColumn>& columns);
  const Eigen::MatrixXd& matrix() const { return w_; }

 private:
  // Columns that were added at once, in the order in which they begin.
  struct Part {
    Eigen::MatrixXd x;                      // L⁻¹ P A, unknowns × columns
    std::vector<int> sorted, begin;         // their numbers in W; where each begins, in the order of the factor
    Eigen::Index until(int unknown) const;  // columns that begin before it
  };
  Part sort(const std::vector<SparseColumn>& columns) const;

  SupernodalFactor factor_;
  std::vector<int> place_;  // of each unknown, in the order of the factor
  std::vector<int> below_;  // of each supernode: where what reaches it begins
  std::vector<Part> parts_;
  Eigen::MatrixXd w_;
};

}  // namespace talus
