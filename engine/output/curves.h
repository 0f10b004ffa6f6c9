#pragma once
// What a run draws over its whole length: energy.svg, gas_pressure.svg and gas_volume.svg where charges go off,
// and load_displacement.svg where supports move.
#include <string>
#include <vector>

#include "output/record.h"
#include "step/simulation.h"

namespace talus {

// Names of the supports that move, as the scene has them at the start: those that a script moves later have no
// curve.
std::vector<std::string> moving_names(const Model& model, const Plan& plan);

// The load of a load–displacement curve. Entries of one name are one support.
struct MovingSupport {
  std::string name;
  Vec2 shift = Vec2::Zero(), reaction = Vec2::Zero();  // m, mean of its points; N/m on what it holds
};
std::vector<MovingSupport> moving_supports(Simulation& simulation, const std::vector<std::string>& names);

class Curves {
 public:
  void begin(const Simulation& simulation);
  void after_step(Simulation& simulation);
  void write(Simulation& simulation, const std::string& dir);  // with the state now
  void visit_state(StateVisitor& visitor);                     // the registry, model/registry.h

 private:
  template <class Add>
  void each(Simulation& simulation, Add add);
  std::vector<std::string> moving_;
  Record energies_, gas_, supports_;
};

// "press.y": the load against the way of a support, each along the axis, in the sense of its last displacement.
std::string draw_load_displacement(const Record& supports, const std::vector<MovingSupport>& now);

}  // namespace talus
