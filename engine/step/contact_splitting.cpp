#include "step/contact_splitting.h"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

// Springs, part of a contact's own stiffness. Measured on walls of 100 to 2200 bricks whose waves cross 2 to 14 courses
// in a step: 0.03 to 0.3 take alike while states are unknown; 0.3 and 0.001 a third of the iterations of 0.1 once they
// are known.
constexpr double rough_spring = 0.1, stiff_spring = 0.3, soft_spring = 1e-3;
constexpr int remembered = 12;  // changes that are mixed
constexpr int least_iterations = 10;
constexpr int roughly = 500;        // one state in so many changes: they are known so
constexpr double rounding = 1e-12;  // change, part of all forces

}  // namespace

// The sums over a block's unknowns, of which most have six.
double ContactSplitting::Copy::along(const double* rows, const Vector& d) const {
  const auto sum = [&](const double* row, int dof, int size) {
    if (size == first_order_dofs)
      return Eigen::Map<const ColumnOf<first_order_dofs>>(row).dot(d.segment<first_order_dofs>(dof));
    double part = 0;
    for (int k = 0; k < size; ++k) part += row[k] * d[dof + k];
    return part;
  };
  return sum(rows, dof_i, size_i) + sum(rows + size_i, dof_j, size_j);
}

void ContactSplitting::Copy::add(const double* rows, double force, Vector& f) const {
  const auto put = [&](const double* row, int dof, int size) {
    if (size == first_order_dofs)
      f.segment<first_order_dofs>(dof) += force * Eigen::Map<const ColumnOf<first_order_dofs>>(row);
    else
      for (int k = 0; k < size; ++k) f[dof + k] += force * row[k];
  };
  put(rows, dof_i, size_i);
  put(rows + size_i, dof_j, size_j);
}

bool ContactSplitting::factor(ContactProblem& problem, bool rough, const Contacts& contacts) {
  const auto& rows = problem.contacts.rows();
  std::vector<double> normal(rows.size(), 0), shear(rows.size(), 0);
  copies_.clear();
  packed_.clear();
  for (size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].near) continue;
    const bool closed = contacts.closed[k], stuck = closed && contacts.stuck[k];
    normal[k] = rough ? rough_spring : closed ? stiff_spring : soft_spring;
    shear[k] = rough ? rough_spring : stuck ? stiff_spring : soft_spring;
    pack(rows[k], int(k), normal[k] * rows[k].kn, shear[k] * rows[k].ks);
  }
  return problem.factor_with(normal, shear) < 0;
}

void ContactSplitting::pack(const ContactRows& row, int number, double spring, double shear_spring) {
  copies_.push_back({row, number, spring, shear_spring, packed_.size()});
  const auto append = [&](const Row& of, int size) { packed_.insert(packed_.end(), of.begin(), of.begin() + size); };
  append(row.normal_i, row.size_i);
  append(row.normal_j, row.size_j);
  append(row.shear_i, row.size_i);
  append(row.shear_j, row.size_j);
}

void ContactSplitting::ask(const ContactProblem& problem, const Contacts& contacts, const Vector& d,
                           Vector& asked) const {
  const double f = problem.contacts.factor();
  const auto count = Eigen::Index(copies_.size());
  asked.resize(2 * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Copy& copy = copies_[size_t(k)];
    const double *of_gap = packed_.data() + copy.begin, *of_slide = of_gap + copy.size_i + copy.size_j;
    const double gap = copy.gap0 + f * copy.along(of_gap, d), slide = copy.slide0 + f * copy.along(of_slide, d);
    asked[k] = contacts.normal[size_t(copy.row)] - copy.spring * gap;
    asked[count + k] = contacts.shear[size_t(copy.row)] + copy.shear_spring * slide;
  }
}

// The law at every copy, whose force N = max(0, asked - its spring's part), and so the force on the blocks: that of the
// copies, carried to the blocks by the springs. Returns how many states are others than before.
int ContactSplitting::answer(const ContactProblem& problem, Contacts contacts, Vector& force) const {
  const auto count = Eigen::Index(copies_.size());
  force = problem.system.force;
  int changed = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Copy& copy = copies_[size_t(k)];
    const auto row = size_t(copy.row);
    const double asked = asked_[k], asked_shear = asked_[count + k];
    const double n = std::max(0.0, asked / (1 + copy.spring / copy.kn));
    const double limit = friction_limit(copy, n), trial = asked_shear / (1 + copy.shear_spring / copy.ks);
    const double t = std::clamp(trial, -limit, limit);
    const char closed = n > 0, stuck = t == trial;
    changed += contacts.closed[row] != closed || contacts.stuck[row] != stuck;
    contacts.closed[row] = closed;
    contacts.stuck[row] = stuck;
    contacts.normal[row] = n;
    contacts.shear[row] = t;
    // The copy lies at (n - asked) / spring, and the spring reaches from there to the contact at d = 0.
    const double *of_gap = packed_.data() + copy.begin, *of_slide = of_gap + copy.size_i + copy.size_j;
    copy.add(of_gap, 2 * n - asked - copy.spring * copy.gap0, force);
    copy.add(of_slide, -(2 * t - asked_shear + copy.shear_spring * copy.slide0), force);
  }
  return changed;
}

ContactSplitting::Progress ContactSplitting::run(ContactProblem& problem, bool rough, int quiet, int most,
                                                 Contacts contacts, Vector& d) {
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
    progress.settled =
        (progress.iterations > least_iterations && unchanged >= quiet) || !(progress.change > rounding * asked_.norm());
  }
  return progress;
}

}  // namespace talus
