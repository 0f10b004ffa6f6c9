#include "equations/block_strain.h"

#include "equations/block_terms.h"
#include "equations/side.h"

namespace talus {

BlockStrain strain_of(const Model& model, int block, double ahead) {
  const BlockShape& shape = model.shapes[block];
  const BlockState& state = model.blocks[block];
  const auto& v = state.velocity;
  BlockStrain e(strain_size(shape));
  e.head<3>() = state.strain + ahead / shape.length * Vec3(v[3], v[4], v[5]);
  for (int k = 3; k < e.size(); ++k) e[k] = (*state.bend)[k - 3] + ahead * v[k + 3];
  return e;
}

StrainMatrix strain_stiffness(const Model& model, int block) {
  const BlockShape& shape = model.shapes[block];
  const Mat3 d = elasticity(model.material(block));
  if (!shape.second_order()) return shape.area * d;
  StrainMatrix k = StrainMatrix::Zero(9, 9);
  k.topLeftCorner<3, 3>() = shape.area * d;
  k.bottomRightCorner<6, 6>() = bend_stiffness(shape, d);
  return k;
}

BlockStrain initial_strain_force(const Model& model, int block) {
  const BlockShape& shape = model.shapes[block];
  BlockStrain force(strain_size(shape));
  force.head<3>() = shape.area * shape.initial_stress;
  if (shape.second_order()) force.tail<6>() = initial_bend_force(model, block);
  return force;
}

Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 9> face_rows(const Model& model, int block, const Vec2& n,
                                                            const Vec2& in_block) {
  const BlockShape& shape = model.shapes[block];
  const Matrix23 mean = traction_of(n) * elasticity(model.material(block));
  if (!shape.second_order()) return mean;
  Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 9> rows(2, 9);
  rows << mean, mean * shape.bend().strain_rows(in_block);
  return rows;
}

}  // namespace talus
