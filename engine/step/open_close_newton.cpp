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
// What a solve of the coupled law leaves of the motions it is solved by: as states change anyway, with 1e-2 more of
// them are contradicted; and where they are right. There 3e-3 leaves some blocks a tenth or more of their residual,
// which then looks as if Newton's steps did not get on.
constexpr double coarse = 3e-3, fine = 3e-5;

}  // namespace

bool OpenClose::factor(ContactProblem& problem, OpenCloseResult& result) {
  aimed_closed_ = closed_;
  aimed_stuck_ = stuck_;
  if (result.iterations > 0 && closed_ == factored_closed_ && stuck_ == factored_stuck_) return true;
  pivoted_.reset();
  const int singular = problem.factor_with(closed_, stuck_);
  result.singular_block = singular < 0 ? -1 : problem.blocks[singular];
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

void OpenClose::go_to(const ContactProblem& problem, const Vector& d, OpenCloseResult& result) {
  problem.system.matrix.multiply(d, kd_.setZero(d.size()));
  arrive(problem, d, result);
}

// A column of what the coupled law adds to the factored matrix, u vᵀ: force along a contact's normal or shear row, N/m,
// that follows its motion along one of them.
struct OpenClose::Change {
  const ContactRows* row;
  bool shear_force, shear_motion;
  double stiffness;
  void add_unknowns(std::vector<int>& unknowns) const {
    for (int k = 0; k < row->size_i; ++k) unknowns.push_back(row->dof_i + k);
    for (int k = 0; k < row->size_j; ++k) unknowns.push_back(row->dof_j + k);
  }
  double motion(const Vector& x) const {
    return shear_motion ? row->along(row->shear_i, row->shear_j, x) : row->along(row->normal_i, row->normal_j, x);
  }
  void add_force(double motion, Vector& f) const {
    if (shear_force)
      row->add(row->shear_i, row->shear_j, stiffness * motion, f);
    else
      row->add(row->normal_i, row->normal_j, stiffness * motion, f);
  }
};

// The unknowns at the present states: what presses may pull, what sticks has no limit and what slips goes on its way.
// From the states of the last step, where few change in a step, this is nearly the answer, as it is from those of the
// sweeps.
void OpenClose::predict(ContactProblem& problem, Vector& d, OpenCloseResult& result) {
  r_ = problem.system.force;
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    if (closed_[k]) rows[k].add(rows[k].normal_i, rows[k].normal_j, -rows[k].kn * rows[k].gap0, r_);
    rows[k].add(rows[k].shear_i, rows[k].shear_j, -(stuck_[k] ? rows[k].ks * rows[k].slide0 : shear_[k]), r_);
  }
  problem.solver.solve(r_, d);
  follow_friction(problem, d);
  go_to(problem, d, result);
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

// Where the present states differ from the factored ones, and friction at slipping contacts, which moves with the
// normal force.
std::vector<OpenClose::Change> OpenClose::coupled_changes(const ContactProblem& problem) const {
  const auto& rows = problem.contacts.rows();
  const double f = problem.contacts.factor();
  std::vector<Change> changes;
  for (size_t k = 0; k < rows.size(); ++k) {
    const ContactRows& row = rows[k];
    if (!row.near) continue;
    const bool sticks = std::abs(row.ks * slide_[k]) < friction_limit(row, -row.kn * gap_[k]);
    if (const int more = closed_[k] - factored_closed_[k]) changes.push_back({&row, false, false, more * f * row.kn});
    if (const int more = sticks - factored_stuck_[k]) changes.push_back({&row, true, true, more * f * row.ks});
    if (sticks || !closed_[k] || !(row.friction > 0)) continue;
    changes.push_back({&row, true, false, (slide_[k] > 0 ? -1 : 1) * row.friction * f * row.kn});
  }
  return changes;
}

// 1 + VᵀM⁻¹U of the contacts that pivots have moved, among those that differ from M, factored. What they do to each
// other is known from the pivots; where they are as stiff as M is not, and so much of it that GMRES would not end.
class OpenClose::KnownPart {
 public:
  KnownPart(const OpenClose& own, const ContactProblem& problem, const std::vector<Change>& changes) {
    if (!own.pivoted_) return;
    std::vector<Eigen::Index> motions, forces;
    for (size_t k = 0; k < changes.size(); ++k) {
      const int place = own.pivoted_->place[size_t(changes[k].row - problem.contacts.rows().data())];
      if (place < 0) continue;
      which_.push_back(Eigen::Index(k));
      motions.push_back(2 * place + changes[k].shear_motion);
      forces.push_back(2 * place + changes[k].shear_force);
    }
    Eigen::MatrixXd part = own.pivoted_->compliance.matrix()(motions, forces);
    for (size_t b = 0; b < which_.size(); ++b) part.col(Eigen::Index(b)) *= changes[size_t(which_[b])].stiffness;
    part.diagonal().array() += 1;
    if (!which_.empty()) factored_.compute(part);
  }
  void solve(Vector& y) const {
    if (!which_.empty()) y(which_) = factored_.solve(y(which_)).eval();
  }

 private:
  std::vector<Eigen::Index> which_;  // of the changes
  Eigen::PartialPivLU<Eigen::MatrixXd> factored_;
};

// (M + U Vᵀ) p = r with the factored M, by the motions y = Vᵀp of the contacts that differ from it alone:
// (1 + VᵀM⁻¹U) y = VᵀM⁻¹r, unsymmetric, so by GMRES, from the right of which stands what is known of it; then p = M⁻¹(r
// - U y).
void OpenClose::solve_coupled(ContactProblem& problem, const std::vector<Change>& changes, const Vector& r,
                              double leaves, Vector& p) const {
  if (changes.empty()) return problem.solver.solve(r, p);
  const auto count = Eigen::Index(changes.size());
  const auto motions = [&](const Vector& x, Vector& y) {
    y.resize(count);
    for (Eigen::Index k = 0; k < count; ++k) y[k] = changes[size_t(k)].motion(x);
  };
  const KnownPart known(*this, problem, changes);
  Vector force = Vector::Zero(r.size()), x, right, y, from;
  std::vector<int> unknowns;
  for (const Change& change : changes) change.add_unknowns(unknowns);
  const FactorPart part = problem.solver.part(unknowns);
  const auto apply = [&](const Vector& of, Vector& to) {
    from = of;
    known.solve(from);
    for (const int unknown : unknowns) force[unknown] = 0;
    for (Eigen::Index k = 0; k < count; ++k) changes[size_t(k)].add_force(from[k], force);
    problem.solver.solve_coarsely(force, x, part);
    motions(x, to);
    to += from;
  };
  problem.solver.solve_coarsely(r, x);
  motions(x, right);
  gmres(apply, right, leaves, most_products, y);
  known.solve(y);
  force = r;
  for (Eigen::Index k = 0; k < count; ++k) changes[size_t(k)].add_force(-y[k], force);
  if (leaves >= coarse)  // of which a part in ten thousand is less than what is left anyway
    problem.solver.solve_coarsely(force, p);
  else
    problem.solver.solve(force, p);
}

// From the solution with the aimed states and frozen friction at what slips to the one in which it follows the normal
// force.
void OpenClose::follow_friction(ContactProblem& problem, Vector& d) {
  const auto& rows = problem.contacts.rows();
  const double f = problem.contacts.factor();
  std::vector<Change> changes;
  r_.setZero(d.size());
  for (size_t k = 0; k < rows.size(); ++k) {
    const ContactRows& row = rows[k];
    if (const int more = aimed_closed_[k] - factored_closed_[k])
      changes.push_back({&row, false, false, more * f * row.kn});
    if (const int more = aimed_stuck_[k] - factored_stuck_[k]) changes.push_back({&row, true, true, more * f * row.ks});
    if (!aimed_closed_[k] || aimed_stuck_[k] || !(row.friction > 0)) continue;
    const double way = shear_[k] < 0 ? -1 : 1;
    const double normal = -row.kn * problem.contacts.gap(row, d);
    row.add(row.shear_i, row.shear_j, shear_[k] - way * (row.friction * normal + row.cohesion), r_);
    changes.push_back({&row, true, false, -way * row.friction * f * row.kn});
  }
  if (changes.empty()) return;
  solve_coupled(problem, changes, r_, coarse, p_);
  d += p_;
}

// One whole Newton step on the coupled law, wherever it leads: from states that are nearly right.
void OpenClose::full_step(ContactProblem& problem, Vector& d, OpenCloseResult& result) {
  const std::vector<Change> changes = coupled_changes(problem);
  residual(problem, true, r_);
  solve_coupled(problem, changes, r_, fine, p_);
  multiply(problem);
  advance(problem, 1, d, result);
}

// One Newton step on the coupled law, whose limits follow the normal force. Kept only if the residual falls; frozen
// limits alone would converge linearly.
bool OpenClose::coupled_step(ContactProblem& problem, Vector& d, OpenCloseResult& result) {
  const std::vector<Change> changes = coupled_changes(problem);
  if (std::none_of(changes.begin(), changes.end(), [](const Change& c) { return c.shear_force && !c.shear_motion; }))
    return false;  // nothing slips
  residual(problem, true, r_);
  solve_coupled(problem, changes, r_, coarse, p_);
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
  return (-row.kn * std::max(0.0, -gap) * gap_rate + std::clamp(row.ks * slide, -limit_[k], limit_[k]) * slide_rate) /
         factor;
}

// Root of the potential's slope along p; the slope is a rising, piecewise linear function of the step.
double OpenClose::line_search(const ContactProblem& problem, const Vector& p, double slope0, double curvature) const {
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
