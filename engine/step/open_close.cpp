#include "step/open_close.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "equations/gmres.h"

namespace talus {

namespace {

// A block's residual is measured against the forces that meet in it, but not below this part of the largest
// such sum in the scene: round-off of the large forces reaches every block through the factor.
constexpr double force_floor = 1e-4;

// The line search is exact when the slope has fallen to this part.
constexpr double slope_part = 0.05;

// Products with the matrix in one unsymmetric solve; each costs a back-substitution, a tenth of a factor.
constexpr int most_products = 40;
constexpr double least_step = 1.0 / 64;

// Cost of a factor in pairs of sweeps, measured on packings: 6 µs a block times √(blocks / 1000) against 80 ns a contact.
constexpr double factor_per_pair = 75;
constexpr int least_worth = 10, most_worth = 200;
constexpr int pairs_between = 100;  // after a step of Newton's, to put its states right: more where fewer would do is cheap
constexpr double damped = 0.5;   // part of a change that sweeps take where plain ones did not get on
constexpr int patience = 3;      // iterations that do not halve the change of the sweeps, before the step is cut
constexpr int pairs_among_bonds = 30;
constexpr int few = 20;       // one state in so many has changed: the coupled law is tried
constexpr int most_coupled = 3;  // steps of the coupled law in a row
constexpr double sweep_tolerance = 1e-13;  // change of a pair, part of all forces: contacts are stiffer than blocks

}  // namespace

double OpenClose::friction_limit(const ContactRows& row, double normal) const {
  return normal > 0 ? (std::isinf(row.friction) ? row.friction : row.friction * normal) + row.cohesion : 0;
}

void OpenClose::evaluate(const ContactTerms& contacts, const Vector& d) {
  const auto& rows = contacts.rows();
  missed_ = false;
  for (size_t k = 0; k < rows.size(); ++k) {
    gap_[k] = rows[k].gap0 + contacts.factor() * rows[k].along(rows[k].normal_i, rows[k].normal_j, d);
    slide_[k] = rows[k].slide0 + contacts.factor() * rows[k].along(rows[k].shear_i, rows[k].shear_j, d);
    closed_[k] = rows[k].near && gap_[k] <= 0;
    missed_ = missed_ || (!rows[k].near && gap_[k] < 0);
  }
}

void OpenClose::residual(const System& system, const ContactTerms& contacts, bool coupled, Vector& r) const {
  r = system.force - kd_;
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const double normal = rows[k].kn * std::max(0.0, -gap_[k]);
    const double limit = coupled ? friction_limit(rows[k], normal) : limit_[k];
    if (normal > 0) rows[k].add(rows[k].normal_i, rows[k].normal_j, normal, r);
    if (limit > 0) rows[k].add(rows[k].shear_i, rows[k].shear_j, -std::clamp(rows[k].ks * slide_[k], -limit, limit), r);
  }
}

void OpenClose::start(const Model& model, const System& system, const ContactTerms& contacts) {
  const size_t count = contacts.rows().size();
  for (auto* list : {&gap_, &slide_, &limit_}) list->resize(count);
  pace_.assign(count, 1);
  last_change_.assign(count, 0);
  for (auto* list : {&closed_, &stuck_}) list->resize(count);
  factored_closed_.clear();
  kd_.setZero(system.force.size());
  for (size_t k = 0; k < count; ++k)
    limit_[k] = friction_limit(contacts.rows()[k], model.contacts[k].normal_force);
  normal_.resize(count);
  shear_.resize(count);
  for (size_t k = 0; k < count; ++k) {
    normal_[k] = std::max(0.0, model.contacts[k].normal_force);
    shear_[k] = std::clamp(model.contacts[k].shear_force, -limit_[k], limit_[k]);
  }
}

void OpenClose::judge_residual(const Model& model, const System& system, const ContactTerms& contacts,
                               double place_rounding, OpenCloseResult& result) {
  residual(system, contacts, true, r_);
  std::vector<double> scale = system.force_scale, rounding = system.force_rounding;
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const Contact& contact = model.contacts[k];
    const double normal = rows[k].kn * std::max(0.0, -gap_[k]);
    scale[contact.i] += normal;
    scale[contact.j] += normal;
    rounding[contact.i] += rows[k].kn * place_rounding;
    rounding[contact.j] += rows[k].kn * place_rounding;
  }
  const double floor = force_floor * *std::max_element(scale.begin(), scale.end());
  result.residual = 0;
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const BlockShape& shape = model.shapes[b];
    if (shape.dofs == 0) continue;
    const double out = r_.segment(shape.dof_begin, shape.dofs).norm();
    if (out <= rounding[b]) continue;
    const double relative = (out - rounding[b]) / std::max(scale[b], floor);
    if (!(relative <= result.residual)) {  // so written that one that is not a number counts as the worst
      result.residual = relative;
      result.worst_block = int(b);
    }
  }
}

