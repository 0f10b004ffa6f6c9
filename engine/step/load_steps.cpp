#include "step/load_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "step/closure.h"
#include "step/restored.h"

namespace talus {

namespace {

constexpr double least_increment = 1e-6;  // part of t_end
// Contacts that open or begin to slide bend the curve of loads over displacements, whose trapezoids are booked: an increment that is off by
// this part of the work put in by it is taken in quarters, down to this part of a load step. What is given off in the shortest is a jump.
constexpr double most_bend = 0.01;
constexpr double least_bend = 1e-6;  // part of the ledger's scale: what moves along free is not looked at so closely
constexpr double finest_increment = 1.0 / 256;  // and of the way of loads in a jump
constexpr double same_bend = 0.01;  // part, by which two parts of a load step are off alike: loads jump, which no part of the time resolves
// Bounds of a load step, so that it ends whatever its contacts and bonds do. What stands is found in some hundreds of
// solves, also where bonds soften near their limit.
constexpr int most_search_solves = 1000;  // of one look for equilibrium
constexpr int most_vain_solves = 3000;    // of all those of a load step that found none
constexpr int careful_cuts = 4;           // as interpolated; those that follow halve an increment at least
// In a row, that neither come to the load asked for nor break a bond.
constexpr int most_short_increments = 60;

// J/m, by loads and supports, to and fro.
double exchanged(const Ledger& before, const Ledger& now) {
  return std::abs(now.boundary_work - before.boundary_work) + std::abs(now.external_work - before.external_work) +
         std::abs(now.gravity_work - before.gravity_work);
}

double bend_allowed(const Ledger& before, const Ledger& now) { return std::max(most_bend * exchanged(before, now), least_bend * now.scale()); }

void add_part(const StepReport& part, StepReport& whole) {
  whole.iterations += part.iterations;
  whole.residual = std::max(whole.residual, part.residual);
  whole.displacement += part.displacement;  // at most
}

class LoadsOnTheWay {  // while this lives
 public:
  LoadsOnTheWay(Model& model, double from, double part) : model_(model) { model_.load_way = {from, part}; }
  ~LoadsOnTheWay() { model_.load_way = {}; }
  LoadsOnTheWay(const LoadsOnTheWay&) = delete;
  LoadsOnTheWay& operator=(const LoadsOnTheWay&) = delete;
  void come(double part) { model_.load_way.part = part; }

 private:
  Model& model_;
};

class Unstressed {  // blocks without their initial stress, while this lives
 public:
  explicit Unstressed(Model& model) : model_(model), quadratic_(model.quadratic_shapes) {
    for (BlockShape& shape : model.shapes) stress_.push_back(std::exchange(shape.initial_stress, Vec3::Zero()));
    for (QuadraticShape& shape : model.quadratic_shapes) shape.stress_x = shape.stress_y = Vec3::Zero();
  }
  ~Unstressed() {
    model_.quadratic_shapes = std::move(quadratic_);
    for (size_t b = 0; b < stress_.size(); ++b) model_.shapes[b].initial_stress = stress_[b];
  }
  Unstressed(const Unstressed&) = delete;
  Unstressed& operator=(const Unstressed&) = delete;

