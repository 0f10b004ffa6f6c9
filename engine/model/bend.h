#pragma once
// The quadratic part of a second-order block's displacement, in the block's own turning axes and of the undeformed arm
// X:
//   q(X) = Σ_k m_k(X) (b_k, b_{3+k}),   m = (X², XY, Y²)/l² less their means over the block.
// Less their means, so that the centroid is where it was; and as ∇m vanishes at the centroid, and its mean over the
// block too, the rotation and the strain of the block's middle, which are their means, are those of a first-order
// block. The six b are in metres.
#include <array>

#include "geometry/vec2.h"

namespace talus {

using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;
using BendArray = std::array<double, 6>;

struct Bend {
  double length;  // m, of the block
  Vec3 mean;      // of (X², XY, Y²)/l²

  Vec3 monomials(const Vec2& x) const {
    const double scale = 1 / (length * length);
    return scale * Vec3(x.x() * x.x(), x.x() * x.y(), x.y() * x.y()) - mean;
  }
  // Of the middle of a straight line along d, less the mean of its ends: as it bends.
  Vec3 rise(const Vec2& d) const {
    const double scale = -1 / (4 * length * length);
    return scale * Vec3(d.x() * d.x(), d.x() * d.y(), d.y() * d.y());
  }
  template <class Six>
  static Vec2 sum(const Vec3& m, const Six& b) {
    return {m[0] * b[0] + m[1] * b[1] + m[2] * b[2], m[0] * b[3] + m[1] * b[4] + m[2] * b[5]};
  }
  template <class Six>
  Vec2 displacement(const Vec2& x, const Six& b) const {
    return sum(monomials(x), b);
  }
  // (εx, εy, γxy) at X beside that of the middle, under unit b: 1/m.
  Matrix36 strain_rows(const Vec2& x) const {
    const double scale = 1 / (length * length), dx = scale * x.x(), dy = scale * x.y();
    Matrix36 rows;
    rows << 2 * dx, dy, 0, 0, 0, 0,  //
        0, 0, 0, 0, dx, 2 * dy,      //
        0, dx, 2 * dy, 2 * dx, dy, 0;
    return rows;
  }
  template <class Six>
  Vec3 strain(const Vec2& x, const Six& b) const {
    const double scale = 1 / (length * length), dx = scale * x.x(), dy = scale * x.y();
    return {2 * dx * b[0] + dy * b[1], dx * b[4] + 2 * dy * b[5],
            dx * b[1] + 2 * dy * b[2] + 2 * dx * b[3] + dy * b[4]};
  }
};

}  // namespace talus