// Share of a contact in the potential's slope, limits frozen, after `step` of a move that changes gap and slide so fast.
double OpenClose::contact_slope(const ContactRows& row, size_t k, double step, double gap_rate, double slide_rate,
                                double factor) const {
  const double gap = gap_[k] + step * gap_rate, slide = slide_[k] + step * slide_rate;
  return (-row.kn * std::max(0.0, -gap) * gap_rate + std::clamp(row.ks * slide, -limit_[k], limit_[k]) * slide_rate) /
         factor;
}

// Root of the potential's slope along p; the slope is a rising, piecewise linear function of the step.
double OpenClose::line_search(const ContactTerms& contacts, const Vector& p, double slope0, double curvature) const {
  const auto& rows = contacts.rows();
  std::vector<double> gap_rate(rows.size()), slide_rate(rows.size());
  const auto contact_slopes = [&](double step) {
    double slope = 0;
    for (size_t k = 0; k < rows.size(); ++k)
      slope += contact_slope(rows[k], k, step, gap_rate[k], slide_rate[k], contacts.factor());
    return slope;
  };
  for (size_t k = 0; k < rows.size(); ++k) {
    gap_rate[k] = contacts.factor() * rows[k].along(rows[k].normal_i, rows[k].normal_j, p);
    slide_rate[k] = contacts.factor() * rows[k].along(rows[k].shear_i, rows[k].shear_j, p);
  }
  const double at0 = contact_slopes(0);
  const auto slope = [&](double step) { return slope0 + step * curvature + contact_slopes(step) - at0; };
  const double enough = slope_part * std::abs(slope0);
  double low = 0, high = 1, at_low = slope0, at_high = slope(1);
  if (at_high <= enough) return 1;
  for (int i = 0; i < 60; ++i) {  // Illinois: regula falsi that halves the stale end
    const double middle = (low * at_high - high * at_low) / (at_high - at_low), at_middle = slope(middle);
    if (std::abs(at_middle) <= enough) return middle;
    if (at_middle > 0) {
      high = middle;
      at_high = at_middle;
      at_low *= 0.5;
    } else {
      low = middle;
      at_low = at_middle;
      at_high *= 0.5;
    }
  }
  return low > 0 ? low : high;
}

OpenCloseResult OpenClose::judge(const Model& model, const System& system, const ContactTerms& contacts) {
  OpenCloseResult result;
  start(model, system, contacts);
  evaluate(contacts, Vector::Zero(system.force.size()));
  // Gaps are differences of places: their rounding times the stiffness is no force.
  const double place_rounding = 8 * std::numeric_limits<double>::epsilon() * model.extent;
  judge_residual(model, system, contacts, place_rounding, result);
  return result;
}

OpenCloseResult OpenClose::solve(const Model& model, System& system, const ContactTerms& contacts,
                                 LinearSolver& solver, double tolerance, int max_iterations, bool motion, Vector& d) {
  OpenCloseResult result;
  d.setZero(system.force.size());
  // What rests goes on as it is: nothing has to be solved, and round-off of the places is not chased from step to step.
  result = judge(model, system, contacts);
  if (motion && result.residual <= tolerance) {
    result.converged = result.at_rest = true;
    return result;
  }
  const std::vector<double> base = system.matrix.values;
  if (motion) sweeps_.start(model, system, contacts);
  if (motion && sweeps_.whole() && !sweeps_.empty())
    solve_motion(model, system, contacts, solver, base, tolerance, max_iterations, d, result);
  else
    solve_bonded(model, system, contacts, solver, base, tolerance, max_iterations, motion, d, result);
  system.matrix.values = base;
  return result;
}

