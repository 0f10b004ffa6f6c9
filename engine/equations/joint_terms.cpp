#include "equations/joint_terms.h"

#include <Eigen/Eigenvalues>

#include "equations/jump.h"
#include "equations/side.h"

namespace talus {

namespace {

// A fixity is held harder than the least that is stable: where one block alone stands on it, a soft hold would not pass
// its weight into its stress (1D: σ is off by κ/k).
constexpr double ground_penalty = 1000;

// Largest eigenvalue of Σ w² L (N D)ᵀ(N D) against A D: the least k that is provably enough for one block (Pa/m).
double least_stiffness(const Mat3& flux, const Mat3& elasticity, double area) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat3> pencil(elasticity * flux * elasticity, area * elasticity,
                                                              Eigen::EigenvaluesOnly);
  return pencil.eigenvalues()[2];
}

std::array<double, 2> spring_stiffness(const Model& model, const Joint& joint) {
  const JointProperty& property = model.scene.properties[joint.property];
  double normal = property.stiffness;
  if (property.stiffness_kind == StiffnessKind::per_length) {
    const double young = std::min(model.material(joint.a).young, model.material(joint.b).young);
    normal *= young / std::min(model.shapes[joint.a].length, model.shapes[joint.b].length);
  } else {
    normal /= joint.points[0].weight;  // N/m of one end -> per area
  }
  return {normal, normal * property.shear_ratio};
}

}  // namespace

void JointTerms::prepare(const Model& model) {
  std::vector<Mat3> flux(model.shapes.size(), Mat3::Zero());
  const auto add_face = [&](int block, const Vec2& normal, double weighted_length) {
    const Matrix23 n = traction_of(normal);
    flux[block] += weighted_length * n.transpose() * n;
  };
  for (const Joint& joint : model.joints) {  // also those that have failed: a crack does not change how others are held
    if (!joint.bonded || joint.kind != BondKind::exact) continue;
    add_face(joint.a, joint.normal, joint.weight_a * joint.weight_a * joint.length);
    add_face(joint.b, joint.normal, joint.weight_b * joint.weight_b * joint.length);
  }
  for (const EdgeFixity& edge : model.edge_fixities) add_face(edge.block, edge.normal, edge.length);

  std::vector<double> least(model.shapes.size(), 0.0);
  for (size_t b = 0; b < least.size(); ++b)
    if (model.shapes[b].dofs > 3)
      least[b] = least_stiffness(flux[b], elasticity(model.material(int(b))), model.shapes[b].area);

  stiffness_.resize(model.joints.size());
  for (size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.kind == BondKind::spring || joint.weight_a + joint.weight_b == 0) {
      stiffness_[j] = spring_stiffness(model, joint);
      continue;
    }
    const double k = model.scene.properties[joint.property].penalty *
                     ((joint.weight_a > 0 ? least[joint.a] : 0) + (joint.weight_b > 0 ? least[joint.b] : 0));
    stiffness_[j] = {k, k};
  }
  ground_stiffness_.resize(model.edge_fixities.size());
  for (size_t e = 0; e < ground_stiffness_.size(); ++e) {
    const EdgeFixity& edge = model.edge_fixities[e];
    const int property = model.scene.regions[model.shapes[edge.block].region].joint;
    const double penalty = property >= 0 ? model.scene.properties[property].penalty : JointProperty{}.penalty;
    ground_stiffness_[e] = std::max(ground_penalty, 2 * penalty) * least[edge.block];
  }
}

void JointTerms::find_slots(const Model& model, const BlockMatrix& matrix) {
  slots_.clear();
  for (const Joint& joint : model.joints)
    slots_.push_back({matrix.slot(joint.a, joint.a), matrix.slot(joint.b, joint.b), matrix.slot(joint.a, joint.b)});
}

