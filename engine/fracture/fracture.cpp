#include "fracture/fracture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "equations/bridge_terms.h"
#include "fracture/cracks.h"
#include "fracture/criterion.h"
#include "model/crack_path.h"

namespace talus {

namespace {

// Tractions are found to the solver's tolerance: a bond that lacks no more than this part of its strength has reached
// it.
constexpr double at_strength = 1 - 1e-7;
// Utilisations that differ by less are the same: of bonds that a symmetric scene makes alike none fails before another.
constexpr double alike = 1e-6;

bool is_due(const Joint& joint) {
  return joint.state == JointState::intact && joint.utilisation >= at_strength;
}

double joint_jump(const Joint& joint, double JointPoint::*value) {
  double mean = 0;
  for (const JointPoint& point : joint.points) mean += point.weight / joint.length * (point.*value);
  return mean;
}

}  // namespace

Fracture::Fracture(Model& model) : model_(model), at_node_(model.nodes.position.size()) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (!joint.bonded || !model.scene.properties[joint.property].breaks) continue;
    breakable_.push_back(int(j));
    for (const int node : joint.node) at_node_[node].push_back(int(j));
  }
  if (std::any_of(breakable_.begin(), breakable_.end(), [&](int j) { return is_tracked(model, model.joints[j]); }))
    tracking_.emplace(model, at_node_);
}

double Fracture::least_transit() const {
  double least = std::numeric_limits<double>::infinity();
  for (const int j : breakable_)
    for (const int block : {model_.joints[j].a, model_.joints[j].b}) {
      const Material& rock = model_.material(block);
      least = std::min(least, model_.shapes[block].length * std::sqrt(rock.density / elasticity(rock)(0, 0)));
    }
  return least;
}

double Fracture::judge() {
  talus::judge(model_, breakable_);
  if (tracking_) tracking_->judge();
  double most = 0;
  for (const int j : breakable_)
    if (model_.joints[j].state == JointState::intact) most = std::max(most, model_.joints[j].utilisation);
  return most;
}

bool Fracture::any_due() const {
  return std::any_of(breakable_.begin(), breakable_.end(), [&](int j) { return is_due(model_.joints[j]); });
}

std::vector<int> Fracture::choose(bool motion) {
  const std::vector<int> first = first_of_those_due(motion);
  return tracking_ && !first.empty() ? tracking_->lead(first) : first;
}

std::vector<int> Fracture::first_of_those_due(bool motion) const {
  const auto& joints = model_.joints;
  std::vector<int> due;
  for (const int j : breakable_)
    if (is_due(joints[j]) && !waits(j)) due.push_back(j);
  const FractureControl& control = model_.scene.fracture;
  if (due.empty() || control.order == FailureOrder::all) return due;
  const double least = control.order == FailureOrder::one ? 1 : 1 - control.band;
  if (motion && control.order == FailureOrder::critical) {
    std::vector<int> chosen;
    for (const int j : due) {
      double most = 0;
      for (const int node : joints[j].node)
        for (const int other : at_node_[node])
          if (joints[other].state == JointState::intact && !waits(other))
            most = std::max(most, joints[other].utilisation);
      if (joints[j].utilisation >= (1 - alike) * least * most) chosen.push_back(j);
    }
    return chosen;
  }
  std::sort(due.begin(), due.end(), [&](int j, int k) { return joints[j].utilisation > joints[k].utilisation; });
  std::size_t count = 1;
  const double limit = least * joints[due[0]].utilisation;
  while (count < due.size() && (joints[due[count]].utilisation >= limit ||
                                joints[due[count]].utilisation >= (1 - alike) * joints[due[count - 1]].utilisation))
    ++count;
  due.resize(count);
  std::sort(due.begin(), due.end());
  return due;
}

