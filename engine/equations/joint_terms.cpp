#include "equations/joint_terms.h"

#include <algorithm>
#include <cmath>

#include "equations/bond_stiffness.h"
#include "equations/jump.h"
#include "equations/side.h"

namespace talus {

namespace {

// A fixity is held harder than the least that is stable: where one block alone stands on it, a soft hold would not pass
// its weight into its stress (1D: σ is off by κ/k).
constexpr double ground_penalty = 1000;

std::array<double, 2> spring_stiffness(const Model& model, const Joint& joint) {
  const JointProperty& property = model.scene.properties[joint.property];
  const double normal = property.stiffness_kind == StiffnessKind::per_contact
                            ? property.stiffness / (joint.length / 2)  // N/m of one end
                            : model.stiffness_per_area(property, joint.a, joint.b);
  return {normal, normal * property.shear_ratio};
}

// Joint axes for the springs: the mean of the two blocks' turned normals.
Mat2 stiffness_about(const Vec2& normal, const std::array<double, 2>& along) {
  return along[0] * normal * normal.transpose() + along[1] * perp(normal) * perp(normal).transpose();
}

bool is_intact(const Model& model, const Joint& joint) {
  return joint.state == JointState::intact && !model.sleeps(joint.a) && !model.sleeps(joint.b);
}

// Of the kinetic energy that a step begins and ends with, what may stay wrong in bonds: a tenth of what a step may add.
constexpr double allowed_energy = 1e-7;

// J/m, at both ends of the step, but for strains
double kinetic(const Model& model, int block, const Scheme& scheme, const Vector& d) {
  const BlockShape& shape = model.shapes[block];
  const std::array about{1.0, 1.0, (shape.xx + shape.yy) / (shape.area * shape.area)};
  double sum = 0;
  for (int k = 0; k < rigid_dofs; ++k) {
    const double before = model.blocks[block].velocity[size_t(k)],
                 after = before + (shape.dofs > 0 ? scheme.velocity_d * d[shape.dof_begin + k] : 0);
    sum += about[size_t(k)] * (before * before + after * after);
  }
  return model.mass(block) / 2 * sum;
}

double kinetic_of_joints(const Model& model, const Scheme& scheme, const Vector& d) {
  double sum = 0;  // a block counts with each of its bonds: an order of magnitude is enough
  for (const Joint& joint : model.joints)
    if (is_intact(model, joint)) sum += (kinetic(model, joint.a, scheme, d) + kinetic(model, joint.b, scheme, d)) / 4;
  return sum;
}

}  // namespace

void JointTerms::prepare(const Model& model) {
  const std::vector<double> least = least_stiffness(model);
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
    with_size(touches_second_order(joint), [&](auto n) { add_bond<n>(model, poses, ends, scheme, int(j), system); });
  }
}

