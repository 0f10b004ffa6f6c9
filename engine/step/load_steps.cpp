#include "step/load_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "step/closure.h"
#include "step/energies.h"
#include "step/restored.h"
#include "step/trapezoid.h"

namespace talus {

namespace {

// Bounds of a load step, so that it ends whatever its contacts and bonds do. What stands is found in some hundreds of
// solves, also where bonds soften near their limit.
constexpr int most_search_solves = 1000;  // of one look for equilibrium
constexpr int most_vain_solves = 3000;    // of all those of a load step that found none
constexpr int careful_cuts = 4;           // as interpolated; those that follow halve an increment at least
// In a row, that neither come to the load asked for nor break a bond.
constexpr int most_short_increments = 60;

// The search has left all that there is: what bends far does where loads come at once.
bool flown_off(const Model& model) {
  return std::ranges::any_of(model.blocks,
                             [&](const BlockState& block) { return !(block.shift.norm() < 100 * model.extent); });
}

// J/m, by contacts.
double lost(const Ledger& ledger) {
  return ledger.friction_work + ledger.numerical_flow;
}

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
    : parts_(parts),
      model_(parts.model),
      plan_(parts.plan),
      totals_(parts.totals),
      ledger_(parts.ledger),
      equilibrium_(parts) {}

StepReport LoadSteps::step(double to, bool first) {
  const StepReport report = take(to, first);
  if (model_.load_way.part == 1) go_on();
  return report;
}

void LoadSteps::go_on() {
  for (Fixity& fixity : model_.scene.fixities) fixity.go_on(model_.time);
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

// Where no bond can fail. What slides to and fro in it is followed to where it turns round, in parts of its time, and
// of their way where loads jump.
StepReport LoadSteps::load(double to, bool first) {
  const bool moving = moves_supports(model_.scene);  // the script may have let one go since the plan was made
  const bool follow = plan_.contacts && (loads_change(model_.scene) || constants_before_.given());
  const double target = plan_.contacts && moving ? reachable(to) : to;
  std::optional<ConstantsWay> constants;
  if (constants_before_.given()) constants.emplace(model_, constants_before_, target);
  if (first && !plan_.initial_stress) {
    model_.time = target;
    model_.load_way = {LoadWay::nothing, 0};
  }
  StepReport report;
  for (;;) {
    LoadPath path(model_, target);
    for (; !load_part(path, constants ? &*constants : nullptr, follow, first, report); ++report.cuts) cut(path, 0.25);
    if (path.complete(target)) break;
    if (model_.load_way.part == 1) go_on();
    first = false;
  }
  constants_before_ = {};
  return report;
}

// Whether it is as straight as its booking takes it for; the model is as before where it is not. As loads grow from
// nothing that is what the ledger as a whole says: blocks turn and bend by the most then.
bool LoadSteps::load_part(LoadPath& path, const ConstantsWay* constants, bool follow, bool first, StepReport& report) {
  const bool grows = path.from() == LoadWay::nothing;
  std::optional<Restored> attempt;
  std::optional<Closure> closure;
  if (follow || grows) attempt.emplace(model_);
  if (plan_.contacts && (follow || first)) closure.emplace(model_, parts_.joints, std::vector<int>{});
  const double rest = grows ? parts_.energies().unexplained : 0;
  path.begin();
  const LoadStepBooking booking(model_, parts_.supports, path.begins_at(), first, constants_before_);
  path.end();
  if (constants) constants->go(model_, path.reached());
  const Ledger before = ledger_;
  EquilibriumSearch search;
  search.in_place = !moves_supports(model_.scene);
  if (!equilibrium_.balance(search)) {
    if (grows && path.length() > finest_increment && (path.length() < 1 || flown_off(model_))) return false;
    equilibrium_.give_up(search);
  }
  book(booking, first);
  if (attempt || closure) {
    const double given_off = closure ? closure->work(model_, lost(ledger_) - lost(before)) : 0,
                 after = parts_.energies().unexplained;
    const Trapezoid trapezoid = trapezoid_of(path, {grows ? rest - after - std::max(given_off, 0.0) : given_off, after},
                                             before, ledger_, model_.scene.time);
    if (attempt && trapezoid == Trapezoid::too_long) {
      ledger_ = before;
      return false;
    }
    if ((grows || trapezoid != Trapezoid::holds) && given_off > 0) ledger_.numerical_flow += given_off;
    if (attempt) attempt->keep();
  }
  if (constants) constants_before_ = constants_of(model_.scene);
  report.iterations += search.report.iterations;
  report.residual = std::max(report.residual, search.report.residual);
  report.displacement += search.report.displacement;  // at most
  return true;
}

void LoadSteps::cut(LoadPath& path, double part) {
  const bool jumped = path.jumps();
  path.cut(part);
  if (path.jumps() != jumped) pace_ = 0;
  ++totals_.cuts;
}

// The energy stored is linear in an initial stress, which grows in the first load step as the loads do: half of what it
// has put in.
void LoadSteps::book(const LoadStepBooking& booking, bool first) {
  if (first && plan_.initial_stress) {
    const double all = parts_.energies().strain;
    const Unstressed unstressed(model_);
    ledger_.external_work += (all - parts_.energies().strain) / 2;
  }
  booking.book(model_, parts_.supports, ledger_);
}

// How far a load step may go towards `to`: what is held or supported moves no farther in it than a step in motion may,
// or blocks that it pushes would be held back in its search and slide by steps of that. Where a table jumps there is no
// such time.
double LoadSteps::reachable(double to) const {
  const double from = model_.time, most = model_.scene.time.displacement_ratio * model_.extent;
  double until = to;
  for (int looks = 0; looks < 40; ++looks) {
    double far = 0;
    for (const Fixity& fixity : model_.scene.fixities)
      far = std::max(far, (fixity.moved(until) - fixity.moved(from)).norm());
    if (far <= most * (1 + 1e-9)) return until;
    until = from + (until - from) * std::max(0.5, most / far);
  }
  return to;
}

// How far it is to where the first bond comes to its strength if utilisations go on as they have come up, as
// LoadPath::length. Farther each time that it has not come to it.
double LoadSteps::foreseen(const LoadPath& path, double utilisation) const {
  const double pace = path.jumps() ? pace_ : utilisation / path.from();
  const double ahead = (1 + model_.scene.fracture.overshoot / 2 - utilisation) / pace;
  return pace > 0 && ahead > 0 ? ahead * std::pow(2.0, short_increments_) : path.length();
}

// 1/s, or over all of a jump of loads, at which utilisations come up at least; of a jump that has just begun nobody
// knows.
double LoadSteps::pace(const LoadPath& path, double utilisation) const {
  if (path.jumps()) return pace_ > 0 ? pace_ : std::numeric_limits<double>::infinity();
  return std::max(pace_, path.from() > 0 ? utilisation / path.from() : 0);
}

// Utilisations grow about in proportion to the load: an increment that passes a strength by more than the overshoot is
// taken again, to where the first bond reaches it. So is one on whose way the rock would jump, unless utilisations, as
// they have come up, would stay within the overshoot: then the load at which it jumps is known as well as any strength.
StepReport LoadSteps::raise_load(double to, bool first) {
  const double strength = 1 + model_.scene.fracture.overshoot, before = parts_.fracture->judge();
  LoadPath path(model_, to, first && !plan_.initial_stress);
  path.stop_at(std::max(foreseen(path, before), path.least()));
  const Closure closure(model_, parts_.joints, {});
  const double rest = parts_.energies().unexplained;
  int vain = 0;  // solves
  for (int cuts = 0;; ++cuts) {
    Restored attempt(model_);
    path.begin();
    const IncrementBooking booking{{model_, parts_.supports, path.begins_at(), first, constants_before_},
                                   BridgeBooking(model_),
                                   closure,
                                   rest,
                                   first};
    path.end();
    EquilibriumSearch search;
    search.most_solves = most_search_solves;
    search.may_jump =
        (before + pace(path, before) * path.length() <= strength && !path.meets_jump()) || path.is_shortest();
    const bool found = equilibrium_.balance(search);
    search.report.cuts = cuts;
    if (!found) vain += search.report.iterations;
    const double after = search.report.utilisation = found ? parts_.fracture->judge() : 0;
    const bool stands = found && (after <= strength || search.jumped || path.is_shortest());
    if (stands && book(booking, path, search.jumped, after - before)) {
      attempt.keep();
      constants_before_ = {};
      parts_.fracture->weaken();
      short_increments_ = path.complete(to) || parts_.bonds_due() ? 0 : short_increments_ + 1;
      return search.report;
    }
    const bool enough = vain > most_vain_solves || short_increments_ > most_short_increments;
    if (!found && (path.is_shortest() || enough)) {
      if (totals_.failures == 0) equilibrium_.give_up(search);
      const StepReport report = collapse(search);
      attempt.back();
      return report;
    }
    const double part = stands || !found ? 0.25 : (1 + model_.scene.fracture.overshoot / 2 - before) / (after - before);
    cut(path, std::clamp(part, 0.01, cuts < careful_cuts ? 0.95 : 0.5));
  }
}

// `raised`: by how much utilisations have come up. False, and nothing is booked: contacts bend the increment too much
// for its trapezoids.
bool LoadSteps::book(const IncrementBooking& booking, LoadPath& path, bool jumped, double raised) {
  const Ledger ledger = ledger_;
  book(booking.loads, booking.first);
  booking.bridges.book(model_, ledger_);
  const double after = parts_.energies().unexplained,
               given_off = booking.closure.work(model_, lost(ledger_) - lost(ledger));
  const Trapezoid trapezoid =
      trapezoid_of(path, {path.from_nothing() && !jumped ? booking.rest - after : given_off, after}, ledger, ledger_,
                   model_.scene.time);
  if (!jumped && trapezoid == Trapezoid::too_long) {
    ledger_ = ledger;
    return false;
  }
  if (jumped || (trapezoid != Trapezoid::holds && given_off > 0))
    ledger_.fracture_work += given_off;
  else if (path.length() > 0)
    pace_ = raised / path.length();
  if (path.ends_jump()) pace_ = 0;
  return true;
}

StepReport LoadSteps::break_bonds(const std::vector<int>& due) {
  const double most = parts_.fracture->judge();
  const LoadStepBooking booking(model_, parts_.supports, model_.time, false, constants_before_);
  const double by_bonds = parts_.fail(due, model_.time, false).energy, stored = contact_energy(model_.contacts);
  const Closure closure(model_, parts_.joints, due);
  parts_.search.update(model_, 0);
  const BridgeBooking bridges(model_);
  Restored at_failure(model_);
  EquilibriumSearch search;
  search.most_solves = most_search_solves;
  StepReport report;
  if (equilibrium_.balance(search)) {
    at_failure.keep();
    report = search.report;
    const double before = lost(ledger_);
    booking.book(model_, parts_.supports, ledger_);
    constants_before_ = {};
    ledger_.fracture_work += by_bonds + closure.work(model_, lost(ledger_) - before);
    bridges.book(model_, ledger_);
    parts_.fracture->weaken();
    parts_.fracture->judge();
  } else {
    report = collapse(search);
    at_failure.back();
    ledger_.fracture_work += by_bonds + stored - contact_energy(model_.contacts);
  }
  report.utilisation = most;
  report.failures = int(due.size());
  return report;
}

StepReport LoadSteps::collapse(const EquilibriumSearch& search) {
  collapse_ = block_name(model_, equilibrium_.culprit(search)) + " keeps moving";
  const std::string alternating = search.alternation.text(model_);
  if (!alternating.empty()) collapse_ += "; " + alternating;
  StepReport report;
  report.collapsed = true;
  return report;
}

void LoadSteps::before_change() {
  if (!constants_before_.given()) constants_before_ = constants_of(model_.scene);
}

void LoadSteps::visit_state(StateVisitor& visitor) {
  visitor.growing("materials_before", constants_before_.materials);
  visitor.growing("properties_before", constants_before_.properties);
  visitor("short_increments", short_increments_);
  visitor("pace", pace_);
}

std::string LoadSteps::collapse_note() const {
  return "no equilibrium beyond " + load_text(model_) + ": " + collapse_ +
         "; the run ends with the last equilibrium there was";
}

}  // namespace talus
