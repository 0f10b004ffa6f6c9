#pragma once
// One side of a bond: a block's face at the configuration of linearisation, and the traction its strain gives
// there.
#include "equations/kinematics.h"

namespace talus {

using Matrix23 = Eigen::Matrix<double, 2, 3>;

// (σx, σy, τ) -> traction on a face of normal n.
inline Matrix23 traction_of(const Vec2& n) {
  Matrix23 m;
  m << n.x(), 0, n.y(), 0, n.y(), n.x();
  return m;
}

struct Side {
  const Pose& pose;
  Mat3 elasticity;
  Vec3 initial_stress;
  Vec2 normal;    // reference
  double weight;  // share in the flux

  Vec2 traction(const Vec3& strain) const {
    return pose.rotation.turn(traction_of(normal) * (initial_stress + elasticity * strain));
  }
  // Weighted traction under unit unknowns.
  DofRows flux() const {
    DofRows s = DofRows::Zero();
    const Matrix23 own = (weight / pose.length) * traction_of(normal) * elasticity;
    for (int k = 0; k < 3; ++k) s.col(3 + k) = pose.rotation.turn(own.col(k));
    return s;
  }
  Vec3 strain_at(double seconds) const {
    return pose.strain + seconds / pose.length * Vec3(pose.velocity[3], pose.velocity[4], pose.velocity[5]);
  }
};

inline Side side_of(const Model& model, const Pose& pose, int block, const Vec2& normal, double weight) {
  return {pose, elasticity(model.material(block)), model.shapes[block].initial_stress, normal, weight};
}

// {σ}n, the weighted mean of both sides' tractions, with the strains `seconds` ahead.
inline Vec2 mean_flux(const Side& a, const Side& b, double seconds) {
  return a.weight * a.traction(a.strain_at(seconds)) + b.weight * b.traction(b.strain_at(seconds));
}

inline Vec2 between(const std::array<Vec2, 2>& ends, double at) {
  return (1 - at) * ends[0] + at * ends[1];
}

}  // namespace talus