// Flattened: the products are small, and most of what a step of bonded blocks does beside its factor.
template <int size>
[[gnu::flatten]] void JointTerms::add_bond(const Model& model, const Poses& poses, const Ends& ends,
                                           const Scheme& scheme, int j, System& system) const {
  constexpr bool varies = size > first_order_dofs;  // the flux along the edge
  const Joint& joint = model.joints[j];
  const Side a = side_of<size>(model, poses.blocks[joint.a], joint.a, joint.normal, joint.weight_a);
  const Side b = side_of<size>(model, poses.blocks[joint.b], joint.b, joint.normal, joint.weight_b);
  const bool exact = joint.kind == BondKind::exact;
  const RowsOf<size> zero = RowsOf<size>::Zero();
  RowsOf<size> sa = exact && !varies ? a.flux<size>({}) : zero, sb = exact && !varies ? b.flux<size>({}) : zero;
  Vec2 flux = exact && !varies ? mean_flux(a, b, scheme.bond_v) : Vec2(0, 0);
  const Mat2 stiffness = stiffness_about(turned_normal(joint, a.pose, b.pose), stiffness_[j]);

  const Jump<size> jump(model, ends, joint, scheme);
  MatrixOf<size> kaa = MatrixOf<size>::Zero(), kbb = kaa, kab = kaa;
  ColumnOf<size> fa = ColumnOf<size>::Zero(), fb = fa;
  for (int k = 0; k < int(joint.points.size()); ++k) {
    const JointPoint& point = joint.points[size_t(k)];
    const Vec2 in_a = between(joint.in_a, point.at), in_b = between(joint.in_b, point.at);
    if (varies && exact) {
      sa = a.flux<size>(in_a);
      sb = b.flux<size>(in_b);
      flux = mean_flux(a, in_a, b, in_b, scheme.bond_v);
    }
    // One point for both: action and reaction on one line keep angular momentum.
    const Vec2 at = (a.pose.place<size>(in_a) + b.pose.place<size>(in_b)) / 2;
    const RowsOf<size> ta = a.pose.rows<size>(in_a, at), tb = b.pose.rows<size>(in_b, at);
    const Vec2 gap = jump.at(in_a, in_b) + missing(j, k);
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
  const double scale = std::max(a.pose.shift.norm(), b.pose.shift.norm()),
               stiff = std::ranges::max(stiffness_[j]) * joint.length;
  system.add_rounding(joint.a, stiff, scale);
  system.add_rounding(joint.b, stiff, scale);
  if (shape_a.dofs) system.matrix.add(slots_[j].aa, false, kaa);
  if (shape_b.dofs) system.matrix.add(slots_[j].bb, false, kbb);
  if (shape_a.dofs && shape_b.dofs) system.matrix.add(slots_[j].ab, slots_[j].ab.row != joint.a, kab);
}

// A centroid `apart` from the other that turns by φ instead of φ₀ in the step is off by (φ² - φ₀²)/2 of it.
bool JointTerms::may_disagree(const Model& model, const Scheme& scheme, const Vector& d) const {
  double energy = 0;
  for (size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (!is_intact(model, joint)) continue;
    const auto change = [&](int block) {
      const BlockShape& shape = model.shapes[block];
      return shape.dofs > 0 ? scheme.move_d * d[shape.dof_begin + 2] / shape.length : 0;
    };
    const double before = spin_of(model, joint) * scheme.dt, faster = (change(joint.a) + change(joint.b)) / 2;
    const double apart = (model.blocks[joint.b].centroid - model.blocks[joint.a].centroid).norm();
    const double off = (std::abs(before) + std::abs(faster) / 2) * std::abs(faster) * apart;
    energy += std::ranges::max(stiffness_[j]) * joint.length * off * off / 2;
  }
  return energy > 0 && energy > allowed_energy * kinetic_of_joints(model, scheme, d);
}

bool JointTerms::agrees(const Model& model, const Poses& poses, const Scheme& scheme, const Vector& d,
                        const std::vector<BlockState>& moved) {
  missing_.resize(model.joints.size(), {Vec2(0, 0), Vec2(0, 0), Vec2(0, 0)});
  const Ends ends(model, scheme.dt);
  double energy = 0;
  for (size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (!is_intact(model, joint)) continue;
    const std::array after = {flown(model.shapes[joint.a], moved[joint.a], 0),
                              flown(model.shapes[joint.b], moved[joint.b], 0)};
    energy += with_size(touches_second_order(joint),
                        [&](auto n) { return find_missing<n>(model, poses, ends, scheme, int(j), d, after); });
  }
  return energy <= allowed_energy * kinetic_of_joints(model, scheme, d);
}

// J/m, of the difference from what it was.
template <int size>
double JointTerms::find_missing(const Model& model, const Poses& poses, const Ends& ends, const Scheme& scheme, int j,
                                const Vector& d, const std::array<Pose, 2>& after) {
  const Joint& joint = model.joints[j];
  const Pose &a = poses.blocks[joint.a], &b = poses.blocks[joint.b];
  const ColumnOf<size> d_a = of_block<size>(model.shapes[joint.a], d), d_b = of_block<size>(model.shapes[joint.b], d);
  const Jump<size> jump(model, ends, joint, scheme);
  double energy = 0;
  for (int k = 0; k < int(joint.points.size()); ++k) {
    const JointPoint& point = joint.points[size_t(k)];
    const Vec2 in_a = between(joint.in_a, point.at), in_b = between(joint.in_b, point.at),
               at = (a.place<size>(in_a) + b.place<size>(in_b)) / 2;
    const Vec2 linear =
        jump.at(in_a, in_b) + scheme.bond_d * (b.rows<size>(in_b, at) * d_b - a.rows<size>(in_a, at) * d_a);
    const Vec2 missing = jump.led_to(after[0], in_a, after[1], in_b) - linear;
    energy +=
        point.weight * std::ranges::max(stiffness_[size_t(j)]) * (missing - this->missing(j, k)).squaredNorm() / 2;
    missing_[size_t(j)][size_t(k)] = missing;
  }
  return energy;
}

JointTerms::Turning JointTerms::turning(const Model& model, const Poses& poses, const Scheme& scheme, const Vector& d,
                                        const std::vector<BlockState>& moved) const {
  constexpr double least = 1e-3;  // rad in the step: goes with its sixth power, 1e-18 E for what turns by less
  const auto turns = [&](const Joint& joint) {
    return is_intact(model, joint) && (!missing_.empty() || std::abs(spin_of(model, joint)) * scheme.dt > least);
  };
  if (std::ranges::none_of(model.joints, turns)) return {};
  const Ends ends(model, scheme.dt);
  const auto bend = [&](int block) { return lift_of_lever(model, scheme, moved, block); };
  Turning sum;
  for (size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (!turns(joint)) continue;
    const std::array after = {flown(model.shapes[joint.a], moved[joint.a], 0),
                              flown(model.shapes[joint.b], moved[joint.b], 0)};
    const Turning own = with_size(touches_second_order(joint), [&](auto n) {
      return turning_of_bond<n>(model, poses, ends, scheme, int(j), d, after, {bend(joint.a), bend(joint.b)});
    });
    sum.loss += own.loss;
    sum.lift += own.lift;
  }
  return sum;
}

// With the bond's energy U(S, g) = S·g + g·kg/2 of flux and jump, the bar for the middle of X, and m for what the step
// was solved with, its work on the rows' step less what it stores is B(m, (ΔS, T ΔX)) - B(X̄, (ΔS, Δg)), B the form of
// U. The matrix has B(T w, (ΔS, T ΔX)) of it, as if jumps changed by the rows.
template <int size>
JointTerms::Turning JointTerms::turning_of_bond(const Model& model, const Poses& poses, const Ends& ends,
                                                const Scheme& scheme, int j, const Vector& d,
                                                const std::array<Pose, 2>& after,
                                                const std::array<double, 2>& bends) const {
  const Joint& joint = model.joints[j];
  const Side a = side_of<size>(model, poses.blocks[joint.a], joint.a, joint.normal, joint.weight_a);
  const Side b = side_of<size>(model, poses.blocks[joint.b], joint.b, joint.normal, joint.weight_b);
  const bool exact = joint.kind == BondKind::exact;
  const Mat2 stiffness = stiffness_about(turned_normal(joint, a.pose, b.pose), stiffness_[j]);
  const ColumnOf<size> d_a = of_block<size>(model.shapes[joint.a], d), d_b = of_block<size>(model.shapes[joint.b], d),
                       v_a = a.pose.rates<size>(), v_b = b.pose.rates<size>();
  const ColumnOf<size> step_a = scheme.step_v * v_a + scheme.move_d * d_a,
                       step_b = scheme.step_v * v_b + scheme.move_d * d_b;
  const double w_d = scheme.bond_d - scheme.move_d / 2;
  const Jump<size> jump(model, ends, joint, scheme);
  Turning sum;
  for (int k = 0; k < int(joint.points.size()); ++k) {
    const JointPoint& point = joint.points[size_t(k)];
    const Vec2 in_a = between(joint.in_a, point.at), in_b = between(joint.in_b, point.at);
    const Vec2 at = (a.pose.place<size>(in_a) + b.pose.place<size>(in_b)) / 2;
    const RowsOf<size> ta = a.pose.rows<size>(in_a, at), tb = b.pose.rows<size>(in_b, at);
    const Vec2 rows_step = tb * step_b - ta * step_a,
               rows_w = scheme.bond_v * (tb * v_b - ta * v_a) + w_d * (tb * d_b - ta * d_a);
    const Vec2 solved = jump.at(in_a, in_b) + missing(j, k) + scheme.bond_d * (tb * d_b - ta * d_a);
    const Vec2 before = jump.before(in_a, in_b), now = jump.after(after[0], in_a, after[1], in_b),
               mean = (before + now) / 2;
    Vec2 flux_step = Vec2::Zero(), flux = flux_step;
    if (exact) {
      flux_step = a.flux<size>(in_a) * step_a + b.flux<size>(in_b) * step_b;
      flux = mean_flux(a, in_a, b, in_b, -scheme.mid) + flux_step / 2;
    }
    const Vec2 traction = flux + stiffness * mean;
    sum.loss += point.weight * ((solved - mean - rows_w).dot(flux_step + stiffness * rows_step) -
                                (now - before - rows_step).dot(traction));
    sum.lift += point.weight * traction.dot(bends[0] * (at - a.pose.centroid) - bends[1] * (at - b.pose.centroid));
  }
  return sum;
}

double JointTerms::energy(const Model& model, double ahead) const {
  std::vector<Pose> now;
  now.reserve(model.blocks.size());
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
  return with_size(touches_second_order(joint), [&](auto size) {
    const bool exact = joint.kind == BondKind::exact;
    const Side a = side_of<size>(model, pose_a, joint.a, joint.normal, joint.weight_a);
    const Side b = side_of<size>(model, pose_b, joint.b, joint.normal, joint.weight_b);
    Vec2 flux = exact ? mean_flux(a, b, ahead) : Vec2(0, 0);
    const Vec2 n = turned_normal(joint, pose_a, pose_b);
    const auto [kn, ks] = stiffness_[j];
    const double spin = spin_of(model, joint);
    double sum = 0;
    for (const JointPoint& point : joint.points) {
      const Vec2 in_a = between(joint.in_a, point.at), in_b = between(joint.in_b, point.at);
      if (size > first_order_dofs && exact) flux = mean_flux(a, in_a, b, in_b, ahead);
      const Vec2 gap = jump_ahead<size>(pose_a, in_a, pose_b, in_b, spin, ahead);
      const double normal = gap.dot(n), shear = gap.dot(perp(n));
      sum += point.weight * (flux.dot(gap) + (kn * normal * normal + ks * shear * shear) / 2);
    }
    return sum;
  });
}

std::array<BlockStrain, 2> JointTerms::strain_of_jump(const Model& model, int j, double ahead) const {
  const Joint& joint = model.joints[j];
  const std::array blocks = {joint.a, joint.b};
  const std::array weights = {joint.weight_a, joint.weight_b};
  const std::array poses = {flown(model, joint.a, 0), flown(model, joint.b, 0)};
  std::array<BlockStrain, 2> strain;
  for (size_t k = 0; k < 2; ++k) strain[k].setZero(strain_size(model.shapes[blocks[k]]));
  if (joint.kind != BondKind::exact) return strain;
  const auto strains = [&](size_t k) { return model.shapes[blocks[k]].dofs > rigid_dofs; };
  for (const JointPoint& point : joint.points) {
    const std::array in = {between(joint.in_a, point.at), between(joint.in_b, point.at)};
    const Vec2 jump = jump_ahead<max_dofs>(poses[0], in[0], poses[1], in[1], spin_of(model, joint), ahead);
    for (size_t k = 0; k < 2; ++k)
      if (strains(k))
        strain[k] += face_rows(model, blocks[k], joint.normal, in[k]).transpose() *
                     (weights[k] * point.weight * poses[k].rotation.back(jump));
  }
  for (size_t k = 0; k < 2; ++k)
    if (strains(k)) strain[k] = strain_stiffness(model, blocks[k]).ldlt().solve(strain[k]);
  return strain;
}

BondTraction JointTerms::flux(const Model& model, int j, double at) const {
  const Joint& joint = model.joints[j];
  if (joint.kind != BondKind::exact) return {};
  const Pose pose_a = flown(model, joint.a, 0), pose_b = flown(model, joint.b, 0);
  const Side a = side_of(model, pose_a, joint.a, joint.normal, joint.weight_a);
  const Side b = side_of(model, pose_b, joint.b, joint.normal, joint.weight_b);
  const Vec2 n = turned_normal(joint, pose_a, pose_b);
  const Vec2 mean = mean_flux(a, between(joint.in_a, at), b, between(joint.in_b, at), 0);
  return {mean.dot(n), mean.dot(perp(n))};
}

void JointTerms::store_tractions(Model& model) const {
  Poses now;
  now.predict(model, Scheme::equilibrium());
  for (size_t j = 0; j < model.joints.size(); ++j) {
    Joint& joint = model.joints[j];
    if (model.sleeps(joint.a) || model.sleeps(joint.b)) continue;
    with_size(touches_second_order(joint), [&](auto size) {
      const Side a = side_of<size>(model, now.blocks[joint.a], joint.a, joint.normal, joint.weight_a);
      const Side b = side_of<size>(model, now.blocks[joint.b], joint.b, joint.normal, joint.weight_b);
      const Vec2 n = turned_normal(joint, a.pose, b.pose);
      const bool intact = joint.state == JointState::intact, exact = intact && joint.kind == BondKind::exact;
      Vec2 flux = exact ? mean_flux(a, b, 0) : Vec2(0, 0);
      for (JointPoint& point : joint.points) {
        const Vec2 in_a = between(joint.in_a, point.at), in_b = between(joint.in_b, point.at);
        if (size > first_order_dofs && exact) flux = mean_flux(a, in_a, b, in_b, 0);
        const Vec2 gap = b.pose.displacement<size>(in_b) - a.pose.displacement<size>(in_a);
        point.opening = gap.dot(n);
        point.slip = gap.dot(perp(n));
        if (joint.bridged) continue;  // its traction is that of BridgeTerms
        point.normal = intact ? flux.dot(n) + stiffness_[j][0] * point.opening : 0;
        point.shear = intact ? flux.dot(perp(n)) + stiffness_[j][1] * point.slip : 0;
      }
    });
  }
}

}  // namespace talus
