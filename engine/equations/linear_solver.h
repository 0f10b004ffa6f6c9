#pragma once
// Sparse Cholesky of a BlockMatrix (CHOLMOD, supernodal). The order is found once on the block graph and
// kept while the pattern lasts. The only room that knows SuiteSparse.
#include <memory>
#include <vector>

#include "equations/block_matrix.h"
#include "equations/coarse_solve.h"
#include "equations/compliance.h"

namespace talus {

class LinearSolver {
 public:
  LinearSolver();
  ~LinearSolver();

  // To be called after every change of pattern.
  void analyse(const BlockMatrix& matrix);
  // The block at which the matrix turned out not to be positive definite, or -1 when the factor is good.
  int factor(const BlockMatrix& matrix);
  // x = K⁻¹ b with the last factor.
  void solve(const Vector& b, Vector& x);
  // The same with an error of up to 1e-4 of x, in half the time: for iterations that solve() ends. The first after each
  // factor is exact, and finds whether that error is kept; where it is not all are.
  void solve_coarsely(const Vector& b, Vector& x);
  // The same for the unknowns of `part` alone, where b is nought beyond them; x elsewhere is of no use. part(): for
  // these, of the last factor.
  void solve_coarsely(const Vector& b, Vector& x, const FactorPart& part);
  FactorPart part(std::span<const int> unknowns) const;
  // Of the last factor, which it reads: no columns may be added after the next.
  Compliance compliance() const;

  long factorisations = 0;

 private:
  struct Cholmod;
  std::unique_ptr<Cholmod> cholmod_;
};

}  // namespace talus
