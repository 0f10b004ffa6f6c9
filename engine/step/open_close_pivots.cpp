// Newton's steps of open–close with the states that pivots find, where few of the last ones are contradicted.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "step/contact_pivots.h"
#include "step/open_close.h"

namespace talus {

namespace {

// Measured on the pile of a cast blast, 2362 blocks: with 60 to 100 contacts at a time and six tries a third dearer.
constexpr int tries = 4;  // sets of states that pivots find
// contradicted at first: more than these, and one pressed contact in so many, are too many
constexpr int least_many = 24, many_part = 70;
constexpr int growth = 3;  // times as many, with those that join them
// Newton's steps where states are right: each takes a hundredth of the residual
constexpr int most_corrections = 4;
constexpr double least_gain = 0.1;  // a step that leaves more of it does not get on
constexpr double slack = 1e-9;      // of a friction limit, which equality with is no contradiction

SparseColumn column(const ContactRows& row, const Row& of_i, const Row& of_j) {
  SparseColumn column;
  const auto append = [&](const Row& of, int dof, int size) {
    for (int k = 0; k < size; ++k) {
      column.unknowns.push_back(dof + k);
      column.values.push_back(of[size_t(k)]);
    }
  };
  append(of_i, row.dof_i, row.size_i);
  append(of_j, row.dof_j, row.size_j);
  return column;
}

bool bounded(const ContactRows& row) {
  return std::isfinite(row.friction) && std::isfinite(row.cohesion);
}

}  // namespace

// The contacts whose states are sought; the others keep the factored ones.
struct OpenClose::Chosen {
  std::vector<int> rows;
  std::vector<char> is_one;  // per contact of the problem
  std::vector<PivotContact> contacts;
  bool can_be = true;  // found by pivots, for which friction has to have a bound
};

// Whether the present d contradicts the state that is aimed at for the contact.
bool OpenClose::contradicted(const ContactProblem& problem, size_t k) const {
  const ContactRows& row = problem.contacts.rows()[k];
  if (!row.near) return false;
  if (closed_[k] != aimed_closed_[k]) return true;
  const double limit = friction_limit(row, normal_force(row, k)), shear = row.ks * slide_[k];
  if (limit == 0) return false;
  return aimed_stuck_[k] ? std::abs(shear) > limit * (1 + slack)
                         : std::copysign(1, shear_[k]) * shear < limit * (1 - slack);
}

int OpenClose::contradictions(const ContactProblem& problem) const {
  int count = 0;
  for (size_t k = 0; k < closed_.size(); ++k) count += contradicted(problem, k);
  return count;
}

// Newton's steps where states are right, as long as they get on: what pivots have let go or caught, a thousand times
// stiffer than what is around, may be too much for solves in single precision with the factor of before.
void OpenClose::correct(ContactProblem& problem, double tolerance, Vector& d, OpenCloseResult& result) {
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_corrections && result.residual > tolerance && result.residual < least_gain * before;
       ++step) {
    before = result.residual;
    full_step(problem, d, result);
  }
}

// After predict(). Where it does not lead on, d is left where it was.
void OpenClose::follow_pivots(ContactProblem& problem, double tolerance, Vector& d, OpenCloseResult& result) {
  const int closed = int(std::count(closed_.begin(), closed_.end(), 1)),
            many = std::max(least_many, closed / many_part);
  Chosen chosen;
  pivoted_.reset();
  for (int k = 0; result.residual > tolerance; ++k) {
    int wrong = contradictions(problem);
    if (wrong == 0) {
      correct(problem, tolerance, d, result);
      wrong = contradictions(problem);
      if (wrong == 0 && result.residual > tolerance &&
          (aimed_closed_ != factored_closed_ || aimed_stuck_ != factored_stuck_)) {
        closed_ = aimed_closed_;
        stuck_ = aimed_stuck_;
        if (!factor(problem, result)) return;
        ++result.iterations;
        predict(problem, d, result);
        continue;
      }
    }
    if (wrong == 0 || wrong > many || k >= tries) return;
    const Vector before = d;
    const std::vector<double> shear = shear_;
    if (!find_states(problem, growth * many, chosen, d)) {
      shear_ = shear;
      d = before;
      return go_to(problem, d, result);
    }
    ++result.pivots;
    follow_friction(problem, d);
    go_to(problem, d, result);
  }
}

// States to aim at: of the contradicted contacts by pivots, all others as they are. What the outcome contradicts joins
// them, until there is none. Friction that slips elsewhere is frozen meanwhile; where it then follows and contradicts
// them, it is sought with them the next time. Whether pivots end, with at most so many.
bool OpenClose::find_states(ContactProblem& problem, int most, Chosen& chosen, Vector& d) {
  const auto& rows = problem.contacts.rows();
  const bool again = !chosen.rows.empty();
  for (size_t k = 0; k < rows.size(); ++k)
    if (!aimed_stuck_[k]) shear_[k] = std::copysign(friction_limit(rows[k], normal_force(rows[k], k)), shear_[k]);
  for (size_t c = 0; c < chosen.rows.size(); ++c) {
    const auto k = size_t(chosen.rows[c]);
    chosen.contacts[c].closed = closed_[k];
    chosen.contacts[c].stuck = aimed_stuck_[k];
    chosen.contacts[c].shear = shear_[k];
  }
  const auto choose_contradicted = [&] {
    const size_t before = chosen.rows.size();
    for (size_t k = 0; k < rows.size(); ++k)
      if (contradicted(problem, k)) choose(problem, k, chosen);
    return chosen.rows.size() > before;
  };
  chosen.is_one.resize(rows.size(), 0);
  choose_contradicted();
  if (again) choose_slipping_beside(problem, chosen);
  do {
    if (!chosen.can_be || chosen.rows.size() > size_t(most) || !pivot(problem, chosen, d)) return false;
    evaluate(problem, d);
  } while (choose_contradicted());
  if (!chosen.can_be) return false;
  for (size_t c = 0; c < chosen.rows.size(); ++c) {
    const auto k = size_t(chosen.rows[c]);
    shear_[k] = chosen.contacts[c].shear;
    aimed_closed_[k] = chosen.contacts[c].closed;
    aimed_stuck_[k] = chosen.contacts[c].stuck;
  }
  return true;
}

