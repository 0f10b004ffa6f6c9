#include "equations/bridge_motion.h"

#include <cmath>
#include <tuple>

#include "equations/bridge_terms.h"
#include "equations/jump.h"

namespace talus {

namespace {

// Parts of a strength: a branch is the right one where its traction is the law's to the first; the mean of the
// strengths is found again until it changes by less than the second.
constexpr double same_traction = 1e-8, same_strength = 1e-3;

double change(const Row& row, int dof, int size, const Vector& d) {
  double sum = 0;
  for (int k = 0; k < size; ++k) sum += row[k] * d[dof + k];
  return sum;
}

}  // namespace

double BridgeMotion::Direction::at(double x) const {
  return branch == Branch::loose ? 0 : branch == Branch::line ? slope * x : sign * limit;
}

// To the branch on which the solution is; not over the line, or it would go to and fro between its two ends.
void BridgeMotion::Direction::go_on(bool across) {
  const Branch found = across && to <= 0              ? Branch::loose
                       : std::abs(slope * to) < limit ? Branch::line
                                                      : Branch::constant;
  const bool over = (branch == Branch::loose && found == Branch::constant) ||
                    (branch == Branch::constant && found == Branch::loose) ||
                    (branch == Branch::constant && found == Branch::constant && sign * to < 0);
  branch = over ? Branch::line : found;
  sign = std::copysign(1.0, to);
}

void BridgeMotion::begin(const Model& model) {
  points_.clear();
  laws_.clear();
  strength_.clear();
  rounds_ = 0;
  for (int j = 0; j < int(model.joints.size()); ++j) {
    const Joint& joint = model.joints[j];
    if (!joint.bridged || model.sleeps(joint.a) || model.sleeps(joint.b)) continue;
    const BridgeLaws laws(model, joint);
    const BlockShape &a = model.shapes[joint.a], &b = model.shapes[joint.b];
    for (int p = 0; p < int(joint.points.size()); ++p) {
      const JointPoint& at = joint.points[p];
      Point& point = points_.emplace_back();
      point.joint = j;
      point.point = p;
      point.dof_a = a.dof_begin;
      point.dof_b = b.dof_begin;
      point.size_a = a.dofs;
      point.size_b = b.dofs;
      const std::array strengths = {laws.tension(at.along.worn, at.across.worn),
                                    laws.cohesion(at.along.worn, at.across.worn)};
      for (size_t k = 0; k < 2; ++k) {
        const Bridge& bridge = k == 0 ? at.across : at.along;
        Direction& own = point.along[k];
        own.from = bridge.now;
        own.worn = bridge.worn;
        own.reach = bridge.reach;
        own.first = own.limit = bridge.reach > 0 ? strengths[k] : 0;
        own.slope = own.first > 0 ? own.first / (bridge.reach + bridge.worn) : 0;
        own.sign = std::copysign(1.0, own.from);
        const bool loose = own.first <= 0 || (k == 0 && own.from <= 0);
        own.branch = loose                                       ? Branch::loose
                     : std::abs(own.from) < own.reach + own.worn ? Branch::line
                                                                 : Branch::constant;
      }
      laws_.push_back(laws);
      strength_.push_back(std::max(laws.tension(0, 0), laws.cohesion(0, 0)));
    }
  }
}

void BridgeMotion::add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) {
  factor_ = scheme.contact_d;
  Scheme begin = scheme, end = scheme;
  begin.bond_end = begin.bond_d = 0;
  end.bond_end = 1;
  end.bond_d = factor_;
  const Ends ends(model, scheme.dt);
  for (Point& point : points_) {
    const Joint& joint = model.joints[point.joint];
    const Pose &a = poses.blocks[joint.a], &b = poses.blocks[joint.b];
    const Vec2 n = Rotation::of(joint.path_turn).turn(turned_normal(joint, a, b));
    const std::array axes = {n, perp(n)};
    with_size(touches_second_order(joint), [&](auto size) {
      const double at = joint.points[size_t(point.point)].at;
      const Vec2 in_a = between(joint.in_a, at), in_b = between(joint.in_b, at);
      const Vec2 middle = (a.place(in_a) + b.place(in_b)) / 2;
      const RowsOf<size> rows_a = a.rows<size>(in_a, middle), rows_b = b.rows<size>(in_b, middle);
      const Vec2 moved =
          Jump<size>(model, ends, joint, end).at(in_a, in_b) - Jump<size>(model, ends, joint, begin).at(in_a, in_b);
      for (size_t k = 0; k < 2; ++k) {
        Direction& own = point.along[k];
        own.free = own.from + moved.dot(axes[k]);
        own.row_a.fill(0);
        own.row_b.fill(0);
        Eigen::Map<ColumnOf<size>>(own.row_a.data()) = -rows_a.transpose() * axes[k];
        Eigen::Map<ColumnOf<size>>(own.row_b.data()) = rows_b.transpose() * axes[k];
      }
    });
    add_point(model, point, system);
  }
}

