#include "equations/bridge_terms.h"

#include <algorithm>
#include <cmath>

#include "equations/bridge_law.h"
#include "equations/jump.h"

namespace talus {

namespace {

// Part of the reach over which the slope of a law is taken: small against what a law changes over, large against
// rounding.
constexpr double slope_step = 1e-3;
// Of a jump, that places are rounded by: far above 1e-16 of a scene over the jump, far below what is worn in a step.
constexpr double jump_rounding = 1e-9;

struct Pull {
  double traction = 0, tangent = 0, line = 0;  // Pa, Pa/m; slope of the line
};

// `strength(worn)`: f above. x >= 0.
template <class Law>
Pull pull(const Bridge& bridge, double x, const Law& strength) {
  if (bridge.reach <= 0) return {};
  const double beyond = x - bridge.reach;
  if (beyond < bridge.worn - jump_rounding * x) {  // at its worst jump it is expected to go on
    const double line = strength(bridge.worn) / (bridge.reach + bridge.worn);
    return {std::max(0.0, line * x), x > 0 ? line : 0, line};
  }
  const double f = strength(beyond), step = slope_step * bridge.reach;
  return {f, (strength(beyond + step) - f) / step, f / x};
}

// Without traction, on its line, on the falling branch.
int branch(const Bridge& bridge, double x) {
  return x <= 0 ? 0 : x < bridge.reach + bridge.worn ? 1 : 2;
}
int sided(const Bridge& bridge, double s) {
  return s < 0 ? -branch(bridge, -s) : branch(bridge, s);
}

struct Pulls {
  Pull across, along;
};

Pulls pulls(const Model& model, const Joint& joint, const JointPoint& point, double opening, double slip) {
  const BridgeLaws laws(model, joint);
  const double x = opening - point.across.origin, s = slip - point.along.origin;
  // Each wears by the other too, at once: what is found is still in equilibrium when its wear is kept (wear_bridges).
  const double across = worn_by(point.across, x), along = worn_by(point.along, std::abs(s));
  Pulls both;
  both.across = pull(point.across, x, [&](double worn) { return laws.tension(along, worn); });
  both.along = pull(point.along, std::abs(s), [&](double worn) { return laws.cohesion(worn, across); });
  both.along.traction = std::copysign(both.along.traction, s);
  return both;
}

Bridge begun(double jump, double traction, double strength, double stiffness) {
  const double carried = std::clamp(traction, -strength, strength);
  return {.origin = jump - carried / stiffness,
          .reach = strength / stiffness,
          .worn = 0,
          .now = carried / stiffness,
          .traction = carried};
}

}  // namespace

void store_bridge_traction(const Joint& joint, JointPoint& point) {
  const BondTraction own = from_path(joint, {point.across.traction, point.along.traction});
  point.normal = own.normal;
  point.shear = own.shear;
}

Strength contact_part(const Model& model, const Joint& joint) {
  return {joint.remaining.friction,
          std::min(joint.remaining.cohesion, model.scene.properties[joint.property].residual.cohesion), 0};
}

void begin_bridges(const Model& model, Joint& joint) {
  const JointProperty& property = model.scene.properties[joint.property];
  if (!property.reduction) return;
  const BridgeLaws laws(model, joint);
  const double tension = laws.tension(0, 0), cohesion = laws.cohesion(0, 0),
               stiffness = model.stiffness_per_area(property, joint.a, joint.b);
  joint.bridged = tension > 0 || cohesion > 0;
  const BondTraction t = mean_traction(joint);
  const BondTraction faces = taken_over(t, contact_part(model, joint));
  const BondTraction carried = to_path(joint, {t.normal - faces.normal, t.shear - faces.shear});
  for (JointPoint& point : joint.points) {
    const BondTraction jump = to_path(joint, {point.opening, point.slip});
    point.across = begun(jump.normal, std::max(0.0, carried.normal), tension, stiffness);
    point.along = begun(jump.shear, carried.shear, cohesion, stiffness);
  }
}

void wear_bridges(const Model& model, Joint& joint) {
  if (!joint.bridged) return;
  const BridgeLaws laws(model, joint);
  joint.bridged = false;
  for (JointPoint& point : joint.points) {
    point.across.worn = worn_by(point.across, point.across.now);
    point.along.worn = worn_by(point.along, std::abs(point.along.now));
    joint.bridged = joint.bridged || laws.tension(point.along.worn, point.across.worn) > 0 ||
                    laws.cohesion(point.along.worn, point.across.worn) > 0;
  }
  if (!joint.bridged)
    for (JointPoint& point : joint.points)
      point.normal = point.shear = point.across.traction = point.along.traction = 0;
}

void BridgeTerms::find_slots(const Model& model, const BlockMatrix& matrix) {
  slots_.clear();
  for (size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    if (joint.bridged)
      slots_.push_back(
          {int(j), matrix.slot(joint.a, joint.a), matrix.slot(joint.b, joint.b), matrix.slot(joint.a, joint.b)});
  }
}

void BridgeTerms::add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) const {
  if (slots_.empty()) return;
  const Ends ends(model, scheme.dt);
  for (const Slots& slots : slots_) {
    const Joint& joint = model.joints[slots.joint];
    if (model.sleeps(joint.a) || model.sleeps(joint.b)) continue;
    with_size(touches_second_order(joint), [&](auto n) { add_bridge<n>(model, poses, ends, scheme, slots, system); });
  }
}

