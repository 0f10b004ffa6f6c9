#include "step/open_close.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

// Cost of a factor in pairs of sweeps, measured on packings: 6 µs a block times √(blocks / 1000) against 80 ns a
// contact.
constexpr double factor_per_pair = 75;
// Contacts whose states change in ten pairs, part of all: below it sweeps may end before their pairs are done. 0.001
// and 0.002 are no cheaper.
constexpr double still_changing = 0.0005;
constexpr int least_worth = 10, most_worth = 200;
// Pairs before the first step of Newton's, and after each to put its states right, times the root of the number of
// blocks: what sweeps have to carry from one end to the other. Half or twice as many cost a pile as much. In a plate
// that a blast cracks 20 are enough.
constexpr double pairs_before = 2.5, pairs_between = 2.5;
constexpr int pairs_before_bonded = 50, pairs_between_bonded = 20, least_pairs = 20;
// Rounds in which neither what sweeps change halves nor the states that Newton's step contradicts fall to `fewer` of
// those of the round before, before the splitting. With 0 piles of 1500 blocks are cut more and take a third more; by
// what sweeps change alone the crater's pile is split twice as often.
constexpr int most_in_vain = 1;
constexpr double fewer = 0.7;
// Rounds at most: with 3 to 8 the crater comes apart in half the time, and with 3 and 5 its pile takes a tenth less
// than without a bound. Where nothing pressed before the step, as in a wall that begins from zero gaps, fewer: one of
// 1600 bricks of 1 GPa takes 5.4 s for 6.0, and of 30 GPa 4.6 for 4.3.
constexpr int most_rounds = 5, most_rounds_unpressed = 2;
using Carry = ContactSweeps::Carry;
constexpr int none = -1, any = std::numeric_limits<int>::max();  // contacts whose states may still change
constexpr int splittings = 80;                                   // iterations a round
// Iterations in which no state changes: they are tried, with a factor of their own. With 4 a wall of 30 GPa takes a
// sixth more.
constexpr int least_quiet = 16;
constexpr int patience = 6;   // rounds that do not halve the change of the splitting, before the step is cut
constexpr int most_full = 8;  // Newton's steps from the splitting's states
// Newton's steps in equilibrium: before the splitting, and where nothing slides, before it is sought against more
// inertia.
constexpr int newton_sliding = 4, newton_stuck = 15;
// And in motion where few states change from step to step, as in a wall that settles: part of those that press.
constexpr int newton_steady = 3;
constexpr double few_states = 0.01;
constexpr int pairs_alone = 10000;         // where no factor is allowed: as tests/contact gives its candidates
constexpr double sweep_tolerance = 1e-13;  // change of a pair, part of all forces: contacts are stiffer than blocks

bool presses_already(const ContactProblem& problem) {
  for (size_t k = 0; k < problem.contacts.rows().size(); ++k)
    if (problem.before(k).normal_force > 0) return true;
  return false;
}

}  // namespace

OpenCloseResult OpenClose::solve(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                                 std::span<const ContactForces> reached) {
  OpenCloseResult result;
  start(problem);
  if (d.size() == 0) {
    d.setZero(problem.system.force.size());
    evaluate(problem, d);
  } else {
    problem.system.matrix.multiply(d, kd_);
    arrive(problem, d, result);
    forces_at_present(problem);
    for (size_t k = 0; k < reached.size(); ++k)
      if (reached[k].n >= 0) {
        normal_[k] = reached[k].n;
        shear_[k] = reached[k].t;
      }
    // what was sought again concerns others
    if (settings.motion && !missed_ && result.residual <= settings.tolerance) {
      result.converged = true;
      return result;
    }
  }
  // Bonds alone are linear: one factor, which costs what a few pairs of sweeps over patches do.
  const bool linear = problem.contacts.rows().empty() && problem.blocks.size() > 1;
  const bool swept = settings.motion && (settings.solver == ContactSolver::sweeps ||
                                         (settings.solver == ContactSolver::automatic && !linear));
  if (swept) sweeps_.start(problem);
  if (swept && settings.solver == ContactSolver::sweeps)
    solve_by_sweeps(problem, settings.tolerance, d, result);
  else if (swept)
    solve_motion(problem, settings, d, result);
  else if (settings.motion && settings.solver == ContactSolver::splitting && !problem.contacts.rows().empty())
    split_from_present(problem, settings, d, result);
  else if (settings.motion)
    solve_by_newton(problem, settings, settings.max_iterations, d, result);
  else
    solve_equilibrium(problem, settings, d, result);
  if (settings.motion && result.converged && !result.steady)
    result.steady = !settings.steady && result.effort() > newton_steady && few_changed(problem);
  return result;
}

