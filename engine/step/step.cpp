// One step of the simulation, top to bottom. docs/architecture.md walks through it.
//
// X is where blocks lie, and y = X + ahead·v, ahead = (θ-½)Δt, where forces act, contacts are judged and energies are
// weighed (theory, § 2 and 9). An attempt at a step leads the blocks from model_.blocks to moved_; accept() exchanges
// the two. What it is refused for: Course. Those of the same length taken again: `past`, with contacts that it met
// (seek()); shorter ones: cut (no solution), halve (a solution that is not good enough); a longer or shorter one:
// regret (it is good, but the change of length cost energy).
#include "step/step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "equations/boundary_terms.h"
#include "model/rates.h"
#include "step/attempt.h"
#include "step/damping.h"
#include "step/energies.h"
#include "step/motion_past.h"
#include "step/overlooked.h"
#include "step/part_timer.h"
#include "step/restitution.h"
#include "step/step_change.h"
#include "step/turning.h"
#include "step/update.h"

namespace talus {

namespace {

constexpr double most_gain = 1e-6;          // in a step, of what moves and is stored
constexpr double most_gain_of_work = 1e-3;  // and of the work that loads and supports put in or take in it
// in a step, of the ledger's scale: what all steps leave unexplained is to be below a hundredth
constexpr double most_turning = 1e-3;
// in an automatic step, of what moves and is stored: what turns loses more than it gains by it
constexpr double most_turning_near_rest = 3e-3;
// rad, half the square of which is as nothing beside what contacts of rock are pressed in by, 1e-9 of the lever and
// more
constexpr double no_turn = 1e-6;
// of √area: what blocks that had no contact may come to lie in each other before the step is looked at once more with
// those on its way; what bends lies so deep in what it has none with, and no shorter step would mend that
constexpr double unasked_tolerance = 1e-3;
constexpr double most_solve_effort = 24;  // factors, among cracks: three times what keeps a step from growing

void stand(const BlockState& where, BlockState& state) {
  state = where;
  std::ranges::fill(state.velocity, 0);
}

}  // namespace

Stepper::Stepper(StepParts& parts)
    : parts_(parts),
      model_(parts.model),
      plan_(parts.plan),
      totals_(parts.totals),
      ledger_(parts.ledger),
      prestressed_(initial_stress_energy(model_)),
      step_size_(model_, plan_.contacts) {
  if (plan_.fracture) step_size_.among_cracks();
}

Scheme Stepper::scheme(double dt) const {
  const Numerics& numerics = model_.scene.numerics;
  return numerics.integrator == Integrator::theta ? Scheme::theta(dt, numerics.theta) : Scheme::newmark(dt);
}

double Stepper::next_dt() const {
  const double dt = step_size_.next(model_.time);
  if (!parts_.gas) return dt;
  const double until = parts_.gas->next_detonation() - model_.time;
  return until > step_size_.least() ? std::min(dt, until) : dt;
}

StepReport Stepper::dynamic_step(double most) {
  StepReport report;
  if (parts_.fracture) parts_.fracture->clear_events();
  if (parts_.gas) parts_.gas->detonate(step_size_.least());
  shorten();
  bool regretted = false;
  const StepSize before = step_size_;
  pressed_ = ContactTerms::least_pressed;
  const auto count_cut = [&] { ++report.cuts, ++totals_.cuts; };
  for (;;) {
    const double dt = std::min(next_dt(), most);
    const Scheme scheme = this->scheme(dt);
    if (model_.scene.numerics.sleeping) parts_.sleep.wake(model_, scheme);
    Attempt attempt(model_, plan_, ledger_, parts_.search, contacts_before_, parts_.fracture.get());
    // 1. The state and the loads that belong to this step's length and times.
    const Start start = begin(scheme, attempt, regretted);

    // 2 to 5. Contacts, their law, the bonds that fail: where the step leads.
    Course course = seek(scheme, attempt, report);
    if (course.woke) continue;

    // 6. Not settled, moved too far, or past contacts: everything as it was; again with a smaller step.
    const bool unsettled = !course.result.converged || step_size_.too_far(course.far) || course.crushed >= 0;
    if ((unsettled || course.past) && step_size_.is_least(dt)) {
      step_size_ = before;
      gave_up_ = true;
      give_up(course, dt);
    }
    if (unsettled) {
      step_size_.cut(dt, course.result.converged ? course.far : 0);
      if (!course.result.converged) pressed_ = std::min(100 * pressed_, 1.0);
      count_cut();
      continue;
    }
    if (plan_.contacts && !course.past && step_size_.may_halve(dt)) course.turning_gain = turning_gain(scheme, course);
    if (course.past || course.turning_gain > 1) {
      step_size_.halve(dt);
      count_cut();
      continue;
    }

    // 7. The step is accepted: geometry, velocities, contact and joint states, then what takes energy from where they
    // lead.
    const std::vector<double> kept = plan_.damping ? kept_velocities(model_, moved_, dt) : std::vector<double>{};
    std::optional<Restitution> restitution;
    if (plan_.restitution) restitution.emplace(model_, parts_.contacts);
    const double gained = accept(scheme, course.d, contacts_at_start(), start.energies);
    // What presses and moves may lie in y, as the step changes, where nothing paid for it: then once more with the last
    // step's length.
    const bool gains = start.energies && gained > most_gain * stored(*start.energies);
    if (regretted) {
      step_size_.regretted(!gains);
    } else if (gains && start.changed && regret(dt, dt * attempt.ahead_before() / scheme.bond_ahead, most)) {
      regretted = true;
      count_cut();
      continue;
    }
    attempt.keep();
    half_done_ = true;  // laws of the script are asked below that may fail
    count(course.result);
    judged_astray_ = false;
    if (parts_.fracture) keep_failures(course, report);
    // Before contacts are put in another order for what falls asleep.
    if (restitution) {
      const Restitution::Taken taken = restitution->limit(model_, parts_.contacts, scheme);
      ledger_.damping_work += taken.energy;
      ledger_.boundary_work += taken.boundary_work;
    }
    if (model_.scene.numerics.sleeping && report.failures == 0 && !parts_.bonds_due())
      parts_.sleep.fall_asleep(model_, parts_.islands, parts_.search.near());
    ledger_.damping_work += damp(model_, kept);
    const double end = model_.scene.time.t_end;
    model_.time = model_.time + dt > end * (1 - 1e-14) ? end : model_.time + dt;
    if (parts_.gas) parts_.gas->end_step(dt);
    for (Fixity& fixity : model_.scene.fixities) fixity.go_on(model_.time);
    if (dt < most) step_size_.accepted(dt, {course.far, course.turn, course.turning_gain}, effort_, split_anew_);
    half_done_ = false;
    report.dt = dt;
    return report;
  }
}

// What automatic steps are to end at.
void Stepper::shorten() {
  if (parts_.gas) step_size_.at_most(parts_.gas->longest_step());
  step_size_.stop_in(next_bend(model_.scene, model_.time + step_size_.least()) - model_.time);
}

// Whether a step is to be taken again, as one of `last`. Not where outputs, rows of tables or the end would make it the
// same again.
bool Stepper::regret(double dt, double last, double most) {
  if (!step_size_.may_regret()) return false;
  const StepSize before = step_size_;
  step_size_.regret(dt, last);
  shorten();
  if (std::min(next_dt(), most) != dt) return true;
  step_size_ = before;
  return false;
}

Stepper::Start Stepper::begin(const Scheme& scheme, Attempt& attempt, bool regretted) {
  effort_ = split_anew_ = 0;
  released_ = {};
  if (judged_astray_) judge_again();
  std::vector<int> due;  // left by a step that was too short for it
  if (parts_.fracture) due = parts_.fracture->choose(true);
  // Another step than the last: y stays, as far as bodies deform or lie on something.
  Start start;
  const bool other = scheme.bond_ahead != ledger_.ahead, first = ledger_.ahead == 0;
  const auto moves = [this](int b) { return !stands_still(model_, b); };
  if (other ? plan_.contacts || plan_.gravity
            : regretted || (ledger_.unpaid > 0 && std::ranges::any_of(model_.awake_blocks(), moves)))
    start = {parts_.energies(), other && !first && plan_.contacts && (!parts_.fracture || step_size_.quiet())};
  if (other) {
    attempt.keep_places();
    change_step(scheme.bond_ahead);
  }
  if (plan_.held_blocks) move_held_blocks(model_, scheme.dt);
  if (parts_.gas) parts_.gas->begin_step(scheme.dt);
  if (parts_.fracture) fail(due, model_.time);
  return start;
}

Stepper::Course Stepper::seek(const Scheme& scheme, Attempt& attempt, StepReport& report) {
  Course course;
  std::vector<BlockState> seen;  // where the step led before it went past contacts
  report.utilisation = 0;
  nearness_.clear();
  for (;; attempt.restore_contacts()) {
    // 2. Candidate pairs of vertices and edges, with the state of those that go on.
    if (parts_.fracture) parts_.fracture->recall_tractions();
    if (plan_.contacts) {
      StepTimer timer(totals_, "contact search");
      parts_.search.update(model_, scheme.dt, seen, parts_.fracture && !parts_.fracture->events().empty());
    }
    if (parts_.fracture) {
      course.released = released_.energy - parts_.contacts_of_events();
      course.bridges.emplace(model_);
      bridge_motion_.begin(model_);
    }

    // 3. Open–close: everything linear once, then contacts until their law is met.
    parts_.joints.begin();
    again_ = 0;
    // again with more of the candidates where one presses that was not expected to, with other pressures of the gas,
    // and other branches of bridges
    do {
      if (course.result.missed) widen();
      assemble(scheme);
      if (on_assembled) on_assembled(scheme, parts_.system, parts_.contacts);
      course.result = solve(scheme, course.d);
    } while (course.result.missed || (course.result.converged && !settled(scheme, course.d)));
    if (again_ > most_again || bridge_motion_.gives_up() || (parts_.gas && parts_.gas->gives_up()))
      course.result.converged = false;
    report.iterations = course.result.iterations;
    report.residual = course.result.residual;
    if (!course.result.converged) return course;
    lead(scheme, course);
    report.displacement = course.far;
    if (plan_.contacts && step_size_.bounded_by(course.far) && flies_exactly(model_.scene, model_.time))
      course.far = motion_past(model_, parts_.search.near(), moved_);
    if (step_size_.heeds_turns()) course.turn = largest_turn_of_pressed(model_, moved_);
    course.far = std::max(course.far, step_size_.as_far_as(course.turn));
    if (step_size_.too_far(course.far) || course.crushed >= 0) return course;

    // 4. Bonds that the step would leave beyond their strength fail at its start: the same step again without them.
    if (parts_.fracture && breaks(scheme.dt, report)) continue;

    // 5. Contacts that it went past: once again with those on its way. What sleeps there wakes, and the step begins
    // again.
    course.woke = model_.scene.numerics.sleeping && parts_.sleep.struck(model_, moved_, scheme);
    if (course.woke) return course;
    if (plan_.contacts) course.past = overlooks(scheme.dt, report.displacement, course.d, seen.empty());
    if (!course.past || !seen.empty()) return course;
    seen = moved_;
    effort_ = split_anew_ = 0;  // what a longer step would make dearer is in the second look alone
  }
}

void Stepper::visit_state(StateVisitor& visitor) {
  visitor("step_size", step_size_);
  visitor("judged_astray", judged_astray_);
  parts_.visit_state(visitor);
}

void Stepper::restored() {
  parts_.restored();
  rewound();
}

void Stepper::rewound() {
  half_done_ = false;
  moved_of_ = -1;
  parts_.rewound();
  if (plan_.fracture) step_size_.restored(model_);
}

void Stepper::assemble(const Scheme& scheme) {
  parts_.assemble(scheme, {.pressed = pressed_, .nearness = nearness_});
  if (!parts_.fracture) return;
  step_size_.short_enough(parts_.transit());
  bridge_motion_.add(model_, parts_.poses, scheme, parts_.system);
}

IslandResult Stepper::solve(const Scheme& scheme, Vector& d) {
  const bool few = parts_.fracture && scheme.dt > parts_.transit();
  const IslandResult result =
      parts_.solve(scheme.dt, few ? most_solve_effort : std::numeric_limits<double>::infinity(), d);
  effort_ += result.total_effort;
  split_anew_ = std::max(split_anew_, result.split_anew);
  return result;
}

// Whether there is nothing to solve again: the pressures of the gas are those of the volumes that d leads to, and
// bridges are on the branches of their laws that it leads to; or either has been given up.
bool Stepper::settled(const Scheme& scheme, const Vector& d) {
  if (parts_.gas && !parts_.gas->agrees(moved_blocks(model_, scheme, d))) return parts_.gas->gives_up();
  if (plan_.bonds && parts_.joints.may_disagree(model_, scheme, d) &&
      !parts_.joints.agrees(model_, parts_.poses, scheme, d, moved_blocks(model_, scheme, d)))
    return ++again_ > most_again;
  return !bridge_motion_.any() || bridge_motion_.gives_up() || bridge_motion_.agrees(d);
}

std::optional<std::pair<int, int>> Stepper::overlooks(double dt, double displacement, const Vector& d, bool first) {
  StepTimer timer(totals_, "contact search");
  return overlooked(model_, parts_.search, parts_.contacts, d, moved_, dt, displacement, passing_tolerance,
                    first ? unasked_tolerance : passing_tolerance);
}

// What the work of contacts is other than the step was solved with, as blocks turn in it, of what it may be: of the
// ledger's scale, and where steps may get long near rest, of what moves and is stored, for nothing else is left there
// to lose.
double Stepper::turning_gain(const Scheme& scheme, const Course& course) {
  StepTimer timer(totals_, "update");
  if (all_still()) return 0;
  const double straight = step_size_.straight(), least = step_size_.heeds_turns() ? no_turn : straight;
  const TurningWork work = work_of_turning(model_, parts_.contacts, scheme, course.d, moved_, least, straight);
  if (work.all == 0) return 0;
  double gain = 0;
  if (step_size_.heeds_turns()) {
    const double moves = kinetic_energy(model_, 0);
    if (work.all > StepSize::heeded_gain * most_turning_near_rest * moves)
      gain = work.all / (most_turning_near_rest * std::max({moves, kinetic_energy_moved(), stored(parts_.energies())}));
  }
  double energy = ledger_.scale();
  if (work.of_turns <= StepSize::heeded_gain * most_turning * energy) return gain;
  energy = std::max(energy, stored(parts_.energies()));
  double fall = 0;  // J/m, what gravity puts in: in the first step there is nothing before it
  for (const int b : model_.awake_blocks())
    if (model_.shapes[b].dofs > 0)
      fall += model_.mass(b) * model_.scene.gravity.dot(moved_[b].shift - model_.blocks[b].shift);
  return std::max(gain, work.of_turns / (most_turning * std::max(energy, std::abs(fall))));
}

double Stepper::kinetic_energy_moved() {
  model_.blocks.swap(moved_);
  const double energy = kinetic_energy(model_, 0);
  model_.blocks.swap(moved_);
  return energy;
}

// Finds moved_ and its vertices in one pass over what is awake: of many blocks the states are more than caches hold.
// What sleeps is in it as it is.
void Stepper::lead(const Scheme& scheme, Course& course) {
  if (moved_of_ != model_.sleep_changes) {
    moved_ = model_.blocks;
    moved_vertex_ = model_.vertex;
  }
  moved_of_ = model_.sleep_changes;
  course.far = 0;
  course.crushed = -1;
  for (const int b : model_.awake_blocks()) {
    if (parts_.islands.rest(b) != Rest::moves) {
      stand(model_.blocks[b], moved_[b]);
      const auto first = model_.vertex.begin() + model_.shapes[b].vertex_begin,
                 last = model_.vertex.begin() + model_.shapes[b].vertex_end;
      std::copy(first, last, moved_vertex_.begin() + model_.shapes[b].vertex_begin);
      continue;
    }
    move_block(model_, scheme, course.d, b, moved_[b]);
    model_.place_vertices(b, moved_[b], moved_vertex_);
    course.far = std::max(course.far, displacement(model_, b, moved_[b]));
    if (course.crushed < 0 && crushed(model_, b, moved_[b])) course.crushed = b;
  }
}

// The blocks of islands in which a contact presses that was not solved for get more of their contacts.
void Stepper::widen() {
  nearness_.resize(model_.shapes.size(), 1);
  for (const int b : parts_.islands.missed())
    if (model_.shapes[b].dofs > 0) nearness_[b] *= 8;
}

void Stepper::count(const IslandResult& result) {
  const IslandCounts& now = result.islands;
  const bool solved = now.single + now.by_sweeps + now.with_factor > 0;
  if (!solved) ++totals_.steps_at_rest;
  if (solved && now.with_factor == 0) ++totals_.steps_by_sweeps;
  IslandCounts& sum = totals_.islands;
  sum.at_rest += now.at_rest;
  sum.single += now.single;
  sum.by_sweeps += now.by_sweeps;
  sum.with_factor += now.with_factor;
  if (model_.scene.numerics.sleeping) sum.asleep += parts_.sleep.groups(model_);
}

// Whether nothing has moved in the step, and nothing did before it.
bool Stepper::all_still() const {
  if (!parts_.islands.all_rest()) return false;
  return std::ranges::all_of(model_.held_blocks, [this](int b) { return stands_still(model_, b); });
}

std::optional<ContactBooking> Stepper::contacts_at_start() {
  StepTimer timer(totals_, "update");
  if (all_still()) return {};
  return ContactBooking(model_);
}

double Stepper::accept(const Scheme& scheme, const Vector& d, const std::optional<ContactBooking>& booking,
                       std::optional<Energies> start) {
  StepTimer timer(totals_, "update");
  const double by_bridges = bridge_motion_.lead(model_);
  if (!booking) {
    ledger_.ahead = scheme.bond_ahead;
    return 0;
  }
  for (const int b : model_.awake_blocks())  // nothing of it is work
    if (parts_.islands.rest(b) != Rest::moves) std::ranges::fill(model_.blocks[b].velocity, 0);
  if (bridge_motion_.any()) ledger_.numerical_flow += bridge_motion_.shift_loss(model_, scheme, d);
  const Ledger before = ledger_;
  double lift =
      book_motion({model_, parts_.poses, parts_.system, parts_.joints, parts_.supports, scheme, d, moved_}, ledger_);
  Lift turning;
  if (plan_.contacts && scheme.bond_ahead > 0)
    turning = lift_of_turning(model_, parts_.contacts, scheme, d, moved_, no_turn);
  lift += turning.by_bend;
  const double lift_by_law = lift - turning.by_bend + turning.by_law;
  if (std::max(lift, lift_by_law) > 0 && !start) {  // for what this step loses to pay for it
    const Ledger booked = std::exchange(ledger_, before);
    start = parts_.energies();
    ledger_ = booked;
  }
  ledger_.unpaid += std::max(0.0, lift);
  if (plan_.fixities) parts_.supports.store(parts_.poses, scheme, d, model_);
  model_.blocks.swap(moved_);
  model_.vertex.swap(moved_vertex_);
  if (plan_.contacts) {
    parts_.islands.store(model_, parts_.contacts, d, true);
    booking->book(model_, parts_.contacts.rows(), scheme, d, ledger_);
    ledger_.numerical_flow += parts_.search.ended();
  }
  ledger_.ahead = scheme.bond_ahead;
  if (plan_.bonds && !parts_.fracture) parts_.joints.store_tractions(model_);  // else they are, to be judged
  if (!start) return 0;
  const Energies end = parts_.energies();
  const double gained = end.own() + by_bridges - start->own(), put_in = std::abs(end.external - start->external) +
                                                                        std::abs(end.boundary - start->boundary) +
                                                                        std::abs(end.gas - start->gas);
  const double paid = ledger_.pay(-gained);
  // What a smooth contact has lifted, by the turn of the step before too, is lent where it was not lost at once.
  ledger_.unpaid += std::max(0.0, std::min(gained - put_in, lift_by_law - std::max(0.0, lift)));
  return gained + paid - most_gain_of_work * put_in;
}

// What the way from X to y holds is the integrator's.
void Stepper::change_step(double ahead) {
  const double before = kinetic_energy(model_, 0) + parts_.elastic_energy(0),
               height = gravity_energy_ahead(model_, ledger_.ahead);
  std::vector<BlockState> kept = keep_stored(model_, ledger_.ahead, ahead);
  double gravity = 0;
  for (int b = 0; b < int(kept.size()); ++b)
    gravity += model_.mass(b) * model_.scene.gravity.dot(kept[size_t(b)].shift - model_.blocks[size_t(b)].shift);
  model_.blocks = std::move(kept);
  model_.place_vertices();
  ledger_.ahead = ahead;
  ledger_.gravity_work += gravity;
  ledger_.unpaid += gravity_energy_ahead(model_, ahead) - gravity - height;
  ledger_.numerical_flow += gravity + before - kinetic_energy(model_, 0) - parts_.elastic_energy(0);
}

}  // namespace talus