// Sweeps, and where they are slow Newton's steps from their states, each followed by sweeps from its forces. Where those
// end farther from rest than the sweeps before, Newton's step has led away: back, and more sweeps.
void OpenClose::solve_motion(const Model& model, System& system, const ContactTerms& contacts, LinearSolver& solver,
                             const std::vector<double>& base, double tolerance, int max_iterations, Vector& d,
                             OpenCloseResult& result) {
  const double blocks = double(model.shapes.size()), count = double(std::max<size_t>(contacts.rows().size(), 1));
  const int worth = std::clamp(int(factor_per_pair * blocks / count * std::sqrt(blocks / 1000)), least_worth, most_worth);
  result.converged = sweep(model, system, contacts, 3 * worth, worth, 1, d, result) <= tolerance;
  take_states(contacts);
  double reached = result.sweep_change;
  int in_vain = 0;
  while (!result.converged && !missed_ && result.iterations < max_iterations && in_vain < patience) {
    const std::vector<double> normal = normal_, shear = shear_;
    if (!factor(system, contacts, base, solver, result)) return;
    ++result.iterations;
    predict(model, system, contacts, solver, d, result);
    const auto closed = std::count(closed_.begin(), closed_.end(), 1);
    for (int k = 0; k < most_coupled && result.residual > tolerance && few * changed_states(contacts) <= closed; ++k)
      if (!coupled_step(model, system, contacts, solver, tolerance, d, result)) break;
    if ((result.converged = result.residual <= tolerance)) return;
    take_forces(contacts);
    result.converged = sweep(model, system, contacts, pairs_between, 0, 1, d, result) <= tolerance;
    if (!result.converged && !missed_ && !(result.sweep_change < reached)) {
      normal_ = normal;
      shear_ = shear;
      result.converged = sweep(model, system, contacts, 2 * pairs_between, 0, damped, d, result) <= tolerance;
    }
    if (!(result.sweep_change < 0.5 * reached)) ++in_vain;
    reached = result.sweep_change;
    take_states(contacts);
  }
  result.missed = !result.converged && missed_;
}

// Where blocks hang together by bonds, and in equilibrium, where nothing but neighbours holds a block: Newton's steps, of
// the coupled law where the states have settled, else of the convex potential. In motion loose blocks are then brought
// to rest among the others by sweeps, where that lowers the residual.
void OpenClose::solve_bonded(const Model& model, System& system, const ContactTerms& contacts, LinearSolver& solver,
                             const std::vector<double>& base, double tolerance, int max_iterations, bool motion, Vector& d,
                             OpenCloseResult& result) {
  const auto& rows = contacts.rows();
  continue_states(model);
  while (!result.converged && result.iterations < max_iterations) {
    if (!factor(system, contacts, base, solver, result)) return;
    ++result.iterations;
    if (result.iterations == 1)
      predict(model, system, contacts, solver, d, result);
    else if (changed_states(contacts) > 0 || !coupled_step(model, system, contacts, solver, tolerance, d, result))
      convex_step(model, system, contacts, solver, d, result);
    if (motion && !sweeps_.empty() && result.residual > tolerance) {
      const OpenCloseResult before = result;
      const Vector d0 = d, kd0 = kd_;
      for (size_t k = 0; k < rows.size(); ++k) {
        normal_[k] = rows[k].kn * std::max(0.0, -gap_[k]);
        const double limit = friction_limit(rows[k], normal_[k]);
        shear_[k] = std::clamp(rows[k].ks * slide_[k], -limit, limit);
      }
      sweep(model, system, contacts, pairs_among_bonds, 0, 1, d, result);
      if (!(result.residual < before.residual)) {
        d = d0;
        kd_ = kd0;
        arrive(model, system, contacts, d, result);
      }
    }
    result.converged = result.residual <= tolerance;
    if (!std::isfinite(result.residual)) return;
    for (size_t k = 0; k < rows.size(); ++k) stuck_[k] = std::abs(rows[k].ks * slide_[k]) < limit_[k];
  }
  result.missed = !result.converged && missed_;
}

// Contacts whose states at d are not those that were solved with.
int OpenClose::changed_states(const ContactTerms& contacts) const {
  const auto& rows = contacts.rows();
  int changed = 0;
  for (size_t k = 0; k < rows.size(); ++k) {
    if (!closed_[k] && !factored_closed_[k]) continue;
    const bool stuck = closed_[k] && std::abs(rows[k].ks * slide_[k]) < limit_[k];
    changed += closed_[k] != factored_closed_[k] || stuck != bool(factored_stuck_[k]);
  }
  return changed;
}

