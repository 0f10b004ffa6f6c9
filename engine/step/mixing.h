#pragma once
// Anderson's mixing (Anderson 1965; Walker & Ni 2011) of a fixed-point iteration x -> x + change(x): the next x is
// where the last few changes, taken for linear, would cancel.
#include <Eigen/Cholesky>
#include <vector>

#include "equations/block_matrix.h"

namespace talus {

class Mixing {
 public:
  // changes that are mixed
  explicit Mixing(int memory = 8) : memory_(memory), differences_(size_t(memory)), products_(memory, memory) {}

  // The point to go on from, after `from` was moved by `change`.
  const Vector& next(const Vector& from, const Vector& change) {
    const bool first = last_.size() == 0, lost = !first && change.squaredNorm() > 4 * last_change_.squaredNorm();
    if (lost) count_ = 0;  // what was learnt no longer holds
    Vector along(count_);
    for (int a = 0; a < count_; ++a) along[a] = difference(a).change.dot(change);
    if (!first && !lost) remember(from, change, along);
    last_ = from;
    last_change_ = change;
    along_ = along;
    x_ = from + change;
    if (count_ == 0) return x_;
    Eigen::MatrixXd products = products_.topLeftCorner(count_, count_);
    products.diagonal() *= 1 + 1e-10;  // changes that repeat each other leave it singular
    const Vector weights = products.ldlt().solve(along);
    for (int a = 0; a < count_; ++a) x_ -= weights[a] * difference(a).reached;
    return x_;
  }

 private:
  struct Difference {        // between two points that followed each other
    Vector change, reached;  // reached: of where they were moved to
  };
  Difference& difference(int a) { return differences_[size_t((oldest_ + a) % memory_)]; }

  // `along`: the products of the differences with `change`, from which and from those with the last change come those
  // with the new difference. It gets one more.
  void remember(const Vector& from, const Vector& change, Vector& along) {
    Vector with_new = along - along_;
    if (count_ == memory_) {
      oldest_ = (oldest_ + 1) % memory_;
      --count_;
      const Eigen::MatrixXd kept = products_.bottomRightCorner(count_, count_);
      products_.topLeftCorner(count_, count_) = kept;
      along = Vector(along.tail(count_));
      with_new = Vector(with_new.tail(count_));
    }
    const int own = count_++;
    Difference& latest = difference(own);
    latest.change = change - last_change_;
    latest.reached = from - last_ + latest.change;
    products_.col(own).head(own) = with_new;
    products_.row(own).head(own) = with_new;
    products_(own, own) = latest.change.squaredNorm();
    along.conservativeResize(own + 1);
    along[own] = latest.change.dot(change);
  }

  int memory_, count_ = 0, oldest_ = 0;  // of the ring of differences
  std::vector<Difference> differences_;
  Eigen::MatrixXd products_;               // of the changes with each other
  Vector last_, last_change_, along_, x_;  // along_: products of the differences with last_change_
};

}  // namespace talus
