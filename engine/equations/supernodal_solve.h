#pragma once
// Back-substitution with a supernodal Cholesky factor in one loop, on CHOLMOD's own values: few blocks make supernodes
// of a few columns, and a call of BLAS for each is half of what a solve takes.
#include <span>
#include <vector>

#include "equations/block_matrix.h"

namespace talus {

// A supernodal factor P K Pᵀ = L Lᵀ, as CHOLMOD has it. Of supernode s: columns first[s] up to first[s + 1]; the rows
// of each, its own columns foremost, rows[row_begin[s]…]; the values, column by column with all rows of each,
// values[value_begin[s]…].
struct SupernodalFactor {
  std::span<const int> order, first, row_begin, value_begin, rows;
  std::span<const double> values;
};

class SupernodalSolve {
 public:
  void take(const SupernodalFactor& factor);  // whose arrays have to last
  // x = K⁻¹ b.
  void solve(const Vector& b, Vector& x);

 private:
  SupernodalFactor whole_;
  std::vector<double> inverse_;  // of L's diagonal
  std::vector<double> y_, part_;
};

}  // namespace talus
