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
  Vec2 normal;                      // reference
  double weight;                    // share in the flux
  const QuadraticShape* quadratic;  // of a second-order block

  Vec2 traction(const Vec3& strain) const {
    return pose.rotation.turn(traction_of(normal) * (initial_stress + elasticity * strain));
  }
  // At a material point, `seconds` ahead: another from point to point in a second-order block.
  Vec2 traction_at(const Vec2& in_block, double seconds) const {
    const Vec2 mean = traction(strain_at(seconds));
    return pose.bend ? Vec2(mean + varying_traction(in_block, seconds)) : mean;
  }
  Vec2 varying_traction(const Vec2& in_block, double seconds) const;
  // Weighted traction under unit unknowns.
  DofRows flux() const {
    DofRows s = DofRows::Zero();
    const Matrix23 own = (weight / pose.length) * traction_of(normal) * elasticity;
    for (int k = 0; k < 3; ++k) s.col(3 + k) = pose.rotation.turn(own.col(k));
    return s;
  }
  // The same where blocks of second order may be among others, at a material point.
  template <int n>
  RowsOf<n> flux(const Vec2& in_block) const {
    if constexpr (n == first_order_dofs) {
      return flux();
    } else {
      RowsOf<n> s = RowsOf<n>::Zero();
      s.template leftCols<first_order_dofs>() = flux();
      if (!pose.bend) return s;
      const Eigen::Matrix<double, 2, 6> own =
          weight * traction_of(normal) * elasticity * pose.bend->shape.strain_rows(in_block);
      for (int k = 0; k < 6; ++k) s.col(first_order_dofs + k) = pose.rotation.turn(own.col(k));
      return s;
    }
  }
  Vec3 strain_at(double seconds) const {
    return pose.strain + seconds / pose.length * Vec3(pose.velocity[3], pose.velocity[4], pose.velocity[5]);
  }
};

template <int n = max_dofs>
Side side_of(const Model& model, const Pose& pose, int block, const Vec2& normal, double weight) {
  const BlockShape& shape = model.shapes[block];
  const QuadraticShape* quadratic = nullptr;
  if constexpr (n > first_order_dofs)
    if (shape.second_order()) quadratic = &model.quadratic_shapes[shape.quadratic];
  return {pose, elasticity(model.material(block)), shape.initial_stress, normal, weight, quadratic};
}

// {σ}n, the weighted mean of both sides' tractions, with the strains `seconds` ahead.
inline Vec2 mean_flux(const Side& a, const Side& b, double seconds) {
  return a.weight * a.traction(a.strain_at(seconds)) + b.weight * b.traction(b.strain_at(seconds));
}

// The same at material points of both, where one of them is of second order.
Vec2 mean_flux(const Side& a, const Vec2& in_a, const Side& b, const Vec2& in_b, double seconds);

inline Vec2 between(const std::array<Vec2, 2>& ends, double at) {
  return (1 - at) * ends[0] + at * ends[1];
}

}  // namespace talus
