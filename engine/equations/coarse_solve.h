#pragma once
// Back-substitution with a supernodal Cholesky factor in single precision, for iterations whose end does not depend on
// it: it leaves cond(K) × 6e-8 of the solution out. With small supernodes it is not memory that a solve waits for but
// one unknown after the other: here each panel of a few columns takes its unknowns at once, by the inverse of its
// square.
#include <span>
#include <vector>

#include "equations/supernodal_solve.h"

namespace talus {

// The part of a factor that solves for some unknowns under forces on them alone: the supernodes that they lie in and
// all that those lead to.
struct FactorPart {
  std::vector<int> supernodes;  // rising
  std::vector<int> unknowns;    // those asked for, by their places in the order of the factor
};
FactorPart part_of(const SupernodalFactor& factor, std::span<const int> unknowns);

// P K Pᵀ = N D Nᵀ by panels: D the squares on the diagonal, N = 1 there and B below. With L of the Cholesky factor and
// L₀ its square, D = L₀ L₀ᵀ and B = L L₀⁻¹.
class CoarseSolve {
 public:
  // Of so many columns from `first` on. What it reads and changes of y below lies in chunks of `wide`, from the
  // unknowns chunks_[chunk_begin…] on.
  struct Panel {
    int first, columns;
    int chunk_begin, chunk_end;
    size_t below;   // where values of B begin: chunk by chunk, its columns one after the other
    size_t square;  // and those of D⁻¹, column by column
  };
  static constexpr int wide = 8;  // as many columns a panel has at most

  // Whether it can be had: its values are in the range of single precision. The order has to last.
  bool take(const SupernodalFactor& factor);
  // x = K⁻¹ b.
  void solve(const Vector& b, Vector& x) { solve(b, x, all_); }
  // The same at the unknowns of `part`, beyond which b is nought; of x it sets only these.
  void solve(const Vector& b, Vector& x, const FactorPart& part);

 private:
  void lay_out(const SupernodalFactor& factor);
  bool fill(const SupernodalFactor& factor, size_t supernode);

  std::span<const int> order_;
  std::vector<Panel> panels_;
  std::vector<int> panel_begin_;  // of each supernode
  std::vector<int> chunks_;
  std::vector<float> below_, squares_;
  std::vector<float> y_;
  FactorPart all_;
};

}  // namespace talus
