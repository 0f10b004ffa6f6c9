#include "step/contact_pivots.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

using Contacts = std::vector<PivotContact>;
using Eigen::Index;

constexpr int most_newton = 8;         // two sets in three settle within
constexpr double least_pivot = 1e-10;  // of unknowns that are near one
constexpr double same = 1e-13;         // ratios that rounding may part
constexpr int most_pivots = 8;         // times the unknowns: it takes a half of them

double limit_of(const PivotContact& contact, double normal) {
  return contact.friction * std::max(0.0, normal) + contact.cohesion;
}

// (N, -T) of all contacts with the states they have.
Eigen::VectorXd forces_with_states(const Contacts& contacts, const Eigen::MatrixXd& w) {
  const auto count = Index(contacts.size());
  Eigen::MatrixXd m(2 * count, 2 * count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * count);
  for (Index a = 0; a < count; ++a) {
    const PivotContact& own = contacts[size_t(a)];
    const Index n = 2 * a, t = n + 1;
    if (own.closed) {
      m.row(n) = w.row(n);
      right[n] = -own.gap0;
    } else {
      m.row(n).setZero();
    }
    m(n, n) += 1 / own.kn;
    if (own.stuck) {
      m.row(t) = w.row(t);
      right[t] = -own.slide0;
    } else {
      const double way = std::copysign(1, own.shear);
      m.row(t).setZero();
      m(t, n) = way * own.friction / own.ks;
      right[t] = -way * own.cohesion / own.ks;
    }
    m(t, t) += 1 / own.ks;
  }
  return m.partialPivLu().solve(right);
}

// Newton's whole steps on the states: whether they settle.
bool newton(Contacts& contacts, const Eigen::MatrixXd& w) {
  bool changed = true;
  for (int steps = 0; changed && steps < most_newton; ++steps) {
    const Eigen::VectorXd forces = forces_with_states(contacts, w), moved = w * forces;
    changed = false;
    for (size_t a = 0; a < contacts.size(); ++a) {
      PivotContact& own = contacts[a];
      const auto n = Index(2 * a), t = n + 1;
      const bool closed = own.closed ? forces[n] > 0 : own.gap0 + moved[n] < 0;
      const double shear = -forces[t], slide = own.slide0 + moved[t];
      const bool stuck = own.stuck ? std::abs(shear) <= (1 + 1e-9) * limit_of(own, forces[n])
                                   : std::copysign(1, own.shear) * (slide - shear / own.ks) < 0;
      changed = changed || closed != own.closed || stuck != own.stuck;
      // the way stays, also where N is below nought meanwhile
      own.shear = own.stuck ? shear : std::copysign(shear, own.shear);
      own.normal = forces[n];
      own.closed = closed;
      own.stuck = stuck;
    }
  }
  return !changed;
}

// w = M z + q, w ≥ 0, z ≥ 0, wᵀz = 0 by Lemke's complementary pivots. What is in the basis has a row; what is not, a
// column.
class Lemke {
 public:
  Lemke(const Eigen::MatrixXd& m, const Eigen::VectorXd& q) : count_(int(q.size())), table_(count_, count_ + 2) {
    table_.leftCols(count_) = -m;
    table_.col(count_).setConstant(-1);  // of z0, which covers what is below nought
    table_.col(count_ + 1) = q;
    for (int k = 0; k < count_; ++k) {
      rows_.push_back(k);              // w
      columns_.push_back(count_ + k);  // z
    }
    columns_.push_back(2 * count_);
  }

  bool solve() {
    int row = 0, column = count_;
    if (!(table_.col(count_ + 1).minCoeff(&row) < 0)) return true;
    for (int pivots = 0; row >= 0 && pivots < most_pivots * count_; ++pivots) {
      exchange(row, column);
      const int left = columns_[size_t(column)];
      if (left == 2 * count_) return true;
      const int partner = left < count_ ? left + count_ : left - count_;
      column = int(std::find(columns_.begin(), columns_.end(), partner) - columns_.begin());
      row = leaving(column);
    }
    return false;
  }

