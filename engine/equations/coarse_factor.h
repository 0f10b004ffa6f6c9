#pragma once
// A Cholesky factor in single precision: half the memory, which a solve is bound by, and no call for each supernode. For
// iterations whose end does not depend on it: it leaves cond(K) × 6e-8 of the solution out.
#include <span>
#include <vector>

#include "equations/block_matrix.h"

namespace talus {

// A supernodal factor P K Pᵀ = L Lᵀ, as CHOLMOD has it. Of supernode s: columns first[s] up to first[s + 1]; the rows of each, its own
// columns foremost, rows[row_begin[s]…]; the values, column by column with all rows of each, values[value_begin[s]…].
struct SupernodalFactor {
  std::span<const int> order, first, row_begin, value_begin, rows;
  std::span<const double> values;
};

class CoarseFactor {
 public:
  // Whether it can be had: its values are in the range of single precision. The arrays but the values have to last.
  bool take(const SupernodalFactor& factor);
  // x = K⁻¹ b.
  void solve(const Vector& b, Vector& x);

 private:
  struct Supernode;
  Supernode supernode(size_t s) const;

  SupernodalFactor whole_;
  std::vector<float> values_;  // of L, its diagonal inverted
  std::vector<float> y_, part_;
};

}  // namespace talus