// Newton's steps where few states change, else the splitting. Contacts that do not slide have no states to look for in
// it: the problem is convex.
void OpenClose::solve_equilibrium(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                                  OpenCloseResult& result) {
  const auto& rows = problem.contacts.rows();
  const bool slides =
      std::any_of(rows.begin(), rows.end(), [](const ContactRows& row) { return std::isfinite(row.cohesion); });
  solve_by_newton(problem, settings, std::min(settings.max_iterations, slides ? newton_sliding : newton_stuck), d,
                  result);
  if (!slides || result.converged || missed_ || result.singular_block >= 0 || !std::isfinite(result.residual)) return;
  split_from_present(problem, settings, d, result);
}

void OpenClose::split_from_present(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                                   OpenCloseResult& result) {
  forces_at_present(problem);
  take_states(problem);
  solve_by_splitting(problem, settings, d, result);
  result.missed = !result.converged && missed_;
}

// Sweeps, and where they are slow Newton's steps from their states, each followed by sweeps from its forces, a few
// times, as long as that halves what the sweeps still change, but for once; then the splitting, from what the sweeps
// changed least: a step of Newton's that led away takes the forces along.
void OpenClose::solve_motion(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                             OpenCloseResult& result) {
  const double tolerance = settings.tolerance;
  const double blocks = double(problem.blocks.size()),
               count = double(std::max<size_t>(problem.contacts.rows().size(), 1));
  const int worth =
      std::clamp(int(factor_per_pair * blocks / count * std::sqrt(blocks / 1000)), least_worth, most_worth);
  const auto pairs = [&](double part, int of_bonded) {
    return sweeps_.bonded() ? of_bonded : std::max(least_pairs, int(part * std::sqrt(blocks)));
  };
  const auto swept = [&](int most, int changing) {
    result.converged =
        sweep(problem, {most, sweep_tolerance, worth, changing}, Carry::momentum, d, result) <= tolerance;
    take_states(problem);
  };
  struct {
    double change = std::numeric_limits<double>::infinity();
    std::vector<double> normal, shear;
    Vector d;
  } least;
  const auto keep_least = [&] {
    if (!result.converged && result.sweep_change < least.change) least = {result.sweep_change, normal_, shear_, d};
  };
  const auto back_to_least = [&] {
    if (least.d.size() == 0) return;  // forces that are no numbers
    normal_ = least.normal;
    shear_ = least.shear;
    d = least.d;
    take_states(problem);
  };
  if (settings.steady && go_on_steadily(problem, settings, d, result)) return;
  const int most = presses_already(problem) ? most_rounds : most_rounds_unpressed;
  double wrong_before = std::numeric_limits<double>::infinity();  // states
  int rounds = 0, in_vain = settings.split ? most_in_vain + 1 : 0;
  swept(3 * worth, any);
  if (!result.converged && !settings.split)
    swept(pairs(pairs_before, pairs_before_bonded), int(still_changing * count));
  keep_least();
  while (in_vain <= most_in_vain && !result.converged && !missed_ && result.iterations < settings.max_iterations &&
         result.effort() < settings.most_effort) {
    const double before = result.sweep_change;
    if (!factor(problem, result)) return;
    ++result.iterations;
    predict(problem, d, result);
    const double wrong = contradictions(problem);
    follow_pivots(problem, tolerance, d, result);
    if (result.singular_block >= 0 || (result.converged = result.residual <= tolerance)) return;
    take_forces(problem);
    swept(pairs(pairs_between, pairs_between_bonded), none);
    if (!(result.sweep_change < 0.5 * before) && !(wrong < fewer * wrong_before)) ++in_vain;
    wrong_before = wrong;
    if (++rounds == most) in_vain = most_in_vain + 1;
    keep_least();
  }
  if (in_vain > most_in_vain && !result.converged && !missed_) {
    back_to_least();
    solve_by_splitting(problem, settings, d, result);
    result.split = result.converged;
  }
  result.missed = !result.converged && missed_;
}

