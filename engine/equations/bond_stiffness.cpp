#include "equations/bond_stiffness.h"

#include <Eigen/Eigenvalues>

#include "equations/block_terms.h"
#include "equations/side.h"
#include "model/gauss.h"

namespace talus {

namespace {

using Mat9 = Eigen::Matrix<double, 9, 9>;

class Faces {
 public:
  explicit Faces(const Model& model)
      : model_(model),
        constant_(model.shapes.size(), Mat3::Zero()),
        linear_(model.quadratic_shapes.size(), Mat9::Zero()) {}

  // `share`: w².
  void add(int block, const std::array<Vec2, 2>& ends, const Vec2& normal, double share, double length) {
    const BlockShape& shape = model_.shapes[block];
    const Matrix23 n = traction_of(normal);
    if (!shape.second_order()) {
      constant_[block] += share * length * n.transpose() * n;
      return;
    }
    const Matrix23 traction = n * elasticity(model_.material(block));
    for (const GaussPoint& point : gauss_points(3)) {
      Eigen::Matrix<double, 2, 9> t;
      t << traction / shape.length, traction * shape.bend().strain_rows(between(ends, point.at));
      linear_[shape.quadratic] += share * length * point.share * t.transpose() * t;
    }
  }

  double least(int block) const {
    const BlockShape& shape = model_.shapes[block];
    const Mat3 d = elasticity(model_.material(block));
    if (!shape.second_order()) return largest<3>(d * constant_[block] * d, shape.area * d);
    Mat9 energy = Mat9::Zero();
    energy.topLeftCorner<3, 3>() = shape.area / (shape.length * shape.length) * d;
    energy.bottomRightCorner<6, 6>() = bend_stiffness(shape, d);
    return largest<9>(linear_[shape.quadratic], energy);
  }

 private:
  template <int n>
  static double largest(const MatrixOf<n>& flux, const MatrixOf<n>& energy) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixOf<n>> pencil(flux, energy, Eigen::EigenvaluesOnly);
    return pencil.eigenvalues()[n - 1];
  }

  const Model& model_;
  std::vector<Mat3> constant_;  // Σ w² L NᵀN
  std::vector<Mat9> linear_;  // of second-order blocks: Σ w² ∫ (N D S)ᵀ(N D S), S the strain under unit unknowns
};

}  // namespace

std::vector<double> least_stiffness(const Model& model) {
  Faces faces(model);
  for (const Joint& joint : model.joints) {
    if (!joint.bonded || joint.kind != BondKind::exact) continue;
    faces.add(joint.a, joint.in_a, joint.normal, joint.weight_a * joint.weight_a, joint.length);
    faces.add(joint.b, joint.in_b, joint.normal, joint.weight_b * joint.weight_b, joint.length);
  }
  for (const EdgeFixity& edge : model.edge_fixities) faces.add(edge.block, edge.in_block, edge.normal, 1, edge.length);
  std::vector<double> least(model.shapes.size(), 0.0);
  for (size_t b = 0; b < least.size(); ++b)
    if (model.shapes[b].dofs > rigid_dofs) least[b] = faces.least(int(b));
  return least;
}

}  // namespace talus
