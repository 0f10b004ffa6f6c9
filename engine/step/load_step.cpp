// Static loading: increments of load that stop where the first bond reaches its strength, and bonds that fail under a load
// held until nothing more breaks.
#include <algorithm>
#include <cmath>

#include "step/closure.h"
#include "step/restored.h"
#include "step/step.h"

namespace talus {

namespace {

constexpr double least_increment = 1e-6;  // part of t_end
// Contacts that open or begin to slide bend the curve of loads over displacements, whose trapezoids are booked: an increment that is off by
// this part of the work put in by it is taken in quarters, down to this part of a load step. What is given off in the shortest is a jump.
constexpr double most_bend = 0.01;
constexpr double least_bend = 1e-6;  // part of the ledger's scale: what moves along free is not looked at so closely
constexpr double finest_increment = 1.0 / 256;
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

}  // namespace

StepReport Stepper::load_step(double to, bool first) {
  prepare_bonds();
  // What touches at the start, before supports move: they would press from the start on only with what comes after.
  if (first && plan_.contacts) search_.update(model_, 0);
  if (!fracture_) {
    const double from = model_.time;
    const bool moving = moves_supports(model_.scene);  // the script may have let one go since the plan was made
    model_.time = plan_.contacts && moving ? reachable(to) : to;
    const LoadStepBooking booking(model_, supports_, from, first);
    Equilibrium search;
    search.in_place = !moving;
    if (!balance(search)) give_up(search);
    book_load(booking, first);
    return search.report;
  }
  const std::vector<int> due = first ? std::vector<int>{} : fracture_->choose(false);
  fracture_->clear_events();
  return due.empty() ? raise_load(to, first) : break_bonds(due);
}

// How far a load step may go towards `to`: what is held or supported moves no farther in it than a step in motion may, or blocks that it pushes
// would be held back in its search and slide by steps of that. Where a table jumps there is no such time.
double Stepper::reachable(double to) const {
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
double Stepper::foreseen(double from, double to, double utilisation) const {
  if (!(utilisation > 0)) return to;
  const double ahead = from * ((1 + model_.scene.fracture.overshoot / 2) / utilisation - 1);
  return ahead > 0 ? std::min(to, from + ahead * std::pow(2.0, short_increments_)) : to;
}

// Utilisations grow about in proportion to the load: an increment that passes a strength by more than the overshoot is
// taken again, to where the first bond reaches it. So is one on whose way the rock would jump, unless utilisations, as
// they have come up, would stay within the overshoot: then the load at which it jumps is known as well as any strength.
StepReport Stepper::raise_load(double to, bool first) {
  const double from = model_.time, soonest = std::min(to, from + least_increment * model_.scene.time.t_end);
  const double overshoot = model_.scene.fracture.overshoot, before = fracture_->judge();
  double until = foreseen(from, to, before);
  const double pace = std::max(pace_, from > 0 ? before / from : 0);
  const double whole = model_.scene.time.t_end / model_.scene.time.steps;
  const Closure closure(model_, joints_, {});
  int vain = 0;  // solves
  for (int cuts = 0;; ++cuts) {
    Restored attempt(model_);
    model_.time = until;
    const LoadStepBooking booking(model_, supports_, from, first);
    const BridgeBooking bridges(model_);
    Equilibrium search;
    search.most_solves = most_search_solves;
    search.may_jump = before + pace * (until - from) <= 1 + overshoot || until <= soonest;
    const bool found = balance(search);
    search.report.cuts = cuts;
    if (!found) vain += search.report.iterations;
    const double after = found ? fracture_->judge() : 0;
    search.report.utilisation = after;
    if (found && (after <= 1 + overshoot || search.jumped || until <= soonest)) {
      const Ledger ledger = ledger_;
      book_load(booking, first);
      bridges.book(model_, ledger_);
      const double off = closure.work(model_, ledger_.friction_work - ledger.friction_work);
      const bool bent = std::abs(off) > std::max(most_bend * exchanged(ledger, ledger_), least_bend * ledger_.scale());
      if (!search.jumped && bent && until - from > finest_increment * whole && until > soonest) {
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
