#pragma once
// What a block is strained by, of either order alike.
#include <Eigen/Dense>

#include "model/model.h"

namespace talus {

// The strain of a block in its own axes: εx, εy, γxy, and the six unknowns of model/bend.h (m) of a second-order one.
// What it stores is ½ e·Ke + e·f of it, K in N/m and f of its initial stress.
using BlockStrain = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 9, 1>;
using StrainMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 9, 9>;
inline int strain_size(const BlockShape& shape) {
  return shape.second_order() ? 9 : 3;
}
BlockStrain strain_of(const Model& model, int block, double ahead);  // s along the present velocities
StrainMatrix strain_stiffness(const Model& model, int block);
BlockStrain initial_strain_force(const Model& model, int block);
// Traction (Pa) on a face of reference normal n at a material point, by unit strains.
Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 9> face_rows(const Model& model, int block, const Vec2& n,
                                                            const Vec2& in_block);

}  // namespace talus
