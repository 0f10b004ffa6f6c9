// One step of the simulation, top to bottom. docs/architecture.md walks through it.
#include "step/step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "equations/block_terms.h"
#include "equations/boundary_terms.h"
#include "equations/viscous_terms.h"
#include "model/rates.h"
#include "step/attempt.h"
#include "step/damping.h"
#include "step/overlooked.h"
#include "step/part_timer.h"
#include "step/restitution.h"
#include "step/restored.h"
#include "step/step_change.h"
#include "step/turning.h"
#include "step/update.h"

namespace talus {

namespace {

constexpr double most_gain = 1e-6;  // in a step, of what moves and is stored
constexpr double most_turning = 1e-3;  // in a step, of the ledger's scale: what all steps leave unexplained is to be below a hundredth
constexpr double most_solve_effort = 24;  // factors, among cracks: three times what keeps a step from growing

void stand(const BlockState& where, BlockState& state) {
  state = where;
  state.velocity.fill(0);
}

}  // namespace

Stepper::Stepper(Model& model, const Plan& plan, RunTotals& totals, Ledger& ledger)
    : model_(model), plan_(plan), totals_(totals), ledger_(ledger), step_size_(model, plan.contacts) {
  for (const BlockShape& shape : model.shapes) block_sizes_.push_back(shape.dofs);
  if (plan.fracture) {
    fracture_ = std::make_unique<Fracture>(model);
    step_size_.among_cracks();
  }
  if (plan.gas) gas_ = std::make_unique<Gas>(model);
}

Scheme Stepper::scheme(double dt) const {
  const Numerics& numerics = model_.scene.numerics;
  return numerics.integrator == Integrator::theta ? Scheme::theta(dt, numerics.theta) : Scheme::newmark(dt);
}

double Stepper::next_dt() const {
  const double dt = step_size_.next(model_.time);
  if (!gas_) return dt;
  const double until = gas_->next_detonation() - model_.time;
  return until > step_size_.least() ? std::min(dt, until) : dt;
}

StepReport Stepper::dynamic_step(double most) {
  StepReport report;
  if (fracture_) fracture_->clear_events();
  if (gas_) gas_->detonate(step_size_.least());
  shorten();
  bool regretted = false;
  const StepSize before = step_size_;
  pressed_ = ContactTerms::least_pressed;
  const auto count_cut = [&] { ++report.cuts, ++totals_.cuts; };
  for (;;) {
    const double dt = std::min(next_dt(), most);
    const Scheme scheme = this->scheme(dt);
    if (model_.scene.numerics.sleeping && sleep_.wake(model_, scheme)) weighed_late_ = true;
    Attempt attempt(model_, plan_, ledger_, search_, contacts_before_, fracture_.get());
    // 1. The state and the loads that belong to this step's length and times.
    const std::optional<Energies> start = begin(scheme, attempt);

    // 2 to 5. Contacts, their law, the bonds that fail: where the step leads.
    Course course = seek(scheme, attempt, report);
    if (course.woke) continue;

    // 6. Not settled, moved too far, or past contacts: everything as it was; again with a smaller step.
    if (!course.result.converged || step_size_.too_far(course.far) || course.crushed >= 0) {
      if (step_size_.is_least(dt)) {
        step_size_ = before;
        gave_up_ = true;
        give_up(course.result, dt, course.crushed);
      }
      step_size_.cut(dt, course.result.converged ? course.far : 0);
      if (!course.result.converged) pressed_ = std::min(100 * pressed_, 1.0);
      count_cut();
      continue;
    }
    if (course.past || (plan_.contacts && step_size_.may_halve(dt) && turns_gain(scheme, course))) {
      step_size_.halve(dt);
      count_cut();
      continue;
    }

    // 7. The step is accepted: geometry, velocities, contact and joint states, then what takes energy from where they lead.
    const std::vector<double> kept = plan_.damping ? kept_velocities(model_, moved_, dt) : std::vector<double>{};
    std::optional<Restitution> restitution;
    if (plan_.restitution) restitution.emplace(model_, contacts_);
    const double gained = accept(moved_, scheme, course.d, contacts_at_start(), start);
    // What presses and moves may lie in y, as the step changes, where nothing paid for it: then once more with the last step's length.
    if (start && !regretted && gained > most_gain * start->stored() && regret(dt, dt * attempt.ahead_before() / scheme.bond_ahead, most)) {
      regretted = weighed_late_ = true;
      count_cut();
      continue;
    }
    if (start && gained > 0 && plan_.gravity) {
      weigh_nearer(model_, gained);
      weighed_late_ = true;
    }
    attempt.keep();
    half_done_ = true;  // laws of the script are asked below that may fail
    count(course.result);
    judged_astray_ = false;
    if (fracture_) keep_failures(course, report);
    // Before contacts are put in another order for what falls asleep.
    if (restitution) {
      const Restitution::Taken taken = restitution->limit(model_, contacts_, scheme);
      ledger_.damping_work += taken.energy;
      ledger_.boundary_work += taken.boundary_work;
    }
    if (model_.scene.numerics.sleeping && report.failures == 0 && !bonds_due()) sleep_.fall_asleep(model_, islands_, search_.near());
    ledger_.damping_work += damp(model_, kept);
    const double end = model_.scene.time.t_end;
    model_.time = model_.time + dt > end * (1 - 1e-14) ? end : model_.time + dt;
    if (gas_) gas_->end_step(dt);
    if (dt < most) step_size_.accepted(dt, course.far, effort_, split_anew_);
    half_done_ = false;
    report.dt = dt;
    return report;
  }
}

// What automatic steps are to end at.
void Stepper::shorten() {
  if (gas_) step_size_.at_most(gas_->longest_step());
  step_size_.stop_in(next_bend(model_.scene, model_.time + step_size_.least()) - model_.time);
}

// Whether a step is to be taken again, as one of `last`. Not where outputs, rows of tables or the end would make it the same again.
bool Stepper::regret(double dt, double last, double most) {
  if (!step_size_.may_regret()) return false;
  const StepSize before = step_size_;
  step_size_.regret(dt, last);
  shorten();
  if (std::min(next_dt(), most) != dt) return true;
  step_size_ = before;
  return false;
}

// Returns the energies before, where the step is another than the last and may add to them.
std::optional<Energies> Stepper::begin(const Scheme& scheme, Attempt& attempt) {
  effort_ = split_anew_ = released_ = released_on_way_ = 0;
  if (judged_astray_) judge_again();
  std::vector<int> due;  // left by a step that was too short for it
  if (fracture_) due = fracture_->choose(true);
  // Another step than the last: y stays, as far as bodies deform or lie on something.
  std::optional<Energies> start;
  if (scheme.bond_ahead != ledger_.ahead) {
    weighed_late_ = true;
    if (plan_.contacts && !fracture_ && ledger_.ahead > 0) start = energies();
    attempt.keep_places();
    change_step(scheme.bond_ahead);
  }
  if (plan_.held_blocks) move_held_blocks(model_, scheme.dt);
  if (gas_) gas_->begin_step(scheme.dt);
  if (fracture_) fail(due, model_.time, true);
  return start;
}

Stepper::Course Stepper::seek(const Scheme& scheme, Attempt& attempt, StepReport& report) {
  Course course;
  std::vector<BlockState> seen;  // where the step led before it went past contacts
  report.utilisation = 0;
  nearness_.clear();
  for (;; attempt.again()) {
    // 2. Candidate pairs of vertices and edges, with the state of those that go on.
    if (fracture_) fracture_->recall_tractions();
    if (plan_.contacts) {
      StepTimer timer(totals_, "contact search");
      search_.update(model_, scheme.dt, seen, fracture_ && !fracture_->events().empty());
    }
    if (fracture_) {
      course.released = released_ - contacts_of_events();
      course.bridges.emplace(model_);
      bridge_motion_.begin(model_);
    }

    // 3. Open–close: everything linear once, then contacts until their law is met.
    hold_.clear();
    joints_.begin();
    again_ = 0;
    do {  // again with more of the candidates where one presses that was not expected to, with other pressures of the gas, and other branches of bridges
      if (course.result.missed) widen();
      assemble(scheme, false);
      if (on_assembled) on_assembled(scheme, system_, contacts_);
      course.result = solve(scheme.dt, course.d);
    } while (course.result.missed || (course.result.converged && !settled(scheme, course.d)));
    if (again_ > most_again || bridge_motion_.gives_up() || (gas_ && gas_->gives_up())) course.result.converged = false;
    report.iterations = course.result.iterations;
    report.residual = course.result.residual;
    if (!course.result.converged) return course;
    lead(scheme, course);
    report.displacement = course.far;
    if (step_size_.heeds_turns()) course.far = std::max(course.far, step_size_.as_far_as(largest_turn_of_pressed(model_, moved_)));
    if (step_size_.too_far(course.far) || course.crushed >= 0) return course;

    // 4. Bonds that the step would leave beyond their strength fail at its start: the same step again without them.
    if (fracture_ && breaks(scheme.dt, report)) continue;

    // 5. Contacts that it went past: once again with those on its way. What sleeps there wakes, and the step begins again.
    course.woke = model_.scene.numerics.sleeping && sleep_.struck(model_, moved_, scheme);
    if (course.woke) return course;
    course.past = plan_.contacts && step_size_.may_halve(scheme.dt) && overlooks(scheme.dt, report.displacement, course.d);
    if (!course.past || !seen.empty()) return course;
    seen = moved_;
  }
}

void Stepper::visit_state(StateVisitor& visitor) {
  visitor("step_size", step_size_);
  visitor("contact_search", search_);
  visitor("sleep", sleep_);
  visitor("islands", islands_);
  visitor("short_increments", short_increments_);
  visitor("pace", pace_);
  visitor("weighed_late", weighed_late_);
  visitor("judged_astray", judged_astray_);
  if (gas_) visitor("gas", *gas_);
}

void Stepper::restored() {
  revision_ = -1;
  if (!model_.scene.numerics.sleeping || !plan_.dynamic) model_.changed();  // the state may be of a run that let things sleep
  const bool late = weighed_late_;
  rewound();
  weighed_late_ = late;
}

void Stepper::rewound() {
  weighed_late_ = true;
  half_done_ = false;
  moved_of_ = -1;
  search_.forget(model_);
  sleep_.restored();
  if (fracture_) {
    fracture_->restored();
    step_size_.broken(model_);
  }
  if (gas_) gas_->restored();
}

// Whether there is nothing to solve again: the pressures of the gas are those of the volumes that d leads to, and bridges are on the branches
// of their laws that it leads to; or either has been given up.
bool Stepper::settled(const Scheme& scheme, const Vector& d) {
  if (gas_ && !gas_->agrees(moved_blocks(model_, scheme, d))) return gas_->gives_up();
  if (plan_.bonds && joints_.may_disagree(model_, scheme, d) && !joints_.agrees(model_, poses_, scheme, d, moved_blocks(model_, scheme, d)))
    return ++again_ > most_again;
  return !bridge_motion_.any() || bridge_motion_.gives_up() || bridge_motion_.agrees(d);
}

void Stepper::prepare_bonds() {
  if (revision_ == model_.revision) return;
  revision_ = model_.revision;
  if (plan_.bonds || plan_.fixities) joints_.prepare(model_);
  if (plan_.fixities) supports_.prepare(model_, joints_.ground_stiffness());
  if (!fracture_) return;
  transit_ = fracture_->least_transit();
  step_size_.short_enough(transit_);
}

void Stepper::assemble(const Scheme& scheme, bool stick) {
  StepTimer timer(totals_, "assembly");
  prepare_bonds();
  std::vector<std::pair<int, int>> pairs;
  for (const Joint& joint : model_.joints)
    if (ties(joint) && !model_.sleeps(joint.a) && !model_.sleeps(joint.b)) pairs.push_back({joint.a, joint.b});
  poses_.predict(model_, scheme);
  if (plan_.contacts) contacts_.linearise(model_, poses_, scheme, stick, nearness_, pressed_);
  for (const ContactRows& row : contacts_.rows())
    if (row.near) pairs.push_back({row.i, row.j});
  std::vector<int> with_entries;
  std::ranges::copy(model_.awake_blocks(), std::back_inserter(with_entries));
  if (system_.matrix.set_pattern(block_sizes_, std::move(pairs), std::move(with_entries)) && plan_.bonds) joints_.find_slots(model_, system_.matrix);
  system_.clear(model_);
  add_block_terms(model_, poses_, scheme, system_);
  if (!hold_.empty()) add_hold(model_, hold_, hold_lead_, system_);
  if (plan_.bonds) joints_.add(model_, poses_, scheme, system_);
  if (fracture_) {
    if (scheme.dt > 0) {
      bridge_motion_.add(model_, poses_, scheme, system_);
    } else {
      bridges_.find_slots(model_, system_.matrix);
      bridges_.add(model_, poses_, scheme, system_);
    }
  }
  if (plan_.fixities) supports_.add(model_, poses_, scheme, system_);
  if (plan_.viscous) add_viscous_edges(model_, poses_, scheme, system_);
  add_loads(model_, poses_, scheme, system_);
  for (const auto& term : terms) term->add(model_, poses_, scheme, system_);
  islands_.find(model_, contacts_, !model_.scene.numerics.islands);
}

IslandResult Stepper::solve(double dt, Vector& d) {
  StepTimer timer(totals_, "open-close and solve");
  const Numerics& numerics = model_.scene.numerics;
  const bool motion = dt > 0;
  if (!motion && on_equilibrium_solve) on_equilibrium_solve();
  // Equilibrium is judged once more afterwards, by scales of its own.
  const double tolerance = motion ? numerics.contact_tolerance : std::min(numerics.contact_tolerance, 0.1 * numerics.static_tolerance);
  const OpenCloseSettings settings{tolerance, numerics.max_iterations, motion, numerics.solver,
                                   fracture_ && dt > transit_ ? most_solve_effort
                                                                                : std::numeric_limits<double>::infinity()};
  const IslandResult result = islands_.solve(model_, system_, contacts_, settings, dt, d);
  totals_.iterations += result.solves;
  totals_.sweeps += result.sweeps;
  totals_.splittings += result.splittings;
  totals_.pivots += result.pivots;
  effort_ += result.total_effort;
  split_anew_ = std::max(split_anew_, result.split_anew);
  totals_.factorisations += result.factorisations;
  totals_.largest_iterations = std::max(totals_.largest_iterations, result.iterations);
  return result;
}

bool Stepper::overlooks(double dt, double displacement, const Vector& d) {
  StepTimer timer(totals_, "contact search");
  return overlooked(model_, search_, contacts_, d, moved_, dt, displacement);
}

// Whether blocks turn in the step by so much that the work of their contacts is not what it was solved with.
bool Stepper::turns_gain(const Scheme& scheme, const Course& course) {
  StepTimer timer(totals_, "update");
  const double work = work_of_turning(model_, contacts_, scheme, course.d, moved_);
  return work > most_turning * ledger_.scale() && work > most_turning * energies().stored();
}

// Finds moved_ in one pass over what is awake: of many blocks the states are more than caches hold. What sleeps is in it as it is.
void Stepper::lead(const Scheme& scheme, Course& course) {
  if (moved_of_ != model_.sleep_changes) moved_ = model_.blocks;
  moved_of_ = model_.sleep_changes;
  course.far = 0;
  course.crushed = -1;
  for (const int b : model_.awake_blocks()) {
    if (islands_.rest(b) != Rest::moves) {
      stand(model_.blocks[b], moved_[b]);
      continue;
    }
    move_block(model_, scheme, course.d, b, moved_[b]);
    course.far = std::max(course.far, displacement(model_, b, moved_[b]));
    if (course.crushed < 0 && crushed(model_, b, moved_[b])) course.crushed = b;
  }
}

// The blocks of islands in which a contact presses that was not solved for get more of their contacts.
void Stepper::widen() {
  nearness_.resize(model_.shapes.size(), 1);
  for (const int b : islands_.missed())
    if (model_.shapes[b].dofs > 0) nearness_[b] *= 8;
}

// What rests stays where it is, and stands still.
void Stepper::keep_rest(std::vector<BlockState>& moved) {
  for (const int b : model_.awake_blocks())
    if (islands_.rest(b) != Rest::moves) stand(model_.blocks[b], moved[b]);
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
  if (model_.scene.numerics.sleeping) sum.asleep += sleep_.groups(model_);
}

// Whether nothing has moved in the step, and nothing did before it.
bool Stepper::all_still() const {
  if (!islands_.all_rest()) return false;
  return std::ranges::all_of(model_.held_blocks, [this](int b) { return stands_still(model_, b); });
}

std::optional<ContactBooking> Stepper::contacts_at_start() {
  StepTimer timer(totals_, "update");
  if (all_still()) return {};
  return ContactBooking(model_);
}

double Stepper::accept(std::vector<BlockState>& moved, const Scheme& scheme, const Vector& d, const std::optional<ContactBooking>& booking,
                       const std::optional<Energies>& start) {
  StepTimer timer(totals_, "update");
  const bool motion = scheme.step_v > 0;
  if (motion && !booking) {
    ledger_.ahead = scheme.bond_ahead;
    return 0;
  }
  if (motion)  // nothing of it is work
    for (const int b : model_.awake_blocks())
      if (islands_.rest(b) != Rest::moves) model_.blocks[b].velocity.fill(0);
  if (motion && bridge_motion_.any()) ledger_.numerical_flow += bridge_motion_.shift_loss(model_, scheme, d);
  const double dissipated = ledger_.friction_work + ledger_.viscous_work;
  if (motion) book_motion({model_, poses_, system_, joints_, supports_, scheme, d, moved}, ledger_);
  if (motion && plan_.fixities && scheme.bond_ahead > 0) model_.support_gaps = supports_.gaps_after(model_, poses_, scheme, d);
  model_.blocks.swap(moved);
  for (const int b : model_.awake_blocks()) model_.place_vertices(b);
  if (plan_.contacts) {
    islands_.store(model_, contacts_, d, motion);
    if (motion) booking->book(model_, contacts_.rows(), scheme, d, ledger_);
  }
  ledger_.ahead = scheme.bond_ahead;
  double gained = start ? energies().own() - start->own() : 0;
  if (motion && plan_.gravity && weighed_late_) {
    gained += weigh(model_, scheme, start ? -gained : least_loss(model_, moved, scheme, ledger_.friction_work + ledger_.viscous_work - dissipated));
    weighed_late_ = weighed_late(model_, scheme);
  }
  if (plan_.bonds && (!motion || !fracture_)) joints_.store_tractions(model_);  // else they are, to be judged
  if (fracture_ && !motion) bridges_.store_tractions(model_);
  return gained;
}

std::vector<Vec2> Stepper::reactions() {
  prepare_bonds();
  return support_reactions(model_, supports_, model_.time, ledger_.ahead);
}

// What the way from X to y holds is the integrator's.
void Stepper::change_step(double ahead) {
  const double before = kinetic_energy(model_, 0) + elastic_energy(0);
  std::vector<BlockState> kept = keep_stored(model_, ledger_.ahead - ahead);
  double gravity = 0;
  for (int b = 0; b < int(kept.size()); ++b)
    gravity += model_.mass(b) * model_.scene.gravity.dot(kept[size_t(b)].shift - model_.blocks[size_t(b)].shift);
  model_.blocks = std::move(kept);
  model_.place_vertices();
  ledger_.ahead = ahead;
  ledger_.gravity_work += gravity;
  ledger_.numerical_flow += gravity + before - kinetic_energy(model_, 0) - elastic_energy(0);
}

}  // namespace talus