template <int size>
void BridgeTerms::add_bridge(const Model& model, const Poses& poses, const Ends& ends, const Scheme& scheme,
                             const Slots& slots, System& system) const {
  const Joint& joint = model.joints[slots.joint];
  const Pose &a = poses.blocks[joint.a], &b = poses.blocks[joint.b];
  const Vec2 n = Rotation::of(joint.path_turn).turn(turned_normal(joint, a, b)), t = perp(n);
  const Jump<size> jump(model, ends, joint, scheme);
  const auto turned = turns_.find(slots.joint);
  MatrixOf<size> kaa = MatrixOf<size>::Zero(), kbb = kaa, kab = kaa;
  ColumnOf<size> fa = ColumnOf<size>::Zero(), fb = fa;
  for (const JointPoint& point : joint.points) {
    const Vec2 in_a = between(joint.in_a, point.at), in_b = between(joint.in_b, point.at);
    const Vec2 at = (a.place(in_a) + b.place(in_b)) / 2;
    const RowsOf<size> ta = a.rows<size>(in_a, at), tb = b.rows<size>(in_b, at);
    const Vec2 gap = jump.at(in_a, in_b);
    const auto [across, along] = pulls(model, joint, point, gap.dot(n), gap.dot(t));
    const Turns turns = turned == turns_.end() ? Turns{} : turned->second[size_t(&point - joint.points.begin())];
    const Mat2 stiffness = slope(turns, 0, across.tangent, across.line) * n * n.transpose() +
                           slope(turns, 1, along.tangent, along.line) * t * t.transpose();
    const Vec2 traction = across.traction * n + along.traction * t;
    const double w = point.weight;
    fa += w * ta.transpose() * traction;
    fb -= w * tb.transpose() * traction;
    const double wk = w * scheme.bond_d;
    kaa += wk * ta.transpose() * stiffness * ta;
    kbb += wk * tb.transpose() * stiffness * tb;
    kab -= wk * ta.transpose() * stiffness * tb;
  }
  const BlockShape &shape_a = model.shapes[joint.a], &shape_b = model.shapes[joint.b];
  system.add_force(shape_a, joint.a, fa);
  system.add_force(shape_b, joint.b, fb);
  if (shape_a.dofs) system.matrix.add(slots.aa, false, kaa);
  if (shape_b.dofs) system.matrix.add(slots.bb, false, kbb);
  if (shape_a.dofs && shape_b.dofs) system.matrix.add(slots.ab, slots.ab.row != joint.a, kab);
}

double BridgeTerms::slope(const Turns& turns, int direction, double own, double line) const {
  constexpr int once = 2, often = 4;  // there and back; twice
  const int count = turns.count[size_t(direction)];
  if (count >= often) return line;
  return own >= 0 ? own : count < once ? share_ * own : 0;
}

void BridgeTerms::watch(const Model& model) {
  constexpr int forgets_after = 4;
  for (const Slots& slots : slots_) {
    const Joint& joint = model.joints[slots.joint];
    const auto [at, first] = turns_.try_emplace(slots.joint);
    for (size_t p = 0; p < joint.points.size(); ++p) {
      const JointPoint& point = joint.points[p];
      const std::array now = {branch(point.across, point.across.now), sided(point.along, point.along.now)};
      Turns& turns = at->second[p];
      for (size_t k = 0; k < now.size(); ++k) {
        const bool turned = !first && now[k] != turns.branch[k];
        turns.quiet[k] = turned ? 0 : turns.quiet[k] + 1;
        turns.count[k] = turned ? turns.count[k] + 1 : turns.quiet[k] > forgets_after ? 0 : turns.count[k];
      }
      turns.branch = now;
    }
  }
}

void BridgeTerms::store_tractions(Model& model) const {
  for (Joint& joint : model.joints) {
    if (!joint.bridged) continue;
    for (JointPoint& point : joint.points) {
      const BondTraction jump = to_path(joint, {point.opening, point.slip});
      const auto [across, along] = pulls(model, joint, point, jump.normal, jump.shear);
      point.across.now = jump.normal - point.across.origin;
      point.along.now = jump.shear - point.along.origin;
      point.across.traction = across.traction;
      point.along.traction = along.traction;
      store_bridge_traction(joint, point);
    }
  }
}

double bridge_energy(const Joint& joint) {
  double sum = 0;
  if (!joint.bridged) return sum;
  for (const JointPoint& point : joint.points) sum += bridge_energy(point);
  return sum;
}

double bridge_work(const Joint& now, const Joint& then) {
  double sum = 0;
  for (size_t p = 0; p < now.points.size(); ++p) {
    const JointPoint &n = now.points[p], &t = then.points[p];
    const BondTraction way = to_path(now, {n.opening - t.opening, n.slip - t.slip});
    sum += n.weight / 2 *
           ((n.across.traction + t.across.traction) * way.normal + (n.along.traction + t.along.traction) * way.shear);
  }
  return sum;
}

}  // namespace talus
