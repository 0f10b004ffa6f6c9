#pragma once
// Sleep of what rests. A group sleeps when its islands rest and stood still when the step began: such a step
// changes nothing, and no more would those that follow, so leaving the group out of search, assembly and solution
// gives the same places and forces to the last bit. A group is all that comes near each other; it wakes as one,
// when
// - the box of something that is awake, grown by its motion, meets that of one of its blocks, be it only as the step
// turns out,
// - a load, body force or support on one of its blocks asks for something else than in the last step,
// - gas presses on one of its blocks: as long as it does, the group stays awake,
// - the script changes anything (Model::changed).
#include "contact/box_grid.h"
#include "model/state_visitor.h"
#include "step/energies.h"
#include "step/island_solver.h"

namespace talus {

class Sleep {
 public:
  // Before an attempt at a step.
  void wake(Model& model, const Scheme& scheme);
  // Whether an attempt that leads to `moved` throws something at what sleeps, which the next wake() wakes then.
  bool struck(const Model& model, const std::vector<BlockState>& moved, const Scheme& scheme);
  // After an accepted step. near: pairs of blocks that came near each other in it.
  void fall_asleep(Model& model, const IslandSolver& islands, const std::vector<std::pair<int, int>>& near);
  int groups(const Model& model);            // that sleep
  const Asleep& stored(const Model& model);  // in them

  template <class Visitor>  // of the registry, model/registry.h
  void visit_state(Visitor& visitor) {
    visitor.growing("inputs", inputs_);
  }
  void restored() { seen_ = -1; }

 private:
  void wake_loaded(const Model& model, const Scheme& scheme, std::vector<char>& woken);
  void wake_near(const Model& model, double dt, std::vector<char>& woken);
  template <typename Visit>
  void each_group_in(const Box& box, const Model& model, Visit visit) const;
  void take_stock(const Model& model);

  std::vector<double> inputs_;  // of the last attempt: loads, body forces and supports, as they are read in a step
  long seen_ = -1;              // Model::sleep_changes the following belong to
  std::vector<int> sleepers_;
  std::vector<int> struck_;  // groups
  BoxGrid boxes_;            // of sleepers_
  int groups_ = 0;
  Asleep stored_;
};

}  // namespace talus