// Of the law's branch: its traction at d = 0, and its slope.
void BridgeMotion::add_point(const Model& model, const Point& point, System& system) const {
  const Joint& joint = model.joints[point.joint];
  const double w = joint.points[size_t(point.point)].weight;
  for (const Direction& own : point.along) {
    if (own.branch == Branch::loose) continue;
    const Eigen::Map<const ColumnOf<max_dofs>> a(own.row_a.data()), b(own.row_b.data());
    const double pull = w * own.at(own.free);
    system.add_force<max_dofs>(model.shapes[joint.a], joint.a, -pull * a);
    system.add_force<max_dofs>(model.shapes[joint.b], joint.b, -pull * b);
    if (own.branch != Branch::line) continue;
    const auto stiffen = [&](int row, int column, const Row& u, const Row& v) {
      system.matrix.add_outer(system.matrix.slot(row, column), w * own.slope * factor_, u.data(), v.data());
    };
    if (point.size_a) stiffen(joint.a, joint.a, own.row_a, own.row_a);
    if (point.size_b) stiffen(joint.b, joint.b, own.row_b, own.row_b);
    if (!point.size_a || !point.size_b) continue;
    if (joint.a < joint.b)
      stiffen(joint.a, joint.b, own.row_a, own.row_b);
    else
      stiffen(joint.b, joint.a, own.row_b, own.row_a);
  }
}

bool BridgeMotion::agrees(const Vector& d) {
  bool same = true;
  ++rounds_;
  for (size_t p = 0; p < points_.size(); ++p) {
    Point& point = points_[p];
    std::array<double, 2> worn;
    for (size_t k = 0; k < 2; ++k) {
      Direction& own = point.along[k];
      own.to = own.free + factor_ * (change(own.row_a, point.dof_a, point.size_a, d) +
                                     change(own.row_b, point.dof_b, point.size_b, d));
      own.traction = own.at(own.to);
      worn[k] = std::max(own.worn, (k == 0 ? own.to : std::abs(own.to)) - own.reach);
    }
    const std::array strengths = {laws_[p].tension(worn[1], worn[0]), laws_[p].cohesion(worn[1], worn[0])};
    for (size_t k = 0; k < 2; ++k) {
      Direction& own = point.along[k];
      if (own.first <= 0) continue;
      const double line = own.slope * (k == 0 ? std::max(0.0, own.to) : own.to);
      const double law = std::clamp(line, -own.limit, own.limit), mean = (own.first + strengths[k]) / 2;
      const bool branch = std::abs(own.traction - law) <= same_traction * strength_[p];
      const bool strength = rounds_ > settling_rounds || std::abs(mean - own.limit) <= same_strength * strength_[p];
      if (branch && strength) continue;
      same = false;
      if (!branch) own.go_on(k == 0);
      if (rounds_ <= settling_rounds) own.limit = mean;
    }
  }
  return same;
}

double BridgeMotion::shift_loss(const Model& model, const Scheme& scheme, const Vector& d) const {
  double loss = 0;
  for (const Point& point : points_) {
    const Joint& joint = model.joints[point.joint];
    const double w = joint.points[size_t(point.point)].weight;
    // Change of the jump along blocks that move by velocity · of_v + d · of_d; of unknowns alone, or of held blocks
    // too.
    const auto along = [&](const Direction& own, double of_v, double of_d, bool held) {
      double sum = 0;
      for (const auto& [row, block, dof, size] : {std::tuple(&own.row_a, joint.a, point.dof_a, point.size_a),
                                                  std::tuple(&own.row_b, joint.b, point.dof_b, point.size_b)}) {
        const auto& v = model.blocks[block].velocity;
        for (int k = 0; k < (held && size == 0 ? rigid_dofs : size); ++k)
          sum += (*row)[size_t(k)] * (of_v * v[size_t(k)] + (k < size ? of_d * d[dof + k] : 0));
      }
      return sum;
    };
    for (const Direction& own : point.along) {
      loss += w * own.traction * (along(own, scheme.step_v, scheme.move_d, true) - (own.to - own.from));
      if (own.branch != Branch::line) continue;
      loss -= w * own.slope * factor_ / scheme.bond_d * along(own, scheme.step_v, scheme.move_d, false) *
              along(own, scheme.bond_v, scheme.bond_d - scheme.move_d / 2, false);
    }
  }
  return loss;
}

double BridgeMotion::lead(const Model& model) {
  double more = 0;
  for (size_t p = 0; p < points_.size(); ++p) {
    Point& point = points_[p];
    const JointPoint& from = model.joints[point.joint].points[size_t(point.point)];
    JointPoint& at = point.led_to = from;
    at.across.now = point.along[0].to;
    at.along.now = point.along[1].to;
    at.across.worn = worn_by(at.across, at.across.now);
    at.along.worn = worn_by(at.along, std::abs(at.along.now));
    at.across.traction = std::max(0.0, on_line(at.across, laws_[p].tension(at.along.worn, at.across.worn)));
    at.along.traction = on_line(at.along, laws_[p].cohesion(at.along.worn, at.across.worn));
    more += bridge_energy(at) - bridge_energy(from);
  }
  return more;
}

double BridgeMotion::keep(Model& model) const {
  double taken = 0;
  for (const Point& point : points_) {
    JointPoint& at = model.joints[point.joint].points[size_t(point.point)];
    for (const Direction& own : point.along) taken += at.weight * own.traction * (own.to - own.from);
    at = point.led_to;
    store_bridge_traction(model.joints[point.joint], at);
  }
  return taken;
}

}  // namespace talus