// Where that does not do, everything is as it was.
bool OpenClose::go_on_steadily(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                               OpenCloseResult& result) {
  const std::vector<double> normal = normal_, shear = shear_;
  const std::vector<char> closed = closed_, stuck = stuck_;
  const Vector from = d;
  const double before = result.effort();
  solve_by_newton(problem, settings, newton_steady, d, result);
  result.steady = result.converged;
  result.missed = !result.converged && missed_;
  if (result.converged || missed_ || result.singular_block >= 0) return true;
  result.in_vain = result.effort() - before;
  normal_ = normal;
  shear_ = shear;
  closed_ = closed;
  stuck_ = stuck;
  d = from;
  go_to(problem, d, result);
  return false;
}

// Whether contacts end the step in the states that they ended the last one in, but for a few of those that press.
bool OpenClose::few_changed(const ContactProblem& problem) const {
  const auto& rows = problem.contacts.rows();
  int changed = 0, pressed = 0;
  for (size_t k = 0; k < rows.size(); ++k) {
    const double normal = rows[k].near ? normal_force(rows[k], k) : 0;
    const bool sticks = std::abs(rows[k].ks * slide_[k]) < friction_limit(rows[k], normal);
    const ContactState now = normal <= 0 ? ContactState::open : sticks ? ContactState::stick : ContactState::slip;
    pressed += normal > 0;
    changed += now != problem.before(k).state;
  }
  return changed <= few_states * pressed;
}

// The splitting, and whenever its states have settled Newton's whole steps from them. Where these lead away it goes on
// from where it was, with springs for the states that it has found.
void OpenClose::solve_by_splitting(ContactProblem& problem, const OpenCloseSettings& settings, Vector& d,
                                   OpenCloseResult& result) {
  const double tolerance = settings.tolerance;
  double least = std::numeric_limits<double>::infinity();
  int in_vain = 0, quiet = least_quiet;
  for (bool rough = true; !missed_ && result.iterations < settings.max_iterations && in_vain < patience &&
                          result.effort() < settings.most_effort;
       rough = false) {
    ++result.iterations;
    factored_closed_.clear();
    const auto progress =
        splitting_.run(problem, rough, quiet, splittings + 2 * quiet, {normal_, shear_, closed_, stuck_}, d);
    result.splittings += progress.iterations;
    if (!progress.factored) return;
    if (rough) continue;
    if (!(progress.change < 0.5 * least)) ++in_vain;
    least = std::min(least, progress.change);
    if (!progress.settled) continue;
    quiet *= 2;  // where these states are wrong
    const std::vector<char> closed = closed_;
    const Vector reached = d;
    if (!factor(problem, result)) return;
    ++result.iterations;
    predict(problem, d, result);
    for (int k = 0; k < most_full && result.residual > tolerance && result.residual < 1; ++k)
      full_step(problem, d, result);
    if ((result.converged = result.residual <= tolerance)) return;
    d = reached;
    go_to(problem, d, result);  // whether a contact is missed there
    closed_ = closed;
  }
}

