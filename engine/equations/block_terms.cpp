#include "equations/block_terms.h"

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

double moment_of_inertia(const Model& model, int block, const Vec3& e) {
  const BlockShape& shape = model.shapes[block];
  Mat2 stretch, moments;
  stretch << 1 + e[0], e[2] / 2, e[2] / 2, 1 + e[1];
  moments << shape.xx, shape.xy, shape.xy, shape.yy;
  return model.material(block).density / (shape.length * shape.length) *
         (stretch * moments * stretch.transpose()).trace();
}

Vec2 body_force(const Model& model, int region, double density, double t) {
  const auto& own = model.scene.regions[region].body_force;
  return density * model.scene.gravity + Vec2(own[0].at(t), own[1].at(t));
}

void add_hold(const Model& model, const std::vector<double>& hold, System& system) {
  for (size_t b = 0; b < hold.size(); ++b) {
    if (model.shapes[b].dofs == 0) continue;
    const Material& material = model.material(int(b));
    const double own_rate2 = material.young / (material.density * model.extent * model.extent);
    system.matrix.add(system.matrix.slot(int(b), int(b)), false, DofMatrix(hold[b] * own_rate2 * mass_matrix(model, int(b))));
  }
}

void add_block_terms(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  std::vector<Mat3> elasticity_of;
  for (const Material& material : model.scene.materials) elasticity_of.push_back(elasticity(material));
  std::vector<Vec2> own_force;  // per region, without gravity
  for (size_t r = 0; r < model.scene.regions.size(); ++r)
    own_force.push_back(body_force(model, int(r), 0, model.time + scheme.load_time));

  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const BlockShape& shape = model.shapes[b];
    if (shape.dofs == 0 || model.sleeps(int(b))) continue;
    const Pose& pose = poses.blocks[b];
    const DofMatrix mass = mass_matrix(model, int(b));
    DofMatrix k = scheme.inertia * mass;
    DofColumn f = DofColumn::Zero();
    f.head<2>() = model.mass(int(b)) * model.scene.gravity + shape.area * own_force[shape.region];
    if (shape.dofs > 3) {
      const Mat3& d = elasticity_of[shape.material];
      const double per_length = 1 / shape.length;
      const Vec3 rate(pose.velocity[3], pose.velocity[4], pose.velocity[5]);
      const Vec3 strain = pose.strain + per_length * scheme.bond_v * rate;
      k.bottomRightCorner<3, 3>() += (scheme.bond_d * shape.area * per_length * per_length) * d;
      const Vec3 stress_force = -shape.area * per_length * (shape.initial_stress + d * strain);
      // Centrifugal: in axes that turn with the block, ∫ρ ω² x·δx.
      const double spin = pose.velocity[2] * per_length;
      const Vec3 centrifugal = spin * spin * shape.length * Vec3(mass(3, 3), mass(4, 4), mass(3, 5) + mass(4, 5));
      f.tail<3>() = stress_force + centrifugal;
    }
    for (int i = 0; i < shape.dofs; ++i)  // mass couples all six; a rigid block keeps its first three
      system.force[shape.dof_begin + i] += f[i];
    system.force_scale[b] += f.norm();
    system.matrix.add(system.matrix.slot(int(b), int(b)), false, k);
  }
}

}  // namespace talus
