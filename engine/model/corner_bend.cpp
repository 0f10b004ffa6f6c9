#include "model/corner_bend.h"

#include <Eigen/SVD>

namespace talus {

namespace {

// Singular values of the means, |cos(πk/n)|, that count: of three corners all are at least 0.5, of five 0.31. What is below is a
// zigzag of the corners that moves no edge much.
constexpr double least_singular = 0.25;

}  // namespace

std::vector<Vec3> corner_bend(const std::vector<Vec2>& corners, const Bend& bend) {
  const Eigen::Index n = Eigen::Index(corners.size());
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixX3d arc(n, 3);  // mean of the bent edge beyond that of the straight one
  for (Eigen::Index e = 0; e < n; ++e) {
    const Eigen::Index next = (e + 1) % n;
    mean(e, e) = mean(e, next) = 0.5;
    const Vec2 &p = corners[std::size_t(e)], &q = corners[std::size_t(next)];
    const Vec3 chord = (bend.monomials(p) + bend.monomials(q)) / 2;
    arc.row(e) = 2 * (bend.monomials((p + q) / 2) - chord) / 3;  // Simpson's rule, exact for what is quadratic
  }
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(mean, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(least_singular);  // of the largest, which is 1
  const Eigen::MatrixX3d moved = svd.solve(arc);
  std::vector<Vec3> result;
  for (Eigen::Index v = 0; v < n; ++v)
    result.push_back(bend.monomials(corners[std::size_t(v)]) + Vec3(moved.row(v).transpose()));
  return result;
}

}  // namespace talus
