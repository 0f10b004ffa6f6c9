// Static loading: increments of load that stop where the first bond reaches its strength, and bonds that fail under a load
// held until nothing more breaks.
#include <algorithm>
#include <cmath>

#include "equations/bridge_law.h"
#include "step/energies.h"
#include "step/restored.h"
#include "step/step.h"

namespace talus {

namespace {

constexpr double least_increment = 1e-6;  // part of t_end
// Bounds of a load step, so that it ends whatever its contacts and bonds do. What stands is found in some hundreds of
// solves, also where bonds soften near their limit.
constexpr int most_search_solves = 1000;  // of one look for equilibrium
constexpr int most_vain_solves = 3000;    // of all those of a load step that found none
constexpr int careful_cuts = 4;           // as interpolated; those that follow halve an increment at least
// In a row, that neither come to the load asked for nor break a bond.
constexpr int most_short_increments = 60;

// What the rock gives off on its way from one equilibrium to another that it jumps to, as bonds fail or soften past what they
// bear. Bodies are elastic, so they give off ∫ t · dg = ½ (t0 + t1) · (g1 - g0) over all jumps g that tractions t act across (the
// crack closure integral of Irwin 1957, read backwards); contacts and bridges store some of it, friction takes some. Of bonds
// that fail, t0 is that of the bond, and the change of {σ}n works along the jump it had.
class Closure {
 public:
  Closure(const Model& model, const JointTerms& bonds, const std::vector<int>& joints)
      : bonds_(bonds), joints_(joints), vertex_(model.vertex), stored_(contact_energy(model)) {
    std::vector<char> fails(model.joints.size(), 0);
    for (const int j : joints) {
      fails[size_t(j)] = 1;
      before_.push_back({model.joints[j].points, fluxes(model, j)});
    }
    for (const Contact& c : model.contacts)
      if (pushes(c) && (c.joint < 0 || !fails[size_t(c.joint)])) pushed_.push_back({c, push(model, c)});
  }
  // friction: J/m, that contacts took on the way.
  double work(const Model& model, double friction) const {
    double sum = stored_ - contact_energy(model) - friction;
    for (size_t k = 0; k < joints_.size(); ++k) sum += of_bond(model, k);
    for (const auto& [c, force] : pushed_) sum -= force.dot(moved(model, c)) / 2;
    for (const Contact& c : model.contacts)
      if (pushes(c)) sum -= push(model, c).dot(moved(model, c)) / 2;
    return sum;
  }

