#pragma once
// Bonds that fail: judged by their tractions, the most critical first, before the others are judged anew under the same
// load. What fails at once would else fail beside what it unloads: parallel cracks where there is one.
#include <optional>
#include <vector>

#include "equations/block_strain.h"
#include "fracture/crack_tracking.h"
#include "model/model.h"

namespace talus {

class Fracture {
 public:
  explicit Fracture(Model& model);

  // Utilisation of all bonds, from their stored tractions; the highest of them.
  double judge();
  bool any_due() const;
  // Those of the last judgement that fail now, in order of their numbers. In motion, where a load travels, a bond waits
  // only for bonds that share a node with it; in equilibrium for all. The model is as it was judged.
  std::vector<int> choose(bool motion);
  // They fail, with the tractions that they have, and join the events.
  // judged: Pa, the tractions they were judged by where these are not the present ones.
  void fail(const std::vector<int>& joints, double time, const std::vector<BondTraction>& judged = {});
  // What failed since the last clear_events() has the tractions again with which it failed: its faces take them over in
  // each search of the step.
  void recall_tractions();
  // A block goes on with this strain beside its own, as an initial stress.
  void add_strain(int block, const BlockStrain& strain);
  // An intact bond is not due until the events are cleared or healed.
  void hold_back(int joint) { held_back_.push_back(joint); }
  // Makes what failed since the last clear_events() whole again, and takes back the strains that were added.
  void heal();
  // Remaining strengths of what has failed, by the slips and openings there are.
  void weaken();

  // s, in which a P wave crosses the smallest block that has a bond.
  double least_transit() const;

  // Joints that failed since the last clear_events(): in this step.
  const std::vector<int>& events() const { return events_; }
  void clear_events() {
    events_.clear();
    before_strain_.clear();
    held_back_.clear();
  }
  void restored();  // the model has been put back

 private:
  std::vector<int> first_of_those_due(bool motion) const;
  bool waits(int joint) const;
  void weaken(Joint& joint, double normal);  // Pa

  Model& model_;
  std::vector<std::vector<int>> at_node_;  // bonds, by Model::nodes
  std::vector<int> breakable_, events_, held_back_;
  std::optional<CrackTracking> tracking_;
  struct Before {
    int block;
    Vec3 stress;  // Pa, and its gradients
    std::array<Vec3, 2> gradients;
    double energy;  // J/m, Model::added_strain_energy
  };
  std::vector<Before> before_strain_;
};

}  // namespace talus
