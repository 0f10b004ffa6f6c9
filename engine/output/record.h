#pragma once
// Numbers over a run of any length, for a picture: every step at first, then every second, fourth, … one, so that
// there are never many.
#include <functional>
#include <vector>

#include "model/state_visitor.h"

namespace talus {

class Record {
 public:
  // the numbers now, always as many; asked for when their turn has come
  using Row = std::function<std::vector<double>()>;
  void after_step(long step, double time, const Row& row);
  void last(long step, double time, const Row& row);  // the state now, whether its turn has come or not

  const std::vector<double>& times() const { return times_; }
  std::vector<double> column(size_t k) const;
  size_t size() const { return times_.size(); }
  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h

 private:
  void add(long step, double time, const Row& row);
  std::vector<double> times_, values_;  // row after row
  long stride_ = 1, step_ = -1;
};

}  // namespace talus
