// One step of the simulation, top to bottom. docs/architecture.md walks through it.
#include "step/step.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

#include "equations/block_terms.h"
#include "equations/boundary_terms.h"
#include "model/registry.h"
#include "model/saved_state.h"
#include "step/part_timer.h"
#include "step/update.h"

namespace talus {

namespace {

// Equilibrium with contacts is found by steps against a little inertia, which a loose block needs to stay
// put: this part of (wave speed / size)², far below the slowest mode of what is held.
constexpr double least_hold = 1e-4;
constexpr int patience = 6;       // steps that bring equilibrium no nearer
constexpr double most_hold = 1e6;  // where that does not help, nothing will
constexpr int equilibrium_iterations = 200;
constexpr int held_iterations = 15;  // open–close, before equilibrium is sought against more inertia, where states change less
constexpr double release_hold = 100;  // so that states change a few at a time
constexpr int release_iterations = 40;

// What an attempt at a step changes before it is known to succeed; put back unless keep() is called.
class Attempt {
 public:
  // `contacts`: where those of the model are kept meanwhile, the same memory for every attempt.
  Attempt(Model& model, const Plan& plan, Ledger& ledger, std::vector<Contact>& contacts, Fracture* fracture)
      : model_(model), ledger_(ledger), before_(ledger), contacts_(contacts), fracture_(fracture) {
    if (plan.contacts) contacts_ = model.contacts;
    if (!plan.held_blocks) return;
    for (size_t b = 0; b < model.shapes.size(); ++b)
      if (model.shapes[b].dofs == 0) held_.emplace_back(b, model.blocks[b].velocity);
  }
  ~Attempt() {
    if (kept_) return;
    model_.contacts.swap(contacts_);
    ledger_ = before_;
    if (fracture_) fracture_->heal();
    for (const auto& [block, velocity] : held_) model_.blocks[block].velocity = velocity;
  }
  Attempt(const Attempt&) = delete;
  Attempt& operator=(const Attempt&) = delete;
  void keep() { kept_ = true; }
  void again() { model_.contacts = contacts_; }  // the same step, with the bonds that have failed in it

