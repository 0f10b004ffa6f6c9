#include "step/contact_splitting.h"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

// Springs, part of a contact's own stiffness. Measured on walls of 100 to 2200 bricks whose waves cross 2 to 14 courses in a step:
// 0.03 to 0.3 take alike while states are unknown; 0.3 and 0.001 a third of the iterations of 0.1 once they are known.
constexpr double rough_spring = 0.1, stiff_spring = 0.3, soft_spring = 1e-3;
constexpr int remembered = 12;      // changes that are mixed
constexpr int least_iterations = 10;
constexpr int roughly = 500;         // one state in so many changes: they are known so
constexpr double rounding = 1e-12;   // change, part of all forces

}  // namespace

bool ContactSplitting::factor(ContactProblem& problem, bool rough, const Contacts& contacts) {
  const auto& rows = problem.contacts.rows();
  std::vector<double> normal(rows.size(), 0), shear(rows.size(), 0);
  springs_.assign(rows.size(), {});
  for (size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].near) continue;
    const bool closed = contacts.closed[k], stuck = closed && contacts.stuck[k];
    normal[k] = rough ? rough_spring : closed ? stiff_spring : soft_spring;
    shear[k] = rough ? rough_spring : stuck ? stiff_spring : soft_spring;
    springs_[k] = {normal[k] * rows[k].kn, shear[k] * rows[k].ks};
  }
  return problem.factor_with(normal, shear) < 0;
}

void ContactSplitting::ask(const ContactProblem& problem, const Contacts& contacts, const Vector& d, Vector& asked) const {
  const auto& rows = problem.contacts.rows();
  const double f = problem.contacts.factor();
  const auto count = Eigen::Index(rows.size());
  asked.setZero(2 * count);
  for (size_t k = 0; k < rows.size(); ++k) {
    const ContactRows& row = rows[k];
    if (!row.near) continue;
    const double gap = row.gap0 + f * row.along(row.normal_i, row.normal_j, d);
    const double slide = row.slide0 + f * row.along(row.shear_i, row.shear_j, d);
    asked[Eigen::Index(k)] = contacts.normal[k] - springs_[k].normal * gap;
    asked[count + Eigen::Index(k)] = contacts.shear[k] + springs_[k].shear * slide;
  }
}

// The law at every copy, whose force N = max(0, asked - its spring's part), and so the force on the blocks: that of the copies,
// carried to the blocks by the springs. Returns how many states are others than before.
int ContactSplitting::answer(const ContactProblem& problem, Contacts contacts, Vector& force) const {
  const auto& rows = problem.contacts.rows();
  const auto count = Eigen::Index(rows.size());
  force = problem.system.force;
  int changed = 0;
  for (size_t k = 0; k < rows.size(); ++k) {
    const ContactRows& row = rows[k];
    if (!row.near) continue;
    const auto& [normal, shear] = springs_[k];
    const double asked = asked_[Eigen::Index(k)], asked_shear = asked_[count + Eigen::Index(k)];
    const double n = std::max(0.0, asked / (1 + normal / row.kn));
    const double limit = friction_limit(row, n), trial = asked_shear / (1 + shear / row.ks);
    const double t = std::clamp(trial, -limit, limit);
    const char closed = n > 0, stuck = t == trial;
    changed += contacts.closed[k] != closed || contacts.stuck[k] != stuck;
    contacts.closed[k] = closed;
    contacts.stuck[k] = stuck;
    contacts.normal[k] = n;
    contacts.shear[k] = t;
    // The copy lies at (n - asked) / spring, and the spring reaches from there to the contact at d = 0.
    row.add(row.normal_i, row.normal_j, 2 * n - asked - normal * row.gap0, force);
    row.add(row.shear_i, row.shear_j, -(2 * t - asked_shear + shear * row.slide0), force);
  }
  return changed;
}

ContactSplitting::Progress ContactSplitting::run(ContactProblem& problem, bool rough, int quiet, int most, Contacts contacts, Vector& d) {
  Progress progress;
  if (!(progress.factored = factor(problem, rough, contacts))) return progress;
  ask(problem, contacts, d, asked_);
  Mixing mixing(remembered);
  const int allowed = int(contacts.closed.size()) / roughly;
  int unchanged = 0;
  while (progress.iterations < most && !progress.settled) {
    const int changed = answer(problem, contacts, force_);
    if (progress.iterations == 0) {
      problem.solver.solve(force_, d);
    } else {
      solved_ -= force_;
      problem.solver.solve_coarsely(solved_, change_);
      d -= change_;
    }
    solved_ = force_;
    ask(problem, contacts, d, next_);
    next_ -= asked_;
    progress.change = next_.norm();
    asked_ = mixing.next(asked_, next_);
    ++progress.iterations;
    unchanged = changed <= (rough ? allowed : 0) ? unchanged + 1 : 0;
    progress.settled = (progress.iterations > least_iterations && unchanged >= quiet) ||
                       !(progress.change > rounding * asked_.norm());
  }
  return progress;
}

}  // namespace talus