// The forces of the last solve, cut to what contacts can carry; what has met since carries none yet.
void OpenClose::take_forces(const ContactTerms& contacts) {
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    normal_[k] = factored_closed_[k] ? rows[k].kn * std::max(0.0, -gap_[k]) : 0;
    const double limit = friction_limit(rows[k], normal_[k]);
    shear_[k] = factored_stuck_[k] ? std::clamp(rows[k].ks * slide_[k], -limit, limit) : std::copysign(limit, shear_[k]);
  }
}

// The states of the forces.
void OpenClose::take_states(const ContactTerms& contacts) {
  for (size_t k = 0; k < normal_.size(); ++k) {
    closed_[k] = normal_[k] > 0;
    stuck_[k] = closed_[k] && std::abs(shear_[k]) < (1 - 1e-12) * friction_limit(contacts.rows()[k], normal_[k]);
  }
}

double OpenClose::sweep(const Model& model, const System& system, const ContactTerms& contacts, int most, int worth,
                        double part, Vector& d, OpenCloseResult& result) {
  const auto progress = sweeps_.run(most, sweep_tolerance, worth, part, normal_, shear_, d);
  result.sweeps += 2 * progress.pairs;
  result.sweep_change = progress.change;
  kd_.setZero(d.size());
  system.matrix.multiply(d, kd_);
  arrive(model, system, contacts, d, result);
  return result.residual;
}

void OpenClose::continue_states(const Model& model) {
  for (size_t k = 0; k < closed_.size(); ++k) {
    const ContactState state = model.contacts[k].state;
    closed_[k] = closed_[k] || state != ContactState::open;
    stuck_[k] = closed_[k] && state != ContactState::slip;  // what closes now sticks at first
  }
}

bool OpenClose::factor(System& system, const ContactTerms& contacts, const std::vector<double>& base,
                       LinearSolver& solver, OpenCloseResult& result) {
  if (result.iterations > 0 && closed_ == factored_closed_ && stuck_ == factored_stuck_) return true;
  system.matrix.values = base;
  contacts.add_stiffness(system.matrix, closed_, stuck_);
  result.singular_block = solver.factor(system.matrix);
  system.matrix.values = base;
  factored_closed_ = closed_;
  factored_stuck_ = stuck_;
  return result.singular_block < 0;
}

void OpenClose::multiply(const System& system) {
  kp_.setZero(p_.size());
  system.matrix.multiply(p_, kp_);
}

void OpenClose::advance(const Model& model, const System& system, const ContactTerms& contacts, double step, Vector& d,
                        OpenCloseResult& result) {
  d += step * p_;
  kd_ += step * kp_;
  arrive(model, system, contacts, d, result);
}

void OpenClose::arrive(const Model& model, const System& system, const ContactTerms& contacts, const Vector& d,
                       OpenCloseResult& result) {
  evaluate(contacts, d);
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) limit_[k] = friction_limit(rows[k], rows[k].kn * std::max(0.0, -gap_[k]));
  judge_residual(model, system, contacts, 0, result);
}

// The unknowns at the present states: what presses may pull, what sticks has no limit and what slips keeps its force. From
// the states of the last step, where few change in a step, this is nearly the answer, as it is from those of the sweeps.
void OpenClose::predict(const Model& model, const System& system, const ContactTerms& contacts, LinearSolver& solver,
                        Vector& d, OpenCloseResult& result) {
  r_ = system.force;
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    if (!closed_[k]) continue;
    rows[k].add(rows[k].normal_i, rows[k].normal_j, -rows[k].kn * rows[k].gap0, r_);
    rows[k].add(rows[k].shear_i, rows[k].shear_j, -(stuck_[k] ? rows[k].ks * rows[k].slide0 : shear_[k]), r_);
  }
  solver.solve(r_, d);
  kd_.setZero(d.size());
  system.matrix.multiply(d, kd_);
  arrive(model, system, contacts, d, result);
}

