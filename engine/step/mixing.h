#pragma once
// Anderson's mixing (Anderson 1965; Walker & Ni 2011) of a fixed-point iteration x -> x + change(x): the next x is where the last
// few changes, taken for linear, would cancel.
#include <Eigen/Cholesky>
#include <deque>

#include "equations/block_matrix.h"

namespace talus {

class Mixing {
 public:
  explicit Mixing(int memory = 8) : memory_(memory), products_(memory, memory) {}  // changes that are mixed

  // The point to go on from, after `from` was moved by `change`.
  Vector next(const Vector& from, const Vector& change) {
    if (last_.size() > 0 && change.squaredNorm() > 4 * last_change_.squaredNorm())
      differences_.clear();  // what was learnt no longer holds
    else if (last_.size() > 0)
      remember(from, change);
    last_ = from;
    last_change_ = change;
    Vector x = from + change;
    const auto count = Eigen::Index(differences_.size());
    if (count == 0) return x;
    Vector right(count);
    for (Eigen::Index a = 0; a < count; ++a) right[a] = differences_[size_t(a)].change.dot(change);
    Eigen::MatrixXd products = products_.topLeftCorner(count, count);
    products.diagonal() *= 1 + 1e-10;  // changes that repeat each other leave it singular
    const Vector weights = products.ldlt().solve(right);
    for (Eigen::Index a = 0; a < count; ++a) x -= weights[a] * differences_[size_t(a)].reached;
    return x;
  }

 private:
  struct Difference {  // between two points that followed each other
    Vector change, reached;  // reached: of where they were moved to
  };

  void remember(const Vector& from, const Vector& change) {
    if (int(differences_.size()) == memory_) {
      differences_.pop_front();
      const Eigen::MatrixXd kept = products_.bottomRightCorner(memory_ - 1, memory_ - 1);
      products_.topLeftCorner(memory_ - 1, memory_ - 1) = kept;
    }
    differences_.push_back({change - last_change_, from - last_ + change - last_change_});
    const auto own = Eigen::Index(differences_.size()) - 1;
    for (Eigen::Index a = 0; a <= own; ++a)
      products_(a, own) = products_(own, a) = differences_[size_t(a)].change.dot(differences_.back().change);
  }

  int memory_;
  std::deque<Difference> differences_;
  Eigen::MatrixXd products_;  // of the changes with each other
  Vector last_, last_change_;
};

}  // namespace talus
