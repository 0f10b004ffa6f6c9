#pragma once
// Anderson's mixing (Anderson 1965; Walker & Ni 2011) of a fixed-point iteration x -> x + change(x): the next x is where the last
// few changes, taken for linear, would cancel.
#include <Eigen/Cholesky>
#include <deque>

#include "equations/block_matrix.h"

namespace talus {

class Mixing {
 public:
  // The point to go on from, after `from` was moved by `change`.
  Vector next(const Vector& from, const Vector& change) {
    if (last_.size() > 0 && change.norm() > 2 * last_change_.norm()) {
      moves_.clear();  // what was learnt no longer holds
      changes_.clear();
    } else if (last_.size() > 0) {
      moves_.push_back(from - last_);
      changes_.push_back(change - last_change_);
      if (moves_.size() > memory) {
        moves_.pop_front();
        changes_.pop_front();
      }
    }
    last_ = from;
    last_change_ = change;
    const int count = int(moves_.size());
    Eigen::MatrixXd products(count, count);
    Vector right(count);
    for (int a = 0; a < count; ++a) {
      right[a] = changes_[a].dot(change);
      for (int b = 0; b <= a; ++b) products(a, b) = products(b, a) = changes_[a].dot(changes_[b]);
      products(a, a) *= 1 + 1e-10;  // changes that repeat each other leave it singular
    }
    Vector x = from + change;
    if (count == 0) return x;
    const Vector weights = products.ldlt().solve(right);
    for (int a = 0; a < count; ++a) x -= weights[a] * (moves_[a] + changes_[a]);
    return x;
  }

 private:
  static constexpr size_t memory = 8;
  std::deque<Vector> moves_, changes_;
  Vector last_, last_change_;
};

}  // namespace talus
