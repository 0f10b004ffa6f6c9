#pragma once
// Smoothed stress: block displacements are averaged at the corners that bonded blocks share, of second-order blocks
// also in the middle of their edges, a cubic polynomial with constant div σ is fitted to those within 4 h of a
// point, 1.5 h in a second-order block and without that constraint (weighted least squares), and its gradient F = R U
// gives the stress through the strain U - I. One recovery serves output, probes and checks, and blocks of both orders.
// Only blocks that can be reached through intact joints take part: a crack separates its faces. Sources: patch recovery
// of Zienkiewicz & Zhu (1992), here of displacements; the equilibrium constraint is that of Wiberg & Abdulwahab (1993),
// with div σ left constant instead of given, so that it holds in motion too.
#include <array>
#include <vector>

#include "model/model.h"

namespace talus {

class Recovery {
 public:
  explicit Recovery(const Model& model);
  // Brings the corner averages up to date with the model.
  void update(const Model& model);
  // Stress (sxx, syy, sxy; global axes, Pa) at the material point `in_block` of `block`; the raw block stress
  // where too few corners are near (single blocks) or the block is rigid.
  Vec3 stress_at(const Model& model, int block, const Vec2& in_block) const;

  // The polynomial about one material point; one serves for all the places in a block where many are asked for.
  struct Fit {
    bool found = false;          // else the raw stress stands
    Vec2 centre = Vec2::Zero();  // in the block
    double radius = 1;           // m
    // displacement / radius in the block's turned axes, by 1, x, y, x², xy, …, y³ in radii
    std::array<double, 10> u{}, v{};
  };
  Fit fit(const Model& model, int block, const Vec2& centre) const;
  Vec3 stress_of(const Model& model, int block, const Fit& fit, const Vec2& in_block) const;

 private:
  struct Patch {
    std::vector<int> corners;  // indices into average_
    double radius;
  };
  Patch patch(const Model& model, int block, const Vec2& at) const;
  bool take_middles(const BlockShape& shape, const Vec2& at, Patch& patch) const;
  void connect(const Model& model);
  void connect_middles(const Model& model);

  int intact_joints_ = -1;
  std::vector<int> corner_of_vertex_;  // per block vertex: the shared corner it belongs to, or -1
  std::vector<int> middle_of_edge_;    // of second-order blocks, by the vertex where the edge begins: the same
  std::vector<Vec2> corner_position_;  // reference
  std::vector<Vec2> corner_displacement_;
  std::vector<int> neighbour_begin_, neighbours_;  // blocks across intact joints
};

}  // namespace talus