void Fracture::fail(const std::vector<int>& joints, double time, const std::vector<BondTraction>& judged) {
  if (joints.empty()) return;
  const std::vector<int> crack_at_node = cracks_at_nodes(model_);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const int j = joints[k];
    Joint& joint = model_.joints[j];
    joint.left_with = mean_traction(joint);
    joint.failed_with = judged.empty() ? joint.left_with : judged[k];
    joint.mode = joint.path_turn != 0 ? FailureMode::tension : failure_mode(model_, joint, joint.failed_with);
    joint.crack = crack_kind(crack_at_node, joint);
    joint.failed_at = time;
    events_.push_back(j);
  }
  for (const int j : joints) {
    model_.joints[j].state = JointState::failed;
    weaken(model_.joints[j], std::min(0.0, model_.joints[j].left_with.normal));
    begin_bridges(model_, model_.joints[j]);
  }
  model_.fragment = find_fragments(model_);
}

void Fracture::recall_tractions() {
  for (const int j : events_)
    if (!model_.joints[j].bridged)
      for (JointPoint& point : model_.joints[j].points) {
        point.normal = model_.joints[j].left_with.normal;
        point.shear = model_.joints[j].left_with.shear;
      }
}

void Fracture::add_strain(int block, const BlockStrain& strain) {
  BlockShape& shape = model_.shapes[block];
  const Mat3 d = elasticity(model_.material(block));
  before_strain_.push_back({block, shape.initial_stress, {}, model_.added_strain_energy});
  model_.added_strain_energy +=
      strain.dot(initial_strain_force(model_, block) + strain_stiffness(model_, block) * strain / 2);
  shape.initial_stress += d * strain.head<3>();
  if (!shape.second_order()) return;
  QuadraticShape& quadratic = model_.quadratic_shapes[shape.quadratic];
  before_strain_.back().gradients = {quadratic.stress_x, quadratic.stress_y};
  quadratic.stress_x += d * shape.bend().strain_rows(Vec2::UnitX()) * strain.tail<6>();
  quadratic.stress_y += d * shape.bend().strain_rows(Vec2::UnitY()) * strain.tail<6>();
}

bool Fracture::waits(int joint) const {
  return std::ranges::find(held_back_, joint) != held_back_.end();
}

void Fracture::heal() {
  held_back_.clear();
  if (events_.empty()) return;
  for (; !before_strain_.empty(); before_strain_.pop_back()) {
    const Before& before = before_strain_.back();
    BlockShape& shape = model_.shapes[before.block];
    shape.initial_stress = before.stress;
    if (shape.second_order()) {
      QuadraticShape& quadratic = model_.quadratic_shapes[shape.quadratic];
      quadratic.stress_x = before.gradients[0];
      quadratic.stress_y = before.gradients[1];
    }
    model_.added_strain_energy = before.energy;
  }
  for (const int j : events_) {
    Joint& joint = model_.joints[j];
    joint.state = JointState::intact;
    joint.mode = FailureMode::none;
    joint.crack = CrackKind::none;
    joint.failed_at = 0;
    joint.failed_with = joint.left_with = {};
    joint.remaining = {};
    joint.most_opening = joint.most_slip = 0;
    joint.off_path = Vec2::Zero();
    joint.path_turn = 0;
    joint.bridged = false;
  }
  events_.clear();
  model_.fragment = find_fragments(model_);
}

void Fracture::weaken() {
  std::vector<double> pressed(model_.joints.size(), 0.0);  // N/m
  for (const Contact& c : model_.contacts)
    if (c.joint >= 0) pressed[c.joint] += c.normal_force;
  for (const int j : breakable_) {
    Joint& joint = model_.joints[j];
    if (joint.state != JointState::failed) continue;
    joint.most_opening = std::max(joint.most_opening, joint_jump(joint, &JointPoint::opening));
    joint.most_slip = std::max(joint.most_slip, std::abs(joint_jump(joint, &JointPoint::slip)));
    weaken(joint, -pressed[j] / joint.length);
    wear_bridges(model_, joint);
  }
}

void Fracture::weaken(Joint& joint, double normal) {
  const JointProperty& property = model_.scene.properties[joint.property];
  const Strength intact = model_.strength(joint);
  const Strength left = property.reduction ? property.reduction(intact, {joint.most_slip, joint.most_opening, normal})
                                           : property.residual;
  // The residual is the property's; the strength of this one may be scattered below it.
  joint.remaining = {left.friction, std::min(left.cohesion, intact.cohesion), std::min(left.tension, intact.tension)};
}

void Fracture::restored() {
  model_.fragment = find_fragments(model_);
}

}  // namespace talus
