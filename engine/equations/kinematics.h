#pragma once
// Blocks at the configuration a step is linearised about, and the rows that take unknowns to displacements.
#include <array>
#include <vector>

#include "equations/scheme.h"
#include "model/model.h"

namespace talus {

using Row = std::array<double, max_dofs>;

struct Pose {
  Vec2 shift, centroid;
  Rotation rotation;
  Vec3 strain;     // block axes
  double length;   // m, the block's scale
  std::array<double, max_dofs> velocity;

  Vec2 place(const Vec2& in_block) const {
    return centroid + rotation.turn({(1 + strain[0]) * in_block.x() + strain[2] / 2 * in_block.y(),
                                     strain[2] / 2 * in_block.x() + (1 + strain[1]) * in_block.y()});
  }
  // place - reference place, from displacements alone: (R - I) X + R e X + shift.
  Vec2 displacement(const Vec2& in_block) const {
    const double x = in_block.x(), y = in_block.y();
    const Vec2 turned(rotation.c1 * x - rotation.s * y, rotation.s * x + rotation.c1 * y);
    return shift + turned +
           rotation.turn({strain[0] * x + strain[2] / 2 * y, strain[2] / 2 * x + strain[1] * y});
  }
  // Derivative of the place of the material point now at `at`, along `direction`, by the unknowns: of place() above, so
  // that strain works on the undeformed arm (Shi 1988 takes the deformed one, which makes every stress wrong by its
  // strain). In the block's own axes, divided by its length. A rigid block uses the first three.
  Row row(const Vec2& at, const Vec2& direction) const {
    const Vec2 x = rotation.back(at - centroid) / length, n = rotation.back(direction);
    const double a = 1 + strain[0], b = strain[2] / 2, c = 1 + strain[1], det = a * c - b * b;
    const Vec2 arm((c * x.x() - b * x.y()) / det, (a * x.y() - b * x.x()) / det);
    return {direction.x(), direction.y(), cross(x, n), arm.x() * n.x(), arm.y() * n.y(),
            (arm.y() * n.x() + arm.x() * n.y()) / 2};
  }
  Vec2 velocity_at(const Vec2& in_block) const {
    const Vec2 arm = place(in_block) - centroid;
    const double x = in_block.x(), y = in_block.y();
    const auto& v = velocity;
    return Vec2(v[0], v[1]) + v[2] / length * perp(arm) +
           rotation.turn(Vec2(v[3] * x + v[5] / 2 * y, v[5] / 2 * x + v[4] * y)) / length;
  }
  DofRows rows(const Vec2& at) const {
    const Row x = row(at, Vec2::UnitX()), y = row(at, Vec2::UnitY());
    DofRows t;
    for (int k = 0; k < max_dofs; ++k) {
      t(0, k) = x[k];
      t(1, k) = y[k];
    }
    return t;
  }
};

inline double dot(const Row& row, const double* values, int count) {
  double sum = 0;
  for (int k = 0; k < count; ++k) sum += row[k] * values[k];
  return sum;
}

// Where a block gets in `seconds` by its own velocity: straight flight of the centroid, exact rotation.
Pose flown(const BlockShape& shape, const BlockState& state, double seconds);
Pose flown(const Model& model, int block, double seconds);

// All that are awake at the configuration of linearisation.
struct Poses {
  std::vector<Pose> blocks;
  std::vector<Vec2> vertex;

  void predict(const Model& model, const Scheme& scheme);
};

}  // namespace talus
