#include "equations/block_terms.h"

#include "model/rates.h"

namespace talus {

DofMatrix mass_matrix(const Model& model, int block) {
  const BlockShape& shape = model.shapes[block];
  const double density = model.material(block).density, scale = density / (shape.length * shape.length);
  const double xx = scale * shape.xx, yy = scale * shape.yy, xy = scale * shape.xy;
  DofMatrix m = DofMatrix::Zero();
  m(0, 0) = m(1, 1) = density * shape.area;
  m(2, 2) = xx + yy;
  m(3, 3) = xx;
  m(4, 4) = yy;
  m(5, 5) = (xx + yy) / 4;
  m(2, 3) = m(3, 2) = -xy;
  m(2, 4) = m(4, 2) = xy;
  m(2, 5) = m(5, 2) = (xx - yy) / 2;
  m(3, 5) = m(5, 3) = xy / 2;
  m(4, 5) = m(5, 4) = xy / 2;
  return m;
}

namespace {

// ∫ m_i X dA and ∫ m_i Y dA (m3), ∫ m_i m_j dA (m2) of the monomials of model/bend.h; the means of X and Y are nought.
struct BendMoments {
  Vec3 x, y;
  Mat3 square;
};

BendMoments bend_moments(const Model& model, const BlockShape& shape) {
  const HighMoments& m = model.quadratic_shapes[shape.quadratic].moments;
  const double scale = 1 / (shape.length * shape.length);
  const Vec3 mean = shape.bend().mean;
  Mat3 fourth;
  fourth << m.fourth[0], m.fourth[1], m.fourth[2], m.fourth[1], m.fourth[2], m.fourth[3], m.fourth[2], m.fourth[3],
      m.fourth[4];
  return {scale * Vec3(m.third[0], m.third[1], m.third[2]), scale * Vec3(m.third[1], m.third[2], m.third[3]),
          scale * scale * fourth - shape.area * mean * mean.transpose()};
}

}  // namespace

MatrixOf<second_order_dofs> second_order_mass_matrix(const Model& model, int block) {
  const BlockShape& shape = model.shapes[block];
  const double density = model.material(block).density, per_length = density / shape.length;
  const BendMoments moments = bend_moments(model, shape);
  MatrixOf<second_order_dofs> m = MatrixOf<second_order_dofs>::Zero();
  m.topLeftCorner<first_order_dofs, first_order_dofs>() = mass_matrix(model, block);
  // Along x and y, under unit rotation, εx, εy and γ: (-Y, X), (X, 0), (0, Y), (Y, X)/2, over l.
  Eigen::Matrix<double, 4, 6> mixed;
  const Vec3 x = per_length * moments.x, y = per_length * moments.y;
  mixed << -y.transpose(), x.transpose(), x.transpose(), Vec3::Zero().transpose(), Vec3::Zero().transpose(),
      y.transpose(), y.transpose() / 2, x.transpose() / 2;
  m.block<4, 6>(2, first_order_dofs) = mixed;
  m.block<6, 4>(first_order_dofs, 2) = mixed.transpose();
  for (const int begin : {first_order_dofs, first_order_dofs + 3})
    m.block<3, 3>(begin, begin) = density * moments.square;
  return m;
}

MatrixOf<6> bend_stiffness(const BlockShape& shape, const Mat3& elasticity) {
  const Matrix36 x = shape.bend().strain_rows(Vec2::UnitX()), y = shape.bend().strain_rows(Vec2::UnitY());
  const MatrixOf<6> mixed = x.transpose() * elasticity * y;
  return shape.xx * x.transpose() * elasticity * x + shape.xy * (mixed + mixed.transpose()) +
         shape.yy * y.transpose() * elasticity * y;
}

Vec6 initial_bend_force(const Model& model, int block) {
  const BlockShape& shape = model.shapes[block];
  const QuadraticShape& quadratic = model.quadratic_shapes[shape.quadratic];
  const Vec3 by_x = shape.xx * quadratic.stress_x + shape.xy * quadratic.stress_y,
             by_y = shape.xy * quadratic.stress_x + shape.yy * quadratic.stress_y;
  return shape.bend().strain_rows(Vec2::UnitX()).transpose() * by_x +
         shape.bend().strain_rows(Vec2::UnitY()).transpose() * by_y;
}

double bend_energy(const Model& model, int block, const Vec6& bend) {
  return bend.dot(initial_bend_force(model, block)) +
         bend.dot(bend_stiffness(model.shapes[block], elasticity(model.material(block))) * bend) / 2;
}

double moment_of_inertia(const Model& model, int block, const Vec3& e) {
  const BlockShape& shape = model.shapes[block];
  Mat2 stretch, moments;
  stretch << 1 + e[0], e[2] / 2, e[2] / 2, 1 + e[1];
  moments << shape.xx, shape.xy, shape.xy, shape.yy;
  return model.material(block).density / (shape.length * shape.length) *
         (stretch * moments * stretch.transpose()).trace();
}

double moment_of_inertia(const Model& model, int block, const Vec3& e, const Apart<BendArray>& bend) {
  const double unbent = moment_of_inertia(model, block, e);
  if (!bend) return unbent;
  const BlockShape& shape = model.shapes[block];
  const BendArray& b = *bend;
  const BendMoments m = bend_moments(model, shape);
  const Vec3 along_x(b[0], b[1], b[2]), along_y(b[3], b[4], b[5]);
  // 2 ∫ (I + e)X·q + ∫ q·q
  const Vec3 x = (1 + e[0]) * m.x + e[2] / 2 * m.y, y = e[2] / 2 * m.x + (1 + e[1]) * m.y;
  const double bent =
      2 * (x.dot(along_x) + y.dot(along_y)) + along_x.dot(m.square * along_x) + along_y.dot(m.square * along_y);
  return unbent + model.material(block).density / (shape.length * shape.length) * bent;
}

double mean_spin(const Model& model, int block, const BlockState& state) {
  const BlockShape& shape = model.shapes[block];
  const auto& v = state.velocity;
  if (stands_still(v)) return 0;
  if (shape.second_order()) {
    const ColumnOf<second_order_dofs> coupling = second_order_mass_matrix(model, block).row(2);
    return coupling.dot(v.column<second_order_dofs>()) / coupling[2];
  }
  // row 2 of mass_matrix()
  return v[2] + (shape.xy * (v[4] - v[3]) + (shape.xx - shape.yy) / 2 * v[5]) / (shape.xx + shape.yy);
}

namespace {

// m/s, the mean spin of the pose, to which the angular momentum stays.
double mean_spin(const Model& model, int block, const Pose& pose) {
  const BlockState& state = model.blocks[block];
  const double spin = mean_spin(model, block, state);
  if (spin == 0) return 0;
  Apart<BendArray> bend = state.bend;
  if (bend) *bend = pose.bend->now;
  return spin * moment_of_inertia(model, block, state.strain, state.bend) /
         moment_of_inertia(model, block, pose.strain, bend);
}

}  // namespace

Vec2 body_force(const Model& model, int region, double density, double t) {
  const auto& own = model.scene.regions[region].body_force;
  return density * model.gravity() + Vec2(model.load(own[0], t), model.load(own[1], t));
}

void add_hold(const Model& model, const std::vector<double>& hold, const Vector& lead, System& system) {
  for (const int b : model.awake_blocks()) {
    if (model.shapes[b].dofs == 0) continue;
    const Material& material = model.material(b);
    const double own_rate2 = material.young / (material.density * model.extent * model.extent);
    const BlockShape& shape = model.shapes[b];
    with_size(shape.second_order(), [&](auto n) {
      const MatrixOf<n> inertia = hold[b] * own_rate2 * mass_matrix_of<n>(model, b);
      system.matrix.add(system.matrix.slot(b, b), false, inertia);
      if (lead.size() == 0) return;
      ColumnOf<n> own = ColumnOf<n>::Zero();
      own.head(shape.dofs) = lead.segment(shape.dof_begin, shape.dofs);
      system.add_force<n>(shape, b, -(inertia * own));
    });
  }
}

void add_block_terms(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  std::vector<Mat3> elasticity_of;
  for (const Material& material : model.scene.materials) elasticity_of.push_back(elasticity(material));
  std::vector<Vec2> own_force;  // per region, without gravity
  for (size_t r = 0; r < model.scene.regions.size(); ++r)
    own_force.push_back(body_force(model, int(r), 0, model.time + scheme.load_time));

  for (const int b : model.awake_blocks()) {
    const BlockShape& shape = model.shapes[b];
    if (shape.dofs == 0) continue;
    const Pose& pose = poses.blocks[b];
    with_size(shape.second_order(), [&](auto n) {
      const MatrixOf<n> mass = mass_matrix_of<n>(model, b);
      MatrixOf<n> k = scheme.inertia * mass;
      ColumnOf<n> f = ColumnOf<n>::Zero();
      f.template head<2>() = model.mass(b) * model.gravity() + shape.area * own_force[shape.region];
      if (shape.dofs > rigid_dofs) {
        const Mat3& d = elasticity_of[shape.material];
        const double per_length = 1 / shape.length;
        const Vec3 rate(pose.velocity[3], pose.velocity[4], pose.velocity[5]);
        const Vec3 strain = pose.strain + per_length * scheme.bond_v * rate;
        k.template block<3, 3>(3, 3) += (scheme.bond_d * shape.area * per_length * per_length) * d;
        const Vec3 stress_force = -shape.area * per_length * (shape.initial_stress + d * strain);
        // Centrifugal: in axes that turn with the block, ∫ρ ω² x·δx, of the middle of the step.
        const double spin = mean_spin(model, b, pose) * per_length;
        const Vec3& e = pose.strain;
        const double xx = mass(3, 3), yy = mass(4, 4), xy = mass(3, 5) + mass(4, 5);
        const Vec3 centrifugal = spin * spin * shape.length *
                                 Vec3((1 + e[0]) * xx + e[2] / 2 * xy, (1 + e[1]) * yy + e[2] / 2 * xy,
                                      ((2 + e[0] + e[1]) * xy + e[2] / 2 * (xx + yy)) / 2);
        f.template segment<3>(3) = stress_force + centrifugal;
        if constexpr (n > first_order_dofs) {
          const MatrixOf<6> bending = bend_stiffness(shape, d);
          k.template bottomRightCorner<6, 6>() += scheme.bond_d * bending;
          const Vec6 bend = Eigen::Map<const Vec6>(pose.bend->now.data()) +
                            scheme.bond_v * Eigen::Map<const Vec6>(pose.bend->rate.data());
          f.template tail<6>() =
              spin * spin * shape.length * (mass.row(3) + mass.row(4)).template tail<6>().transpose() -
              initial_bend_force(model, b) - bending * bend;
        }
      }
      for (int i = 0; i < shape.dofs; ++i)  // mass couples all; a rigid block keeps its first three
        system.force[shape.dof_begin + i] += f[i];
      system.force_scale[b] += f.norm();
      system.matrix.begin(b, k);
    });
  }
}

}  // namespace talus