void JointTerms::add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) const {
  const Ends ends(model, scheme.dt);
  for (size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.state != JointState::intact || model.sleeps(joint.a) || model.sleeps(joint.b)) continue;
    const Side a = side_of(model, poses.blocks[joint.a], joint.a, joint.normal, joint.weight_a);
    const Side b = side_of(model, poses.blocks[joint.b], joint.b, joint.normal, joint.weight_b);
    const bool exact = joint.kind == BondKind::exact;
    const DofRows zero = DofRows::Zero();
    const DofRows sa = exact ? a.flux() : zero, sb = exact ? b.flux() : zero;
    const Vec2 flux = exact ? mean_flux(a, b, scheme.bond_v) : Vec2(0, 0);
    // Joint axes for the springs: the mean of the two blocks' turned normals.
    const Vec2 n = turned_normal(joint, a.pose, b.pose);
    const auto [kn, ks] = stiffness_[j];
    const Mat2 stiffness = kn * n * n.transpose() + ks * perp(n) * perp(n).transpose();

    const Jump jump(model, ends, joint, scheme);
    DofMatrix kaa = DofMatrix::Zero(), kbb = kaa, kab = kaa;
    DofColumn fa = DofColumn::Zero(), fb = fa;
    for (const JointPoint& point : joint.points) {
      // One point for both: action and reaction on one line keep angular momentum.
      const Vec2 at =
          (a.pose.place(between(joint.in_a, point.at)) + b.pose.place(between(joint.in_b, point.at))) / 2;
      const DofRows ta = a.pose.rows(at), tb = b.pose.rows(at);
      const Vec2 gap = jump.at(point.at);
      const Vec2 traction = flux + stiffness * gap;
      const double w = point.weight;
      fa += w * (ta.transpose() * traction - sa.transpose() * gap);
      fb -= w * (tb.transpose() * traction + sb.transpose() * gap);
      const double wk = w * scheme.bond_d;
      kaa += wk * (ta.transpose() * (stiffness * ta - sa) - sa.transpose() * ta);
      kbb += wk * (tb.transpose() * (stiffness * tb + sb) + sb.transpose() * tb);
      kab += wk * (-ta.transpose() * (stiffness * tb + sb) + sa.transpose() * tb);
    }
    const BlockShape &shape_a = model.shapes[joint.a], &shape_b = model.shapes[joint.b];
    system.add_force(shape_a, joint.a, fa);
    system.add_force(shape_b, joint.b, fb);
    const double size = std::max(a.pose.shift.norm(), b.pose.shift.norm()), stiff = std::max(kn, ks) * joint.length;
    system.add_rounding(joint.a, stiff, size);
    system.add_rounding(joint.b, stiff, size);
    if (shape_a.dofs) system.matrix.add(slots_[j].aa, false, kaa);
    if (shape_b.dofs) system.matrix.add(slots_[j].bb, false, kbb);
    if (shape_a.dofs && shape_b.dofs) system.matrix.add(slots_[j].ab, slots_[j].ab.row != joint.a, kab);
  }
}

double JointTerms::energy(const Model& model, double ahead) const {
  std::vector<Pose> now;
  for (int b = 0; b < int(model.blocks.size()); ++b) now.push_back(flown(model, b, 0));
  double sum = 0;
  for (int j = 0; j < int(model.joints.size()); ++j)
    if (model.joints[j].state == JointState::intact)
      sum += energy_of(model, j, now[model.joints[j].a], now[model.joints[j].b], ahead);
  return sum;
}

double JointTerms::energy_of(const Model& model, int j, double ahead) const {
  return energy_of(model, j, flown(model, model.joints[j].a, 0), flown(model, model.joints[j].b, 0), ahead);
}

double JointTerms::energy_of(const Model& model, int j, const Pose& pose_a, const Pose& pose_b, double ahead) const {
  const Joint& joint = model.joints[j];
  const Side a = side_of(model, pose_a, joint.a, joint.normal, joint.weight_a);
  const Side b = side_of(model, pose_b, joint.b, joint.normal, joint.weight_b);
  const Vec2 flux = joint.kind == BondKind::exact ? mean_flux(a, b, ahead) : Vec2(0, 0);
  const Vec2 n = turned_normal(joint, pose_a, pose_b);
  const auto [kn, ks] = stiffness_[j];
  const double spin = spin_of(model, joint);
  double sum = 0;
  for (const JointPoint& point : joint.points) {
    const Vec2 gap = jump_ahead(joint, pose_a, pose_b, spin, ahead, point.at);
    const double normal = gap.dot(n), shear = gap.dot(perp(n));
    sum += point.weight * (flux.dot(gap) + (kn * normal * normal + ks * shear * shear) / 2);
  }
  return sum;
}

BondTraction JointTerms::flux(const Model& model, int j) const {
  const Joint& joint = model.joints[j];
  if (joint.kind != BondKind::exact) return {};
  const Pose pose_a = flown(model, joint.a, 0), pose_b = flown(model, joint.b, 0);
  const Side a = side_of(model, pose_a, joint.a, joint.normal, joint.weight_a);
  const Side b = side_of(model, pose_b, joint.b, joint.normal, joint.weight_b);
  const Vec2 n = turned_normal(joint, pose_a, pose_b);
  const Vec2 mean = mean_flux(a, b, 0);
  return {mean.dot(n), mean.dot(perp(n))};
}

void JointTerms::store_tractions(Model& model) const {
  Poses now;
  now.predict(model, Scheme::equilibrium());
  for (size_t j = 0; j < model.joints.size(); ++j) {
    Joint& joint = model.joints[j];
    if (model.sleeps(joint.a) || model.sleeps(joint.b)) continue;
    const Side a = side_of(model, now.blocks[joint.a], joint.a, joint.normal, joint.weight_a);
    const Side b = side_of(model, now.blocks[joint.b], joint.b, joint.normal, joint.weight_b);
    const Vec2 n = turned_normal(joint, a.pose, b.pose);
    const bool intact = joint.state == JointState::intact;
    const Vec2 flux = intact && joint.kind == BondKind::exact ? mean_flux(a, b, 0) : Vec2(0, 0);
    for (JointPoint& point : joint.points) {
      const Vec2 gap =
          b.pose.displacement(between(joint.in_b, point.at)) - a.pose.displacement(between(joint.in_a, point.at));
      point.opening = gap.dot(n);
      point.slip = gap.dot(perp(n));
      if (joint.bridged) continue;  // its traction is that of BridgeTerms
      point.normal = intact ? flux.dot(n) + stiffness_[j][0] * point.opening : 0;
      point.shear = intact ? flux.dot(perp(n)) + stiffness_[j][1] * point.slip : 0;
    }
  }
}

}  // namespace talus
