// Sweeps of nonlinear Gauss–Seidel over contacts in forces (Moreau 1988, Jean 1999), in pairs forwards and
// backwards: plain, and with two ways of going on between the pairs, Nesterov's momentum with restarts (O'Donoghue
// & Candès 2015) and Anderson's mixing.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "forces.h"

namespace talus::study {

namespace {

constexpr int judged_every = 10;  // pairs
constexpr int memory = 8;         // of Anderson's mixing
constexpr int least_run = 5;      // pairs before growth of the change restarts the momentum

Vector stacked(const Forces& forces) {
  const size_t count = forces.normal.size();
  Vector x(2 * count);
  for (size_t k = 0; k < count; ++k) {
    x[k] = forces.normal[k];
    x[count + k] = forces.shear[k];
  }
  return x;
}

// Forces x, cut to what contacts can carry. `opened`: what the sweeps have opened stays open.
void take(const Desk& desk, const Vector& x, bool opened, Forces& forces) {
  const size_t count = desk.count();
  for (size_t k = 0; k < count; ++k) {
    forces.normal[k] = opened && forces.normal[k] == 0 ? 0 : std::max(0.0, x[k]);
    const double limit = Desk::limit(desk.row(k), forces.normal[k]);
    forces.shear[k] = std::clamp(x[count + k], -limit, limit);
  }
  forces.rebuild();
}

// Goes on from x, which the sweeps have made of `from`.
struct Plain {
  void operator()(const Desk&, const Vector&, const Vector&, Forces&) {}
};

struct Nesterov {
  Vector last;
  double theta = 1, before = 0;
  int since = 0;

  void operator()(const Desk& desk, const Vector& from, const Vector& x, Forces& forces) {
    if (last.size() == 0) last = from;
    const double next = (1 + std::sqrt(1 + 4 * theta * theta)) / 2, change = (x - from).norm();
    double momentum = (theta - 1) / next;
    theta = next;
    ++since;
    if ((from - x).dot(x - last) > 0 || (change > before && since > least_run)) {
      theta = 1;
      momentum = 0;
      since = 0;
    }
    before = change;
    if (momentum > 0) take(desk, x + momentum * (x - last), false, forces);
    last = x;
  }
};

struct Anderson {
  std::vector<Vector> moves, changes;  // differences of x and of its change
  Vector last_from, last_change;

  void operator()(const Desk& desk, const Vector& from, const Vector& x, Forces& forces) {
    const Vector change = x - from;
    if (last_change.size() > 0 && change.norm() > 2 * last_change.norm()) {
      moves.clear();
      changes.clear();
    } else if (last_change.size() > 0) {
      moves.push_back(from - last_from);
      changes.push_back(change - last_change);
      if (moves.size() > memory) {
        moves.erase(moves.begin());
        changes.erase(changes.begin());
      }
    }
    last_from = from;
    last_change = change;
    const int m = int(moves.size());
    if (m == 0) return;
    Eigen::MatrixXd gram(m, m);
    Vector rhs(m);
    for (int a = 0; a < m; ++a) {
      rhs[a] = changes[a].dot(change);
      for (int b = 0; b < m; ++b) gram(a, b) = changes[a].dot(changes[b]) * (a == b ? 1 + 1e-10 : 1);
    }
    const Vector weights = gram.ldlt().solve(rhs);
    Vector mixed = x;
    for (int a = 0; a < m; ++a) mixed -= weights[a] * (moves[a] + changes[a]);
    take(desk, mixed, true, forces);
  }
};

template <class GoOn>
void sweeps(Desk& desk, GoOn go_on) {
  Forces forces(desk);
  for (int pair = 0; !desk.spent(); ++pair) {
    const Vector from = stacked(forces);
    forces.sweep(false);
    forces.sweep(true);
    desk.outcome.sweeps += 2;
    if (pair % judged_every == judged_every - 1) {
      forces.rebuild();
      desk.judge(forces.motion());
      if (desk.done()) return;
    }
    go_on(desk, from, stacked(forces), forces);
  }
}

}  // namespace

void plain_sweeps(Desk& desk) {
  sweeps(desk, Plain{});
}
void nesterov_sweeps(Desk& desk) {
  sweeps(desk, Nesterov{});
}
void anderson_sweeps(Desk& desk) {
  sweeps(desk, Anderson{});
}

}  // namespace talus::study