// One Newton step on the convex potential with friction limits frozen, then the limits follow the normal forces. A
// limit that swings goes half as far each time: at a wedge a higher limit may open the contact that gave it.
void OpenClose::convex_step(const Model& model, const System& system, const ContactTerms& contacts,
                            LinearSolver& solver, Vector& d, OpenCloseResult& result) {
  residual(system, contacts, false, r_);
  solver.solve(r_, p_);
  multiply(system);
  const double step = contacts.rows().empty() ? 1 : line_search(contacts, p_, -r_.dot(p_), p_.dot(kp_));
  const std::vector<double> frozen = limit_;
  advance(model, system, contacts, step, d, result);
  for (size_t k = 0; k < limit_.size(); ++k) {
    const double change = limit_[k] - frozen[k];
    if (!std::isfinite(change)) continue;  // without a bound: the settled start
    if (change * last_change_[k] < 0) pace_[k] *= 0.5;
    if (change != 0) last_change_[k] = change;
    limit_[k] = frozen[k] + pace_[k] * change;
  }
}

// One Newton step on the coupled law, whose limits follow the normal force: unsymmetric, so by GMRES with the factor
// of the symmetric part. Kept only if the residual falls; frozen limits alone would converge linearly.
bool OpenClose::coupled_step(const Model& model, const System& system, const ContactTerms& contacts,
                             LinearSolver& solver, double tolerance, Vector& d, OpenCloseResult& result) {
  const auto& rows = contacts.rows();
  std::vector<size_t> sticking, slipping;
  for (size_t k = 0; k < rows.size(); ++k)
    if (closed_[k]) {
      const bool sticks = std::abs(rows[k].ks * slide_[k]) < friction_limit(rows[k], -rows[k].kn * gap_[k]);
      if (sticks) sticking.push_back(k);
      if (!sticks && rows[k].friction > 0 && std::isfinite(rows[k].friction)) slipping.push_back(k);
    }
  if (slipping.empty()) return false;
  const double f = contacts.factor();
  const auto apply = [&](const Vector& x, Vector& y) {
    y.setZero(x.size());
    system.matrix.multiply(x, y);
    for (size_t k = 0; k < rows.size(); ++k)
      if (closed_[k])
        rows[k].add(rows[k].normal_i, rows[k].normal_j,
                    f * rows[k].kn * rows[k].along(rows[k].normal_i, rows[k].normal_j, x), y);
    for (const size_t k : sticking)
      rows[k].add(rows[k].shear_i, rows[k].shear_j,
                  f * rows[k].ks * rows[k].along(rows[k].shear_i, rows[k].shear_j, x), y);
    for (const size_t k : slipping) {
      const double softer = f * rows[k].kn * rows[k].along(rows[k].normal_i, rows[k].normal_j, x);
      rows[k].add(rows[k].shear_i, rows[k].shear_j, (slide_[k] > 0 ? -1 : 1) * rows[k].friction * softer, y);
    }
  };
  residual(system, contacts, true, r_);
  const double wanted = std::clamp(0.1 * tolerance / result.residual, 1e-10, 1e-2);
  gmres(apply, [&](const Vector& y, Vector& z) { solver.solve(y, z); }, r_, wanted, most_products, p_);
  multiply(system);
  // Along p the residual falls at once, and in every norm, until a state changes: halve until it has fallen.
  const OpenCloseResult before = result;
  const std::vector<double> limits = limit_;
  const Vector d0 = d, kd0 = kd_;
  for (double step = 1; step >= least_step; step /= 2) {
    d = d0;
    kd_ = kd0;
    advance(model, system, contacts, step, d, result);
    if (result.residual < (1 - 0.3 * step) * before.residual) return true;
  }
  d = d0;
  kd_ = kd0;
  evaluate(contacts, d);
  limit_ = limits;
  result = before;
  return false;
}

void OpenClose::store(Model& model, const ContactTerms& contacts) const {
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    Contact& contact = model.contacts[k];
    contact.normal_force = rows[k].kn * std::max(0.0, -gap_[k]);
    const double limit = friction_limit(rows[k], contact.normal_force), trial = rows[k].ks * slide_[k];
    contact.shear_force = std::clamp(trial, -limit, limit);
    contact.state = contact.normal_force <= 0        ? ContactState::open
                    : contact.shear_force == trial ? ContactState::stick
                                                     : ContactState::slip;
    contact.slip = contact.state == ContactState::open ? 0 : contact.slip + (trial - contact.shear_force) / rows[k].ks;
    contact.stretch = contact.shear_force / rows[k].ks;
    contact.gap = gap_[k] - contact.offset;
    contact.offset = std::clamp(-contact.gap, 0.0, contact.offset);  // shrinks as the bodies separate
  }
}

}  // namespace talus