 private:
  struct Before {
    JointPoints points;
    std::vector<BondTraction> flux;  // at the points
  };
  struct Pushed {
    Contact contact;
    Vec2 force;  // N/m
  };
  static bool pushes(const Contact& c) { return c.normal_force != 0 || c.shear_force != 0; }
  static int other_end(const Model& model, const Contact& c) {
    return model.shapes[c.j].vertex_begin + model.next_vertex(c.j, c.edge);
  }
  // On the corner.
  static Vec2 push(const Model& model, const Contact& c) {
    const Vec2 along = (model.vertex[other_end(model, c)] - model.vertex[c.global_edge]).normalized();
    return -c.normal_force * perp(along) - c.shear_force * along;
  }
  // A corner from the point of the edge that it lay beside, m.
  Vec2 moved(const Model& model, const Contact& c) const {
    const int end = other_end(model, c);
    const Vec2 edge = vertex_[end] - vertex_[c.global_edge];
    const double at = (vertex_[c.global_vertex] - vertex_[c.global_edge]).dot(edge) / edge.squaredNorm();
    const auto way = [&](int v) -> Vec2 { return model.vertex[v] - vertex_[v]; };
    return way(c.global_vertex) - (1 - at) * way(c.global_edge) - at * way(end);
  }
  double of_bond(const Model& model, size_t k) const {
    const Joint& joint = model.joints[joints_[k]];
    const std::vector<BondTraction> flux = fluxes(model, joints_[k]);
    double sum = 0;
    for (size_t p = 0; p < joint.points.size(); ++p) {
      const JointPoint &now = joint.points[p], &then = before_[k].points[p];
      const BondTraction bridged = from_path(joint, {then.across.traction, then.along.traction});
      sum += now.weight / 2 *
             ((then.normal - bridged.normal) * (now.opening - then.opening) + (then.shear - bridged.shear) * (now.slip - then.slip) +
              (flux[p].normal - before_[k].flux[p].normal) * then.opening + (flux[p].shear - before_[k].flux[p].shear) * then.slip);
    }
    return sum;
  }
  std::vector<BondTraction> fluxes(const Model& model, int joint) const {
    std::vector<BondTraction> flux;
    for (const JointPoint& point : model.joints[joint].points) flux.push_back(bonds_.flux(model, joint, point.at));
    return flux;
  }
  const JointTerms& bonds_;
  const std::vector<int> joints_;
  std::vector<Vec2> vertex_;
  double stored_;  // J/m, by contacts
  std::vector<Before> before_;
  std::vector<Pushed> pushed_;
};

}  // namespace

StepReport Stepper::load_step(double to, bool first) {
  prepare_bonds();
  // What touches at the start, before supports move: they would press from the start on only with what comes after.
  if (first && plan_.contacts) search_.update(model_, 0);
  if (!fracture_) {
    const double from = model_.time;
    model_.time = to;
    const LoadStepBooking booking(model_, supports_, from, first);
    Equilibrium search;
    if (!balance(search)) give_up(search);
    booking.book(model_, supports_, ledger_);
    return search.report;
  }
  const std::vector<int> due = first ? std::vector<int>{} : fracture_->choose(false);
  fracture_->clear_events();
  return due.empty() ? raise_load(to, first) : break_bonds(due);
}

// Where the first bond comes to its strength if utilisations go on as they have come up. Farther each time that it has
// not come to it.
double Stepper::foreseen(double from, double to, double utilisation) const {
  if (!(utilisation > 0)) return to;
  const double ahead = from * ((1 + model_.scene.fracture.overshoot / 2) / utilisation - 1);
  return ahead > 0 ? std::min(to, from + ahead * std::pow(2.0, short_increments_)) : to;
}

// Utilisations grow about in proportion to the load: an increment that passes a strength by more than the overshoot is
// taken again, to where the first bond reaches it. So is one on whose way the rock would jump, unless utilisations, as
// they have come up, would stay within the overshoot: then the load at which it jumps is known as well as any strength.
StepReport Stepper::raise_load(double to, bool first) {
  const double from = model_.time, soonest = from + least_increment * model_.scene.time.t_end;
  const double overshoot = model_.scene.fracture.overshoot, before = fracture_->judge();
  double until = foreseen(from, to, before);
  const double pace = std::max(pace_, from > 0 ? before / from : 0);
  int vain = 0;  // solves
  for (int cuts = 0;; ++cuts) {
    Restored attempt(model_);
    model_.time = until;
    const LoadStepBooking booking(model_, supports_, from, first);
    const BridgeBooking bridges(model_);
    const Closure closure(model_, joints_, {});
    Equilibrium search;
    search.most_solves = most_search_solves;
    search.may_jump = before + pace * (until - from) <= 1 + overshoot || until <= soonest;
    const bool found = balance(search);
    if (!found) vain += search.report.iterations;
    const double after = found ? fracture_->judge() : 0;
    search.report.utilisation = after;
    if (found && (after <= 1 + overshoot || search.jumped || until <= soonest)) {
      attempt.keep();
      const double friction = ledger_.friction_work;
      booking.book(model_, supports_, ledger_);
      bridges.book(model_, ledger_);
      if (search.jumped)
        ledger_.fracture_work += closure.work(model_, ledger_.friction_work - friction);
      else
        pace_ = (after - before) / (until - from);
      fracture_->weaken();
      short_increments_ = until < to && !bonds_due() ? short_increments_ + 1 : 0;
      return search.report;
    }
    const bool enough = vain > most_vain_solves || short_increments_ > most_short_increments;
    if (!found && (until <= soonest || enough)) {
      if (totals_.failures == 0) give_up(search);
      const StepReport report = collapse(search);
      attempt.back();
      return report;
    }
    const double part = found ? (1 + overshoot / 2 - before) / (after - before) : 0.25;
    until = std::max(from + std::clamp(part, 0.01, cuts < careful_cuts ? 0.95 : 0.5) * (until - from), soonest);
    ++totals_.cuts;
  }
}

StepReport Stepper::break_bonds(const std::vector<int>& due) {
  const double most = fracture_->judge();
  const LoadStepBooking booking(model_, supports_, model_.time, false);
  released_ = 0;
  fail(due, model_.time, false);
  search_.update(model_, 0);
  const double released = released_ - contacts_of_events();
  const Closure closure(model_, joints_, due);
  const BridgeBooking bridges(model_);
  Restored at_failure(model_);
  Equilibrium search;
  search.most_solves = most_search_solves;
  StepReport report;
  if (balance(search)) {
    at_failure.keep();
    report = search.report;
    const double friction = ledger_.friction_work;
    booking.book(model_, supports_, ledger_);
    ledger_.fracture_work += released + closure.work(model_, ledger_.friction_work - friction);
    bridges.book(model_, ledger_);
    fracture_->weaken();
    fracture_->judge();
  } else {
    report = collapse(search);
    at_failure.back();
    ledger_.fracture_work += released;
  }
  report.utilisation = most;
  report.failures = int(due.size());
  return report;
}

StepReport Stepper::collapse(const Equilibrium& search) {
  collapse_ = block_name(model_, culprit(search)) + " keeps moving";
  const std::string alternating = search.alternation.text(model_);
  if (!alternating.empty()) collapse_ += "; " + alternating;
  StepReport report;
  report.collapsed = true;
  return report;
}

std::string Stepper::collapse_note() const {
  return "no equilibrium beyond t = " + std::to_string(model_.time) + " s: " + collapse_ +
         "; the run ends with the last equilibrium there was";
}

}  // namespace talus
