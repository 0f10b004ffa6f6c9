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
    const bool first = last_.size() == 0, lost = !first && change.squaredNorm() > 4 * last_change_.squaredNorm();
    if (lost) differences_.clear();  // what was learnt no longer holds
    Vector along(Eigen::Index(differences_.size()));
    for (Eigen::Index a = 0; a < along.size(); ++a) along[a] = differences_[size_t(a)].change.dot(change);
    if (!first && !lost) remember(from, change, along);
    last_ = from;
    last_change_ = change;
    along_ = along;
    Vector x = from + change;
    const auto count = along.size();
    if (count == 0) return x;
    Eigen::MatrixXd products = products_.topLeftCorner(count, count);
    products.diagonal() *= 1 + 1e-10;  // changes that repeat each other leave it singular
    const Vector weights = products.ldlt().solve(along);
    for (Eigen::Index a = 0; a < count; ++a) x -= weights[a] * differences_[size_t(a)].reached;
    return x;
  }

 private:
  struct Difference {  // between two points that followed each other
    Vector change, reached;  // reached: of where they were moved to
  };

  // `along`: the products of the differences with `change`, from which and from those with the last change come those with the new
  // difference. It gets one more.
  void remember(const Vector& from, const Vector& change, Vector& along) {
    Vector with_new = along - along_;
    if (int(differences_.size()) == memory_) {
      differences_.pop_front();
      const Eigen::MatrixXd kept = products_.bottomRightCorner(memory_ - 1, memory_ - 1);
      products_.topLeftCorner(memory_ - 1, memory_ - 1) = kept;
      along = Vector(along.tail(memory_ - 1));
      with_new = Vector(with_new.tail(memory_ - 1));
    }
    const Eigen::Index own = along.size();
    differences_.push_back({change - last_change_, from - last_ + change - last_change_});
    const Vector& latest = differences_.back().change;
    products_.col(own).head(own) = with_new;
    products_.row(own).head(own) = with_new;
    products_(own, own) = latest.squaredNorm();
    along.conservativeResize(own + 1);
    along[own] = latest.dot(change);
  }

  int memory_;
  std::deque<Difference> differences_;
  Eigen::MatrixXd products_;  // of the changes with each other
  Vector last_, last_change_, along_;  // along_: products of the differences with last_change_
};

}  // namespace talus
