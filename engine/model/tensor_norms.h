#pragma once
// Sizes of a block's strain and bend that are the same in whatever axes they are told: steps and searches go by them,
// and a scene that is turned is to take the same.
#include <cmath>

#include "model/bend.h"

namespace talus {

// Of (εx, εy, γxy), as a tensor (Frobenius).
inline double tensor_norm(const Vec3& strain) {
  return std::sqrt(strain[0] * strain[0] + strain[1] * strain[1] + strain[2] * strain[2] / 2);
}

// m, of the six of a bend, as two quadratic forms: |q(X)| <= |X|²/l² times it.
template <class Six>
double bend_norm(const Six& b) {
  return std::sqrt(b[0] * b[0] + b[1] * b[1] / 2 + b[2] * b[2] + b[3] * b[3] + b[4] * b[4] / 2 + b[5] * b[5]);
}

}  // namespace talus
