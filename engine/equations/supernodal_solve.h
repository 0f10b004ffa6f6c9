#pragma once
// Back-substitution with a supernodal Cholesky factor in one loop: few blocks make supernodes of a few columns, and a
// call of BLAS for each is half of what a solve takes. In double precision on CHOLMOD's own values; in single precision
// on a copy, half the memory, which the solve of a large system is bound by, for iterations whose end does not depend
// on it: it leaves cond(K) × 6e-8 of the solution out.
#include <span>
#include <type_traits>
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

// The part of a factor that solves for some unknowns under forces on them alone: the supernodes that they lie in and
// all that those lead to.
struct FactorPart {
  std::vector<int> supernodes;  // rising
  std::vector<int> unknowns;    // of these, in the order of the factor
};
FactorPart part_of(const SupernodalFactor& factor, std::span<const int> unknowns);

template <class Scalar>
class SupernodalSolve {
 public:
  // Whether it can be had: its values are in the range of Scalar. The arrays have to last, values where they are not
  // copied.
  bool take(const SupernodalFactor& factor);
  // x = K⁻¹ b.
  void solve(const Vector& b, Vector& x) { solve(b, x, all_); }
  // The same at the unknowns of `part`, beyond which b is nought; of x it sets only these.
  void solve(const Vector& b, Vector& x, const FactorPart& part);

 private:
  static constexpr bool copies = !std::is_same_v<Scalar, double>;
  const Scalar* values() const {
    if constexpr (copies)
      return values_.data();
    else
      return whole_.values.data();
  }

  SupernodalFactor whole_;
  std::vector<Scalar> values_;   // of L where it is a copy
  std::vector<Scalar> inverse_;  // of L's diagonal
  std::vector<Scalar> y_, part_;
  FactorPart all_;
};

extern template class SupernodalSolve<float>;
extern template class SupernodalSolve<double>;

}  // namespace talus