// Asked for: no factor, whatever it costs.
void OpenClose::solve_by_sweeps(ContactProblem& problem, double tolerance, Vector& d, OpenCloseResult& result) {
  for (const Carry carry : {Carry::momentum, Carry::mixing})
    if (!result.converged && !(missed_ && carry == Carry::mixing))
      result.converged =
          sweep(problem, {.most = pairs_alone, .enough = sweep_tolerance}, carry, d, result) <= tolerance;
  result.missed = !result.converged && missed_;
}

// In equilibrium, where nothing but neighbours holds a block, or where asked for: Newton's steps, of the coupled law
// where the states have settled, else of the convex potential.
void OpenClose::solve_by_newton(ContactProblem& problem, const OpenCloseSettings& settings, int most, Vector& d,
                                OpenCloseResult& result) {
  const double tolerance = settings.tolerance;
  const auto& rows = problem.contacts.rows();
  continue_states(problem);
  while (!result.converged && result.iterations < most) {
    if (!factor(problem, result)) return;
    ++result.iterations;
    if (result.iterations == 1)
      predict(problem, d, result);
    else if (changed_states(problem) > 0 || !coupled_step(problem, d, result))
      convex_step(problem, d, result);
    result.converged = result.residual <= tolerance;
    if (!std::isfinite(result.residual)) return;
    for (size_t k = 0; k < rows.size(); ++k) stuck_[k] = std::abs(rows[k].ks * slide_[k]) < limit_[k];
  }
  result.missed = !result.converged && missed_;
}

// Contacts whose states at d are not those that were solved with.
int OpenClose::changed_states(const ContactProblem& problem) const {
  const auto& rows = problem.contacts.rows();
  int changed = 0;
  for (size_t k = 0; k < rows.size(); ++k) {
    const bool stuck = std::abs(rows[k].ks * slide_[k]) < limit_[k];
    changed += closed_[k] != factored_closed_[k] || stuck != bool(factored_stuck_[k]);
  }
  return changed;
}

void OpenClose::forces_at_present(const ContactProblem& problem) {
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    normal_[k] = rows[k].near ? normal_force(rows[k], k) : 0;
    const double limit = friction_limit(rows[k], normal_[k]);
    shear_[k] = std::clamp(rows[k].ks * slide_[k], -limit, limit);
  }
}

// The forces of the last solve, cut to what contacts can carry; what has met since carries none yet.
void OpenClose::take_forces(const ContactProblem& problem) {
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    normal_[k] = aimed_closed_[k] ? normal_force(rows[k], k) : 0;
    const double limit = friction_limit(rows[k], normal_[k]);
    shear_[k] = aimed_stuck_[k] ? std::clamp(rows[k].ks * slide_[k], -limit, limit) : std::copysign(limit, shear_[k]);
  }
}

// The states of the forces.
void OpenClose::take_states(const ContactProblem& problem) {
  for (size_t k = 0; k < normal_.size(); ++k) {
    closed_[k] = normal_[k] > 0;
    stuck_[k] = std::abs(shear_[k]) < (1 - 1e-12) * friction_limit(problem.contacts.rows()[k], normal_[k]);
  }
}

double OpenClose::sweep(const ContactProblem& problem, const ContactSweeps::End& end, ContactSweeps::Carry carry,
                        Vector& d, OpenCloseResult& result) {
  const auto progress = sweeps_.run(end, carry, normal_, shear_, d);
  result.sweeps += 2 * progress.pairs;
  result.sweep_change = progress.moved;
  go_to(problem, d, result);
  return result.residual;
}

void OpenClose::continue_states(const ContactProblem& problem) {
  for (size_t k = 0; k < closed_.size(); ++k) {
    const ContactState state = problem.before(k).state;
    closed_[k] = closed_[k] || state != ContactState::open;
    // What closes now sticks at first; what does not slide, open or not.
    stuck_[k] = (closed_[k] && state != ContactState::slip) || std::isinf(problem.contacts.rows()[k].cohesion);
  }
}

}  // namespace talus
