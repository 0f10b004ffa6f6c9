#pragma once
// Blocks at the configuration a step is linearised about, and the rows that take unknowns to displacements.
#include <array>
#include <vector>

#include "equations/scheme.h"
#include "model/model.h"

namespace talus {

using FirstRow = std::array<double, first_order_dofs>;
using Row = std::array<double, max_dofs>;

// What a second-order block's pose has beside.
struct PoseBend {
  Bend shape;
  BendArray now, rate;  // m, m/s
};

// What has a size asks for the bend only where second-order blocks may be among others: n = first_order_dofs says there
// are none, and saves all of it.
struct Pose {
  Vec2 shift, centroid;
  Rotation rotation;
  Vec3 strain;    // block axes
  double length;  // m, the block's scale
  std::array<double, first_order_dofs> velocity;
  Apart<PoseBend> bend;

  template <int n = max_dofs>
  Vec2 place(const Vec2& in_block) const {
    const Vec2 linear((1 + strain[0]) * in_block.x() + strain[2] / 2 * in_block.y(),
                      strain[2] / 2 * in_block.x() + (1 + strain[1]) * in_block.y());
    const Vec2 straight = centroid + rotation.turn(linear);
    if constexpr (n == first_order_dofs)
      return straight;
    else
      return bend ? Vec2(straight + bent(in_block, bend->now)) : straight;
  }
  // place - reference place, from displacements alone: (R - I) X + R (e X + q) + shift.
  template <int n = max_dofs>
  Vec2 displacement(const Vec2& in_block) const {
    const double x = in_block.x(), y = in_block.y(), c1 = rotation.c1();
    const Vec2 turned(c1 * x - rotation.s * y, rotation.s * x + c1 * y);
    const Vec2 linear(strain[0] * x + strain[2] / 2 * y, strain[2] / 2 * x + strain[1] * y);
    const Vec2 straight = shift + turned + rotation.turn(linear);
    if constexpr (n == first_order_dofs)
      return straight;
    else
      return bend ? Vec2(straight + bent(in_block, bend->now)) : straight;
  }
  // Derivative of the place of the material point now at `at`, along `direction`, by the unknowns: of place() above, so
  // that strain works on the undeformed arm (Shi 1988 takes the deformed one, which makes every stress wrong by its
  // strain). In the block's own axes, divided by its length. A rigid block uses the first three.
  FirstRow row(const Vec2& at, const Vec2& direction) const {
    const Vec2 x = rotation.back(at - centroid) / length, n = rotation.back(direction);
    const double a = 1 + strain[0], b = strain[2] / 2, c = 1 + strain[1], det = a * c - b * b;
    const Vec2 arm((c * x.x() - b * x.y()) / det, (a * x.y() - b * x.x()) / det);
    return {direction.x(),   direction.y(),   cross(x, n),
            arm.x() * n.x(), arm.y() * n.y(), (arm.y() * n.x() + arm.x() * n.y()) / 2};
  }
  template <int n = max_dofs>
  Vec2 velocity_at(const Vec2& in_block) const {
    const Vec2 arm = place<n>(in_block) - centroid;
    const double x = in_block.x(), y = in_block.y();
    const auto& v = velocity;
    const Vec2 linear = Vec2(v[0], v[1]) + v[2] / length * perp(arm) +
                        rotation.turn(Vec2(v[3] * x + v[5] / 2 * y, v[5] / 2 * x + v[4] * y)) / length;
    if constexpr (n == first_order_dofs)
      return linear;
    else
      return bend ? Vec2(linear + bent(in_block, bend->rate)) : linear;
  }
  DofRows rows(const Vec2& at) const {
    const FirstRow x = row(at, Vec2::UnitX()), y = row(at, Vec2::UnitY());
    DofRows t;
    for (int k = 0; k < first_order_dofs; ++k) {
      t(0, k) = x[k];
      t(1, k) = y[k];
    }
    return t;
  }
  // The same where blocks of second order may be among others. Theirs are of the material point `in_block`, on whose
  // undeformed arm strain and bend work, but turn about the centroid what is at `at`.
  template <int n>
  RowsOf<n> rows(const Vec2& in_block, const Vec2& at) const {
    if constexpr (n == first_order_dofs) {
      return rows(at);
    } else {
      RowsOf<n> t = RowsOf<n>::Zero();
      if (!bend) {
        t.template leftCols<first_order_dofs>() = rows(at);
        return t;
      }
      const Vec2 x = in_block / length, across = rotation.turn(Vec2::UnitX()), up = rotation.turn(Vec2::UnitY());
      t.template leftCols<2>().setIdentity();
      t.col(2) = perp(at - centroid) / length;
      t.col(3) = x.x() * across;
      t.col(4) = x.y() * up;
      t.col(5) = (x.y() * across + x.x() * up) / 2;
      const Vec3 m = bend->shape.monomials(in_block);
      for (int k = 0; k < 3; ++k) {
        t.col(first_order_dofs + k) = m[k] * across;
        t.col(first_order_dofs + 3 + k) = m[k] * up;
      }
      return t;
    }
  }
  // R q(X); outside the header, so that what has no bend is compiled as if there were none.
  Vec2 bent(const Vec2& in_block, const BendArray& b) const;
  // Rates of the unknowns, padded with noughts.
  template <int n>
  ColumnOf<n> rates() const {
    ColumnOf<n> v = ColumnOf<n>::Zero();
    v.template head<first_order_dofs>() = Eigen::Map<const DofColumn>(velocity.data());
    if constexpr (n > first_order_dofs)
      if (bend) v.template tail<6>() = Eigen::Map<const Vec6>(bend->rate.data());
    return v;
  }
};

template <std::size_t n>
double dot(const std::array<double, n>& row, const double* values, int count) {
  double sum = 0;
  for (int k = 0; k < count; ++k) sum += row[k] * values[k];
  return sum;
}
inline double dot(const Row& row, const Rates& rates) {
  return dot(row, rates.data(), int(rates.size()));
}

// Where a block gets in `seconds` by its own velocity: straight flight of the centroid, exact rotation. The last fills
// in a pose that is new, or was that block's before.
Pose flown(const BlockShape& shape, const BlockState& state, double seconds);
Pose flown(const Model& model, int block, double seconds);
void fly(const BlockShape& shape, const BlockState& state, double seconds, Pose& pose);

// 1, by which a force on a block, times its lever along it, lifts y in a step that turns the block by φ: the lever's
// end goes round the centroid, ahead φ²/Δt (step/turning.h).
inline double lift_of_lever(const Model& model, const Scheme& scheme, const std::vector<BlockState>& moved, int block) {
  const double turn = moved[size_t(block)].angle - model.blocks[size_t(block)].angle;
  return scheme.bond_ahead * turn * turn / scheme.dt;
}

// All that are awake at the configuration of linearisation.
struct Poses {
  std::vector<Pose> blocks;
  std::vector<Vec2> vertex;  // of blocks that have contacts, once these have been found

  void predict(const Model& model, const Scheme& scheme);
  void place_vertices(const Model& model);

 private:
  std::vector<char> placed_;  // per block
};

}  // namespace talus
