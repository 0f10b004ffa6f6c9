// Newton's steps of open–close.
#include <algorithm>
#include <cmath>

#include "equations/gmres.h"
#include "step/open_close.h"

namespace talus {

namespace {

// The line search is exact when the slope has fallen to this part.
constexpr double slope_part = 0.05;

// Products with the matrix in one unsymmetric solve; each costs a back-substitution, a tenth of a factor.
constexpr int most_products = 40;
constexpr double least_step = 1.0 / 64;
constexpr double coarse =
    1e-3;  // of the residual: what a solve of the coupled law leaves, as states change anyway

}  // namespace

bool OpenClose::factor(ContactProblem& problem, OpenCloseResult& result) {
  if (result.iterations > 0 && closed_ == factored_closed_ && stuck_ == factored_stuck_) return true;
  std::vector<double> linear = problem.system.matrix.values;
  problem.contacts.add_stiffness(problem.system.matrix, closed_, stuck_);
  const int singular = problem.factor();
  result.singular_block = singular < 0 ? -1 : problem.blocks[singular];
  problem.system.matrix.values.swap(linear);
  factored_closed_ = closed_;
  factored_stuck_ = stuck_;
  return result.singular_block < 0;
}

void OpenClose::multiply(const ContactProblem& problem) {
  kp_.setZero(p_.size());
  problem.system.matrix.multiply(p_, kp_);
}

void OpenClose::advance(const ContactProblem& problem, double step, Vector& d, OpenCloseResult& result) {
  d += step * p_;
  kd_ += step * kp_;
  arrive(problem, d, result);
}

void OpenClose::arrive(const ContactProblem& problem, const Vector& d, OpenCloseResult& result) {
  evaluate(problem, d);
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) limit_[k] = friction_limit(rows[k], normal_force(rows[k], k));
  judge_residual(problem, 0, result);
}

// The unknowns at the present states: what presses may pull, what sticks has no limit and what slips keeps its
// force. From the states of the last step, where few change in a step, this is nearly the answer, as it is from
// those of the sweeps.
void OpenClose::predict(ContactProblem& problem, Vector& d, OpenCloseResult& result) {
  r_ = problem.system.force;
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    if (closed_[k]) rows[k].add(rows[k].normal_i, rows[k].normal_j, -rows[k].kn * rows[k].gap0, r_);
    rows[k].add(rows[k].shear_i, rows[k].shear_j, -(stuck_[k] ? rows[k].ks * rows[k].slide0 : shear_[k]), r_);
  }
  problem.solver.solve(r_, d);
  kd_.setZero(d.size());
  problem.system.matrix.multiply(d, kd_);
  arrive(problem, d, result);
}

// One Newton step on the convex potential with friction limits frozen, then the limits follow the normal forces. A
// limit that swings goes half as far each time: at a wedge a higher limit may open the contact that gave it.
void OpenClose::convex_step(ContactProblem& problem, Vector& d, OpenCloseResult& result) {
  residual(problem, false, r_);
  problem.solver.solve(r_, p_);
  multiply(problem);
  const double step = problem.contacts.rows().empty() ? 1 : line_search(problem, p_, -r_.dot(p_), p_.dot(kp_));
  const std::vector<double> frozen = limit_;
  advance(problem, step, d, result);
  for (size_t k = 0; k < limit_.size(); ++k) {
    const double change = limit_[k] - frozen[k];
    if (!std::isfinite(change)) continue;  // without a bound: the settled start
    if (change * last_change_[k] < 0) pace_[k] *= 0.5;
    if (change != 0) last_change_[k] = change;
    limit_[k] = frozen[k] + pace_[k] * change;
  }
}

// One Newton step on the coupled law, whose limits follow the normal force: unsymmetric, so by GMRES with the
// factor of the symmetric part. Kept only if the residual falls; frozen limits alone would converge linearly.
bool OpenClose::coupled_step(ContactProblem& problem, double tolerance, Vector& d, OpenCloseResult& result) {
  const auto& rows = problem.contacts.rows();
  std::vector<size_t> sticking, slipping;
  for (size_t k = 0; k < rows.size(); ++k) {
    if (std::abs(rows[k].ks * slide_[k]) < friction_limit(rows[k], -rows[k].kn * gap_[k]))
      sticking.push_back(k);
    else if (closed_[k] && rows[k].friction > 0)
      slipping.push_back(k);
  }
  if (slipping.empty()) return false;
  const double f = problem.contacts.factor();
  const auto apply = [&](const Vector& x, Vector& y) {
    y.setZero(x.size());
    problem.system.matrix.multiply(x, y);
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
  residual(problem, true, r_);
  const double wanted = std::clamp(0.1 * tolerance / result.residual, coarse, 1e-2);
  gmres(
      apply, [&](const Vector& y, Vector& z) { problem.solver.solve(y, z); }, r_, wanted, most_products, p_);
  multiply(problem);
  // Along p the residual falls at once, and in every norm, until a state changes: halve until it has fallen.
  const OpenCloseResult before = result;
  const std::vector<double> limits = limit_;
  const Vector d0 = d, kd0 = kd_;
  for (double step = 1; step >= least_step; step /= 2) {
    d = d0;
    kd_ = kd0;
    advance(problem, step, d, result);
    if (result.residual < (1 - 0.3 * step) * before.residual) return true;
  }
  d = d0;
  kd_ = kd0;
  evaluate(problem, d);
  limit_ = limits;
  result = before;
  return false;
}

// Share of a contact in the potential's slope, limits frozen, after `step` of a move that changes gap and slide so
// fast.
double OpenClose::contact_slope(const ContactRows& row, size_t k, double step, double gap_rate, double slide_rate,
                                double factor) const {
  const double gap = gap_[k] + step * gap_rate, slide = slide_[k] + step * slide_rate;
  return (-row.kn * std::max(0.0, -gap) * gap_rate +
          std::clamp(row.ks * slide, -limit_[k], limit_[k]) * slide_rate) /
         factor;
}

// Root of the potential's slope along p; the slope is a rising, piecewise linear function of the step.
double OpenClose::line_search(const ContactProblem& problem, const Vector& p, double slope0,
                              double curvature) const {
  const auto& rows = problem.contacts.rows();
  std::vector<double> gap_rate(rows.size()), slide_rate(rows.size());
  const auto contact_slopes = [&](double step) {
    double slope = 0;
    for (size_t k = 0; k < rows.size(); ++k)
      slope += contact_slope(rows[k], k, step, gap_rate[k], slide_rate[k], problem.contacts.factor());
    return slope;
  };
  for (size_t k = 0; k < rows.size(); ++k) {
    gap_rate[k] = problem.contacts.factor() * rows[k].along(rows[k].normal_i, rows[k].normal_j, p);
    slide_rate[k] = problem.contacts.factor() * rows[k].along(rows[k].shear_i, rows[k].shear_j, p);
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

}  // namespace talus