 private:
  Model& model_;
  std::vector<QuadraticShape> quadratic_;
  std::vector<Vec3> stress_;
};

}  // namespace

LoadSteps::LoadSteps(StepParts& parts)
    : parts_(parts), model_(parts.model), plan_(parts.plan), totals_(parts.totals), ledger_(parts.ledger), equilibrium_(parts) {}

StepReport LoadSteps::step(double to, bool first) {
  const StepReport report = take(to, first);
  for (Fixity& fixity : model_.scene.fixities) fixity.go_on(model_.time);
  return report;
}

StepReport LoadSteps::take(double to, bool first) {
  parts_.prepare_bonds();
  // What touches at the start, before supports move: they would press from the start on only with what comes after.
  if (first && plan_.contacts) parts_.search.update(model_, 0);
  if (!parts_.fracture) return load(to, first);
  const std::vector<int> due = first ? std::vector<int>{} : parts_.fracture->choose(false);
  parts_.fracture->clear_events();
  return due.empty() ? raise_load(to, first) : break_bonds(due);
}

// Where no bond can fail. What slides to and fro in it is followed to where it turns round, in parts of its time, and where loads jump of their way.
StepReport LoadSteps::load(double to, bool first) {
  const bool moving = moves_supports(model_.scene);  // the script may have let one go since the plan was made
  const bool slides = plan_.contacts && loads_change(model_.scene);
  const double target = plan_.contacts && moving ? reachable(to) : to;
  StepReport report;
  Part part{model_.time, target};
  double left = 0;  // J/m, unexplained by the last attempt that was thrown away
  for (;;) {
    std::optional<Restored> attempt;
    std::optional<Closure> closure;
    if (slides) {
      attempt.emplace(model_);
      closure.emplace(model_, parts_.joints, std::vector<int>{});
    }
    model_.time = part.until;
    LoadsOnTheWay loads(model_, part.from, part.come > 0 ? part.come : 1);
    const LoadStepBooking booking(model_, parts_.supports, part.come > 0 ? part.until : part.from, first);
    loads.come(part.go);
    const Ledger before = ledger_;
    EquilibriumSearch search;
    search.in_place = !moving;
    if (!equilibrium_.balance(search)) equilibrium_.give_up(search);
    book(booking, first);
    const double off = closure ? closure->work(model_, ledger_.friction_work - before.friction_work) : 0;
    if (std::abs(off) > bend_allowed(before, ledger_) && quarter(part, std::abs(off - left) <= same_bend * std::abs(off), first)) {
      left = off;
      ledger_ = before;
      ++report.cuts;
      ++totals_.cuts;
      continue;
    }
    if (attempt) attempt->keep();
    add_part(search.report, report);
    first = false;
    left = 0;
    if (part.go < 1) {
      part.come = std::exchange(part.go, 1);
      continue;
    }
    if (part.until == target) return report;
    for (Fixity& fixity : model_.scene.fixities) fixity.go_on(part.until);
    part = {part.until, target};
  }
}

// `alike`: the last quarter was off by as much. What loads grow from in the first is no load at all.
bool LoadSteps::quarter(Part& part, bool alike, bool first) const {
  const bool jumps = part.come > 0 || part.go < 1;
  if (!jumps && !alike && may_quarter(part.until - part.from)) {
    part.until = part.from + (part.until - part.from) / 4;
    return true;
  }
  if (first || (!jumps && !alike) || part.go - part.come <= finest_increment) return false;
  part.go = part.come + (part.go - part.come) / 4;
  return true;
}

// Whether a part of a load step may still be taken in quarters.
bool LoadSteps::may_quarter(double increment) const {
  const TimeControl& time = model_.scene.time;
  return increment > finest_increment * time.t_end / time.steps;
}

// The energy stored is linear in an initial stress, which grows in the first load step as the loads do: half of what it has put in.
void LoadSteps::book(const LoadStepBooking& booking, bool first) {
  if (first && plan_.initial_stress) {
    const double all = parts_.energies().strain;
    const Unstressed unstressed(model_);
    ledger_.external_work += (all - parts_.energies().strain) / 2;
  }
  booking.book(model_, parts_.supports, ledger_);
}

// How far a load step may go towards `to`: what is held or supported moves no farther in it than a step in motion may, or blocks that it pushes
// would be held back in its search and slide by steps of that. Where a table jumps there is no such time.
double LoadSteps::reachable(double to) const {
  const double from = model_.time, most = model_.scene.time.displacement_ratio * model_.extent;
  double until = to;
  for (int looks = 0; looks < 40; ++looks) {
    double far = 0;
    for (const Fixity& fixity : model_.scene.fixities) far = std::max(far, (fixity.moved(until) - fixity.moved(from)).norm());
    if (far <= most * (1 + 1e-9)) return until;
    until = from + (until - from) * std::max(0.5, most / far);
  }
  return to;
}

// Where the first bond comes to its strength if utilisations go on as they have come up. Farther each time that it has
// not come to it.
double LoadSteps::foreseen(double from, double to, double utilisation) const {
  if (!(utilisation > 0)) return to;
  const double ahead = from * ((1 + model_.scene.fracture.overshoot / 2) / utilisation - 1);
  return ahead > 0 ? std::min(to, from + ahead * std::pow(2.0, short_increments_)) : to;
}

// Utilisations grow about in proportion to the load: an increment that passes a strength by more than the overshoot is
// taken again, to where the first bond reaches it. So is one on whose way the rock would jump, unless utilisations, as
// they have come up, would stay within the overshoot: then the load at which it jumps is known as well as any strength.
StepReport LoadSteps::raise_load(double to, bool first) {
  const double from = model_.time, soonest = std::min(to, from + least_increment * model_.scene.time.t_end);
  const double overshoot = model_.scene.fracture.overshoot, before = parts_.fracture->judge();
  double until = foreseen(from, to, before);
  const double pace = std::max(pace_, from > 0 ? before / from : 0);
  const Closure closure(model_, parts_.joints, {});
  int vain = 0;  // solves
  for (int cuts = 0;; ++cuts) {
    Restored attempt(model_);
    model_.time = until;
    const LoadStepBooking booking(model_, parts_.supports, from, first);
    const BridgeBooking bridges(model_);
    EquilibriumSearch search;
    search.most_solves = most_search_solves;
    search.may_jump = before + pace * (until - from) <= 1 + overshoot || until <= soonest;
    const bool found = equilibrium_.balance(search);
    search.report.cuts = cuts;
    if (!found) vain += search.report.iterations;
    const double after = found ? parts_.fracture->judge() : 0;
    search.report.utilisation = after;
    if (found && (after <= 1 + overshoot || search.jumped || until <= soonest)) {
      const Ledger ledger = ledger_;
      book(booking, first);
      bridges.book(model_, ledger_);
      const double off = closure.work(model_, ledger_.friction_work - ledger.friction_work);
      const bool bent = std::abs(off) > bend_allowed(ledger, ledger_);
      if (!search.jumped && bent && may_quarter(until - from) && until > soonest) {
        ledger_ = ledger;
        until = from + (until - from) / 4;
        ++totals_.cuts;
        continue;
      }
      attempt.keep();
      if (search.jumped || (bent && off > 0))
        ledger_.fracture_work += off;
      else if (until > from)
        pace_ = (after - before) / (until - from);
      parts_.fracture->weaken();
      short_increments_ = until < to && !parts_.bonds_due() ? short_increments_ + 1 : 0;
      return search.report;
    }
    const bool enough = vain > most_vain_solves || short_increments_ > most_short_increments;
    if (!found && (until <= soonest || enough)) {
      if (totals_.failures == 0) equilibrium_.give_up(search);
      const StepReport report = collapse(search);
      attempt.back();
      return report;
    }
    const double part = found ? (1 + overshoot / 2 - before) / (after - before) : 0.25;
    until = std::max(from + std::clamp(part, 0.01, cuts < careful_cuts ? 0.95 : 0.5) * (until - from), soonest);
    ++totals_.cuts;
  }
}

StepReport LoadSteps::break_bonds(const std::vector<int>& due) {
  const double most = parts_.fracture->judge();
  const LoadStepBooking booking(model_, parts_.supports, model_.time, false);
  const double by_bonds = parts_.fail(due, model_.time, false).energy;
  parts_.search.update(model_, 0);
  const double released = by_bonds - parts_.contacts_of_events();
  const Closure closure(model_, parts_.joints, due);
  const BridgeBooking bridges(model_);
  Restored at_failure(model_);
  EquilibriumSearch search;
  search.most_solves = most_search_solves;
  StepReport report;
  if (equilibrium_.balance(search)) {
    at_failure.keep();
    report = search.report;
    const double friction = ledger_.friction_work;
    booking.book(model_, parts_.supports, ledger_);
    ledger_.fracture_work += released + closure.work(model_, ledger_.friction_work - friction);
    bridges.book(model_, ledger_);
    parts_.fracture->weaken();
    parts_.fracture->judge();
  } else {
    report = collapse(search);
    at_failure.back();
    ledger_.fracture_work += released;
  }
  report.utilisation = most;
  report.failures = int(due.size());
  return report;
}

StepReport LoadSteps::collapse(const EquilibriumSearch& search) {
  collapse_ = equilibrium_.culprit(search) + " keeps moving";
  const std::string alternating = search.alternation.text(model_);
  if (!alternating.empty()) collapse_ += "; " + alternating;
  StepReport report;
  report.collapsed = true;
  return report;
}

void LoadSteps::visit_state(StateVisitor& visitor) {
  visitor("short_increments", short_increments_);
  visitor("pace", pace_);
}

std::string LoadSteps::collapse_note() const {
  return "no equilibrium beyond t = " + std::to_string(model_.time) + " s: " + collapse_ +
         "; the run ends with the last equilibrium there was";
}

}  // namespace talus