void OpenClose::choose(const ContactProblem& problem, size_t k, Chosen& chosen) const {
  const ContactRows& row = problem.contacts.rows()[k];
  if (chosen.is_one[k]) return;
  chosen.can_be = chosen.can_be && bounded(row);
  chosen.is_one[k] = 1;
  chosen.rows.push_back(int(k));
  chosen.contacts.push_back({.gap0 = 0,
                             .slide0 = 0,
                             .kn = row.kn,
                             .ks = row.ks,
                             .friction = row.friction,
                             .cohesion = row.cohesion,
                             .closed = bool(closed_[k]),
                             .stuck = bool(aimed_stuck_[k]),
                             .normal = 0,
                             .shear = shear_[k]});
}

void OpenClose::choose_slipping_beside(const ContactProblem& problem, Chosen& chosen) const {
  const auto& rows = problem.contacts.rows();
  std::vector<char> touched(problem.blocks.size(), 0);
  for (const int k : chosen.rows)
    for (const int block : {rows[size_t(k)].i, rows[size_t(k)].j})
      if (problem.dofs[size_t(block)] > 0) touched[size_t(block)] = 1;
  for (size_t k = 0; k < rows.size(); ++k)
    if (closed_[k] && !aimed_stuck_[k] && bounded(rows[k]) &&
        (touched[size_t(rows[k].i)] || touched[size_t(rows[k].j)]))
      choose(problem, k, chosen);
}

// The forces of the chosen contacts that meet their law, and d with them.
bool OpenClose::pivot(ContactProblem& problem, Chosen& chosen, Vector& d) {
  const auto& rows = problem.contacts.rows();
  const double f = problem.contacts.factor();
  r_ = problem.system.force;
  for (size_t k = 0; k < rows.size(); ++k) {
    const ContactRows& row = rows[k];
    if (factored_closed_[k]) row.add(row.normal_i, row.normal_j, -row.kn * row.gap0, r_);
    const double shear = factored_stuck_[k] ? row.ks * row.slide0 : chosen.is_one[k] ? 0 : shear_[k];
    row.add(row.shear_i, row.shear_j, -shear, r_);
  }
  problem.solver.solve(r_, d);

  const auto count = Eigen::Index(chosen.rows.size());
  if (!pivoted_) pivoted_.emplace(std::vector<int>(rows.size(), -1), problem.solver.compliance());
  std::vector<SparseColumn> columns;          // of those that joined
  Vector held(2 * count), spring(2 * count);  // m, gap and slide; N/m: as factored
  for (Eigen::Index c = 0; c < count; ++c) {
    const auto k = size_t(chosen.rows[size_t(c)]);
    const ContactRows& row = rows[k];
    if (int& place = pivoted_->place[k]; place < 0) {
      place = int(c);
      columns.push_back(column(row, row.normal_i, row.normal_j));
      columns.push_back(column(row, row.shear_i, row.shear_j));
    }
    held[2 * c] = problem.contacts.gap(row, d);
    held[2 * c + 1] = problem.contacts.slide(row, d);
    spring[2 * c] = factored_closed_[k] ? row.kn : 0;
    spring[2 * c + 1] = factored_stuck_[k] ? row.ks : 0;
  }
  // The factor has springs D in the contacts' place: x = held + W (F + D x) under forces F of their own.
  pivoted_->compliance.add(columns);
  const Eigen::MatrixXd with_springs = f * pivoted_->compliance.matrix();
  Eigen::MatrixXd without = -with_springs * spring.asDiagonal();
  without.diagonal().array() += 1;
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(without);
  const Eigen::MatrixXd w = lu.solve(with_springs);
  const Vector free = lu.solve(held);
  for (Eigen::Index c = 0; c < count; ++c) {
    chosen.contacts[size_t(c)].gap0 = free[2 * c];
    chosen.contacts[size_t(c)].slide0 = free[2 * c + 1];
  }
  if (!pivot_contacts(chosen.contacts, w)) return false;
  Vector forces(2 * count);
  for (Eigen::Index c = 0; c < count; ++c) {
    forces[2 * c] = chosen.contacts[size_t(c)].normal;
    forces[2 * c + 1] = -chosen.contacts[size_t(c)].shear;
  }
  const Vector more = forces + spring.cwiseProduct(free + w * forces);
  for (Eigen::Index c = 0; c < count; ++c) {
    const ContactRows& row = rows[size_t(chosen.rows[size_t(c)])];
    row.add(row.normal_i, row.normal_j, more[2 * c], r_);
    row.add(row.shear_i, row.shear_j, more[2 * c + 1], r_);
  }
  problem.solver.solve(r_, d);
  return d.allFinite();
}

}  // namespace talus
