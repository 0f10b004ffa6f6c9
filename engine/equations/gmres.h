#pragma once
// GMRES (Saad & Schultz 1986) without restart: for the few unsymmetric solves whose symmetric part is already factored.
#include <cmath>
#include <vector>

#include "equations/block_matrix.h"

namespace talus {

// Solves A x = b from x = 0 until the residual has fallen to `tolerance` of the first; returns the number of products
// with A. `apply(x, y)` gives y = A x and may reuse y.
template <typename Apply>
int gmres(const Apply& apply, const Vector& b, double tolerance, int most, Vector& x) {
  std::vector<Vector> basis;
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(most + 1, most);
  Vector rhs = Vector::Zero(most + 1), z;
  std::vector<double> c(most), s(most);  // Givens rotations
  rhs[0] = b.norm();
  x.setZero(b.size());
  if (rhs[0] == 0) return 0;
  basis.push_back(b / rhs[0]);
  const double enough = tolerance * rhs[0];
  int k = 0;
  while (k < most && std::abs(rhs[k]) > enough) {
    apply(basis[k], z);
    for (int i = 0; i <= k; ++i) {  // modified Gram–Schmidt
      h(i, k) = z.dot(basis[i]);
      z -= h(i, k) * basis[i];
    }
    h(k + 1, k) = z.norm();
    const bool exhausted = h(k + 1, k) <= 1e-14 * h.col(k).head(k + 1).norm();
    for (int i = 0; i < k; ++i) {
      const double above = h(i, k);
      h(i, k) = c[i] * above + s[i] * h(i + 1, k);
      h(i + 1, k) = -s[i] * above + c[i] * h(i + 1, k);
    }
    const double length = std::hypot(h(k, k), h(k + 1, k));
    if (length == 0) break;  // A is singular along the last direction
    c[k] = h(k, k) / length;
    s[k] = h(k + 1, k) / length;
    if (!exhausted) basis.push_back(z / h(k + 1, k));
    h(k, k) = length;
    rhs[k + 1] = -s[k] * rhs[k];
    rhs[k] *= c[k];
    ++k;
    if (exhausted) break;
  }
  const Vector weights = h.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(rhs.head(k));
  for (int i = 0; i < k; ++i) x += weights[i] * basis[i];
  return k;
}

}  // namespace talus