 private:
  Model& model_;
  Ledger& ledger_;
  const Ledger before_;
  std::vector<Contact>& contacts_;
  Fracture* fracture_;
  std::vector<std::pair<size_t, std::array<double, max_dofs>>> held_;
  bool kept_ = false;
};

}  // namespace

Stepper::Stepper(Model& model, const Plan& plan, RunTotals& totals, Ledger& ledger)
    : model_(model), plan_(plan), totals_(totals), ledger_(ledger), step_size_(model, plan.contacts) {
  if (plan.fracture) fracture_ = std::make_unique<Fracture>(model);
}

Scheme Stepper::scheme(double dt) const {
  const Numerics& numerics = model_.scene.numerics;
  return numerics.integrator == Integrator::theta ? Scheme::theta(dt, numerics.theta) : Scheme::newmark(dt);
}

StepReport Stepper::dynamic_step() {
  const Numerics& numerics = model_.scene.numerics;
  StepReport report;
  if (fracture_) fracture_->clear_events();
  for (double dt = step_size_.next(model_.time);; dt = step_size_.next(model_.time), ++report.cuts) {
    Attempt attempt(model_, plan_, ledger_, contacts_before_, fracture_.get());
    // 1. Loads, fixities and prescribed motions belong to this step's times; see Scheme.
    const Scheme scheme = this->scheme(dt);
    if (plan_.held_blocks) move_held_blocks(model_, dt);

    Vector d;
    OpenCloseResult result;
    std::vector<BlockState> moved;
    double released = 0;  // J/m, by bonds that fail in this step
    std::optional<BridgeBooking> bridge_booking;
    for (;; attempt.again()) {
      // 2. Candidate pairs of vertices and edges, with the state of those that go on.
      if (plan_.contacts) {
        PartTimer timer(totals_, "contact search");
        search_.update(model_, dt);
      }
      if (fracture_) {
        released = released_energy();
        bridge_booking.emplace(model_);
      }

      // 3. Open–close: everything linear once, then contacts until their law is met.
      double nearness = 1;
      do {  // again with more of the candidates where one presses that was not expected to
        assemble(scheme, false, nearness);
        if (on_assembled) on_assembled(scheme, system_, contacts_);
        result = rests(dt) ? stay(d) : solve(true, d);
        nearness *= 8;
      } while (result.missed);
      report.iterations = result.iterations;
      report.residual = result.residual;
      if (!result.converged) break;
      moved = moved_blocks(model_, scheme, d);
      report.displacement = largest_displacement(model_, moved);

      // 4. Bonds that the step would leave beyond their strength fail at its start: the same step again without them.
      if (!fracture_ || step_size_.too_far(report.displacement) || !breaks(moved, model_.time + dt, report)) break;
    }

    // 5. Not settled, or moved too far: everything as it was; again with a smaller step.
    if (!result.converged || step_size_.too_far(report.displacement)) {
      step_size_.cut(dt, result.converged ? report.displacement : 0);
      if (step_size_.next(model_.time) < step_size_.least()) give_up(result, dt);
      ++totals_.cuts;
      continue;
    }

    // 6. The step is accepted: geometry, velocities, contact and joint states.
    accept(std::move(moved), scheme, d);
    attempt.keep();
    if (fracture_) {
      ledger_.fracture_work += released;
      bridge_booking->book(model_, ledger_);
      fracture_->weaken();
      report.failures = int(fracture_->events().size());
    }
    if (numerics.integrator == Integrator::newmark && numerics.dynamic_parameter < 1) {
      ledger_.damping_work += (1 - numerics.dynamic_parameter * numerics.dynamic_parameter) * kinetic_energy(model_, 0);
      for (BlockState& state : model_.blocks)
        for (double& v : state.velocity) v *= numerics.dynamic_parameter;
    }
    const double end = model_.scene.time.t_end;
    model_.time = model_.time + dt > end * (1 - 1e-14) ? end : model_.time + dt;
    step_size_.accepted(dt, report.displacement, result.iterations);
    report.dt = dt;
    return report;
  }
}

std::string Stepper::settle() {
  Equilibrium stuck, released;
  const auto settles = [&](bool stick, double hold, int iterations, Equilibrium& search) {
    StateWriter before;
    talus::visit_state(model_, before);
    if (find_equilibrium(stick, hold, iterations, search)) return true;
    StateReader back(before.bytes);
    talus::visit_state(model_, back);
    model_.place_vertices();
    return false;
  };
  if (!settles(true, 0, equilibrium_iterations, stuck)) {
    if (stuck.last.singular_block >= 0) give_up(stuck.last, 0);
    return "no settled start: even with joints that do not slide, " + block_name(model_, culprit(stuck)) +
           " topples or falls; the run starts at rest as given";
  }
  // Sticking contacts may carry more shear than friction allows. Where the scene stands with friction too, it
  // starts from there, or the first steps would shake it.
  if (plan_.contacts) settles(false, release_hold, release_iterations, released);
  for (Contact& contact : model_.contacts) contact.slip = 0;
  return {};
}

void Stepper::visit_state(StateVisitor& visitor) {
  visitor("step_size", step_size_);
  visitor("contact_search", search_);
  visitor("load_increment", load_increment_);
}

void Stepper::restored() {
  revision_ = -1;
  search_.forget();
  if (fracture_) fracture_->restored();
}

const std::vector<int>& Stepper::fractures() const {
  static const std::vector<int> none;
  return fracture_ ? fracture_->events() : none;
}

int Stepper::initial_cracks() {
  prepare_bonds();
  store_tractions();
  fracture_->judge();
  const std::vector<int> due = fracture_->choose(false);
  fracture_->fail(due, model_.time);
  return int(due.size());
}

void Stepper::store_tractions() {
  joints_.store_tractions(model_);
  if (fracture_) bridges_.store_tractions(model_);
}

// Whether bonds fail where the step leads; it is then to be taken again. `moved` is only lent to the model.
bool Stepper::breaks(std::vector<BlockState>& moved, double time, StepReport& report) {
  PartTimer timer(totals_, "fracture");
  model_.blocks.swap(moved);
  store_tractions();
  report.utilisation = std::max(report.utilisation, fracture_->judge());
  model_.blocks.swap(moved);
  const std::vector<int> due = fracture_->choose(true);
  if (due.empty()) return false;
  store_tractions();
  fracture_->fail(due, time);
  return true;
}

// What bonds that have failed in this step stored at its start, less what the contacts that take over begin with.
double Stepper::released_energy() const {
  double sum = 0;
  for (const int j : fracture_->events()) sum += joints_.energy_of(model_, j, ledger_.ahead);
  if (sum == 0) return 0;
  const auto& events = fracture_->events();
  for (const Contact& c : model_.contacts)
    if (c.joint >= 0 && std::find(events.begin(), events.end(), c.joint) != events.end())
      sum -= contact_energy(c);
  for (const int j : events) sum -= bridge_energy(model_.joints[j]);
  return sum;
}

bool Stepper::balance(Equilibrium& search) { return find_equilibrium(false, 0, equilibrium_iterations, search); }

bool Stepper::find_equilibrium(bool stick, double hold, int iterations, Equilibrium& search) {
  auto& [report, result, d] = search;
  const double least = plan_.contacts ? least_hold : 0;
  const double too_far = 2 * model_.scene.time.displacement_ratio * model_.extent;
  hold = std::max(hold, least);
  bool snaps = false;  // softens faster than the blocks unload
  double last = 1;     // residual of the step before
  double snap_hold = 0;
  double best = 1;
  int stalled = 0;
  for (BlockState& state : model_.blocks) state.velocity.fill(0);
  if (plan_.held_blocks) place_held_blocks(model_);
  for (int i = 0; i < iterations; ++i) {
    const Scheme scheme = Scheme::equilibrium(hold);
    if (plan_.contacts) {
      PartTimer timer(totals_, "contact search");
      search_.update(model_, 0);
    }
    assemble(scheme, stick, 1);
    result = open_close_.judge(model_, system_, contacts_);
    report.residual = result.residual;
    if (i > 0 && result.residual <= model_.scene.numerics.static_tolerance) return true;
    result = solve(false, d);
    report.iterations += result.iterations;
    if (result.singular_block >= 0 && bridges_.any() && hold < most_hold) {  // what softens does not stand by itself
      hold *= 30;
      snap_hold = std::max(snap_hold, hold);
      snaps = true;
      continue;
    }
    if (!result.converged && plan_.contacts && result.singular_block < 0) {
      hold *= stick ? 100 : 30;
      ++totals_.cuts;
      continue;
    }
    if (!result.converged) return false;
    std::vector<BlockState> moved = moved_blocks(model_, scheme, d);
    const double displacement = largest_displacement(model_, moved);
    if (plan_.contacts && displacement > too_far) {
      hold *= std::max(4.0, displacement / too_far);
      ++totals_.cuts;
      continue;
    }
    hold = snaps && report.residual > last ? std::max(hold, std::min(2 * hold, snap_hold)) : std::max(least, hold / 4);
    stalled = report.residual > 0.9 * best ? stalled + 1 : 0;
    best = std::min(best, report.residual);
    if (stalled > patience && bridges_.any()) {
      hold = snap_hold = std::min(30 * std::max(hold, snap_hold), most_hold);
      snaps = true;
      stalled = 0;
      best = 1;
    }
    last = report.residual;
    report.displacement = std::max(report.displacement, displacement);
    accept(std::move(moved), scheme, d);
    if (snaps)  // what has softened on the way does not come back, or it would go back and forth
      for (Joint& joint : model_.joints) wear_bridges(model_, joint);
  }
  return false;
}

void Stepper::prepare_bonds() {
  if (revision_ == model_.revision) return;
  revision_ = model_.revision;
  if (plan_.bonds || plan_.fixities) joints_.prepare(model_);
  if (plan_.fixities) supports_.prepare(model_, joints_.ground_stiffness());
}

void Stepper::assemble(const Scheme& scheme, bool stick, double nearness) {
  PartTimer timer(totals_, "assembly");
  prepare_bonds();
  std::vector<std::pair<int, int>> pairs;
  for (const Joint& joint : model_.joints)  // failed ones too: the pattern outlives a crack
    if (joint.bonded) pairs.push_back({joint.a, joint.b});
  poses_.predict(model_, scheme);
  if (plan_.contacts) contacts_.linearise(model_, poses_, scheme, stick, nearness);
  for (const ContactRows& row : contacts_.rows())
    if (row.near) pairs.push_back({model_.contacts[row.contact].i, model_.contacts[row.contact].j});
  std::vector<int> sizes;
  for (const BlockShape& shape : model_.shapes) sizes.push_back(shape.dofs);
  if (system_.matrix.set_pattern(sizes, std::move(pairs))) {
    if (plan_.bonds) joints_.find_slots(model_, system_.matrix);
    solver_.analyse(system_.matrix);
  }
  system_.clear(model_);
  add_block_terms(model_, poses_, scheme, system_);
  if (plan_.bonds) joints_.add(model_, poses_, scheme, system_);
  if (fracture_) {
    bridges_.find_slots(model_, system_.matrix);
    bridges_.add(model_, poses_, scheme, system_);
  }
  if (plan_.fixities) supports_.add(model_, poses_, scheme, system_);
  add_loads(model_, poses_, scheme, system_);
  if (plan_.contacts) contacts_.find_slots(system_.matrix, model_);
}

// Whether nothing moves by more in a step than places are rounded to, and all forces balance as they are. Nothing has to be
// solved then, and round-off is not chased from step to step.
bool Stepper::rests(double dt) {
  PartTimer timer(totals_, "open-close and solve");
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * model_.extent;
  for (size_t b = 0; b < model_.blocks.size(); ++b)
    for (const double rate : model_.blocks[b].velocity)
      if (std::abs(rate) * dt > rounding) return false;
  return open_close_.judge(model_, system_, contacts_).residual <= model_.scene.numerics.contact_tolerance;
}

OpenCloseResult Stepper::stay(Vector& d) {
  d.setZero(system_.force.size());
  for (BlockState& state : model_.blocks) state.velocity.fill(0);
  ++totals_.steps_at_rest;
  OpenCloseResult result;
  result.converged = true;
  return result;
}

OpenCloseResult Stepper::solve(bool motion, Vector& d) {
  PartTimer timer(totals_, "open-close and solve");
  const Numerics& numerics = model_.scene.numerics;
  const long before = solver_.factorisations;
  OpenCloseResult result = open_close_.solve(model_, system_, contacts_, solver_, numerics.contact_tolerance,
                                             motion ? numerics.max_iterations : std::min(numerics.max_iterations, held_iterations), motion, d);
  if (!d.allFinite()) result.converged = false;
  totals_.iterations += result.iterations;
  totals_.sweeps += result.sweeps;
  if (motion && result.converged && result.iterations == 0) ++totals_.steps_by_sweeps;
  totals_.factorisations += solver_.factorisations - before;
  totals_.largest_iterations = std::max(totals_.largest_iterations, result.iterations);
  return result;
}

void Stepper::accept(std::vector<BlockState> moved, const Scheme& scheme, const Vector& d) {
  PartTimer timer(totals_, "update");
  const bool motion = scheme.step_v > 0;
  const ContactBooking booking(model_, ledger_.ahead, scheme.dt);
  if (motion) book_motion({model_, poses_, system_, supports_, scheme, d, moved}, ledger_);
  model_.blocks = std::move(moved);
  model_.place_vertices();
  if (plan_.contacts) {
    open_close_.store(model_, contacts_);
    if (motion)
      booking.book(model_, contacts_.rows(), scheme, d, ledger_);
    else
      booking.book_friction(model_, ledger_);
  }
  ledger_.ahead = scheme.bond_ahead;
  if (plan_.bonds && (!motion || !fracture_)) store_tractions();  // else they are, to be judged
}

std::vector<Vec2> Stepper::reactions() {
  prepare_bonds();
  return support_reactions(model_, supports_, model_.time);
}

void Stepper::begin_ledger() {
  ledger_ = {};
  if (plan_.dynamic) ledger_.ahead = scheme(step_size_.next(model_.time)).bond_ahead;
  const Energies now = energies();
  ledger_.start_energy = now.total;
  ledger_.start_shift = -now.numerical;
}

Energies Stepper::energies() {
  prepare_bonds();
  const double ahead = ledger_.ahead, gravity_ahead = gravity_energy_ahead(model_, ahead);
  Energies e;
  e.kinetic = plan_.dynamic ? kinetic_energy(model_, ahead) : 0;
  e.strain = strain_energy(model_, joints_, supports_, ahead);
  e.contact = contact_energy(model_);
  e.gravity = gravity_ahead - ledger_.gravity_work;
  e.total = e.kinetic + e.strain + e.contact + e.gravity;
  e.external = ledger_.external_work;
  e.boundary = ledger_.boundary_work;
  e.friction = ledger_.friction_work;
  e.damping = ledger_.damping_work;
  e.fracture = ledger_.fracture_work;
  double shift = gravity_ahead;  // at y less at X: part of the integrator's loss that needs no booking
  if (ahead != 0)
    shift += e.strain - strain_energy(model_, joints_, supports_, 0) + e.kinetic - kinetic_energy(model_, 0);
  e.numerical = ledger_.numerical_flow - (shift - ledger_.start_shift);
  e.unexplained = e.total - ledger_.start_energy - e.external - e.boundary + e.friction + e.damping + e.fracture + e.numerical;
  e.scale = std::max(ledger_.start_energy, ledger_.largest_work);
  return e;
}

void Stepper::give_up(const Equilibrium& search) const {
  if (search.last.singular_block >= 0) give_up(search.last, 0);
  throw RunError("no equilibrium at t = " + std::to_string(model_.time) + " s: " +
                 block_name(model_, culprit(search)) +
                 " keeps moving. Nothing holds it, or it slides: fix it, raise the friction, or run the scene as dynamic");
}

void Stepper::give_up(const OpenCloseResult& result, double dt) const {
  char text[400];
  if (result.singular_block >= 0) {
    std::snprintf(text, sizeof text, "nothing holds %s: fix it, put it on something, or run the scene as dynamic",
                  block_name(model_, result.singular_block).c_str());
    throw RunError(text);
  }
  std::snprintf(text, sizeof text,
                "t = %.9g s: no step down to %.3g s is accepted: after %d iterations the contact forces on %s are out of "
                "balance by %.3g of what meets there",
                model_.time, dt, result.iterations, block_name(model_, std::max(result.worst_block, 0)).c_str(),
                result.residual);
  std::string message = text;
  for (const Contact& c : model_.contacts)
    if ((c.i == result.worst_block || c.j == result.worst_block) && message.size() < 900)
      message += "; it touches " + block_name(model_, c.i == result.worst_block ? c.j : c.i);
  throw RunError(message);
}

int Stepper::culprit(const Equilibrium& search) const {
  if (!search.last.converged) return std::max(search.last.worst_block, 0);
  int fastest = 0;
  double most = -1;
  for (size_t b = 0; b < model_.shapes.size(); ++b) {
    const BlockShape& shape = model_.shapes[b];
    if (shape.dofs == 0) continue;
    const double moved = search.d.segment(shape.dof_begin, shape.dofs).norm();
    if (moved > most) {
      most = moved;
      fastest = int(b);
    }
  }
  return fastest;
}

}  // namespace talus