  Eigen::VectorXd z() const {
    Eigen::VectorXd z = Eigen::VectorXd::Zero(count_);
    for (int k = 0; k < count_; ++k)
      if (const int own = rows_[size_t(k)]; own >= count_ && own < 2 * count_) z[own - count_] = table_(k, count_ + 1);
    return z;
  }

 private:
  // The row that comes to nought first when the column's unknown grows; that of z0 where it is among them.
  int leaving(int column) const {
    double least = std::numeric_limits<double>::infinity();
    int row = -1;
    for (int k = 0; k < count_; ++k) {
      if (table_(k, column) <= least_pivot) continue;
      const double ratio = table_(k, count_ + 1) / table_(k, column);
      if (ratio < least - same || (ratio < least + same && rows_[size_t(k)] == 2 * count_)) {
        least = ratio;
        row = k;
      }
    }
    return row;
  }

  void exchange(int row, int column) {
    const double pivot = table_(row, column);
    table_.row(row) /= pivot;
    table_(row, column) = 1 / pivot;
    const Eigen::RowVectorXd pivoted = table_.row(row);
    for (int k = 0; k < count_; ++k) {
      const double part = table_(k, column);
      if (k == row || part == 0) continue;
      table_(k, column) = 0;
      table_.row(k) -= part * pivoted;
    }
    std::swap(rows_[size_t(row)], columns_[size_t(column)]);
  }

  int count_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> table_;
  std::vector<int> rows_, columns_;  // w: 0 …, z: count_ …, z0: 2 count_
};

// Per contact z = (N, l⁺, s⁻) and w = (gap + N/kn, s⁺, l⁻): l⁺ and l⁻ are what T is below the limit and above its
// negative, s⁺ and s⁻ how far it slides either way. T = N tan φ + c - l⁺, l⁺ + l⁻ = 2 (N tan φ + c), slide - T/ks = s⁺
// - s⁻.
bool lemke(Contacts& contacts, const Eigen::MatrixXd& w) {
  const auto count = Index(contacts.size());
  const double unit = w.diagonal().mean();  // m/N; forces are counted in what moves by a metre
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  Eigen::VectorXd q(3 * count);
  for (Index a = 0; a < count; ++a) {
    const PivotContact& own = contacts[size_t(a)];
    q.segment<3>(3 * a) << own.gap0, own.slide0, 2 * own.cohesion * unit;
    for (Index b = 0; b < count; ++b) {
      const PivotContact& other = contacts[size_t(b)];
      Eigen::Matrix2d part = w.block<2, 2>(2 * a, 2 * b) / unit;
      if (a == b) part.diagonal() += Eigen::Vector2d(1 / own.kn, 1 / own.ks) / unit;
      m.block<2, 1>(3 * a, 3 * b) = part.col(0) - other.friction * part.col(1);
      m.block<2, 1>(3 * a, 3 * b + 1) = part.col(1);
      q.segment<2>(3 * a) -= part.col(1) * (other.cohesion * unit);
    }
    m(3 * a + 1, 3 * a + 2) = 1;
    m(3 * a + 2, 3 * a) = 2 * own.friction;
    m(3 * a + 2, 3 * a + 1) = -1;
  }
  const double size = q.lpNorm<Eigen::Infinity>();  // m
  if (!(size > 0) || !std::isfinite(size)) return false;
  Lemke problem(m, q / size);
  if (!problem.solve()) return false;
  const Eigen::VectorXd z = problem.z() * (size / unit);
  for (Index a = 0; a < count; ++a) {
    PivotContact& own = contacts[size_t(a)];
    const double limit = limit_of(own, z[3 * a]);
    own.normal = z[3 * a];
    own.shear = limit - z[3 * a + 1];
    own.closed = own.normal > 0;
    own.stuck = z[3 * a + 1] > 0 && own.shear > -limit;
  }
  return true;
}

}  // namespace

bool pivot_contacts(Contacts& contacts, const Eigen::MatrixXd& w) {
  return newton(contacts, w) || lemke(contacts, w);
}

}  // namespace talus
