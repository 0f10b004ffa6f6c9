#pragma once
// energy.svg: the ledger over time.
#include <string>
#include <vector>

#include "step/simulation.h"

namespace talus {

// Samples of a run of any length: every step at first, then every second, fourth, … one, so that there are never
// many.
class EnergyRecord {
 public:
  void after_step(const Simulation& simulation);
  void last(const Simulation& simulation);  // the state now, whether its turn has come or not
  std::string draw(const Plan& plan) const;
  void visit_state(StateVisitor& visitor);  // the registry, model/registry.h

  size_t size() const { return times_.size(); }

 private:
  void add(const Simulation& simulation);
  std::vector<double> times_;
  std::vector<Energies> samples_;
  long stride_ = 1, step_ = -1;
};

}  // namespace talus
