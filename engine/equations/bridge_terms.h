#pragma once
// What a failed bond still carries beside the contact of its faces, where its property softens: tension across it, and
// cohesion along it, both above the residual strength, each as a traction over the jump since it failed. Where it lies
// aslant of the path of its crack, across and along that path (Joint::path_turn).
//
// The law is extrinsic: the bridge begins with the traction that the bond failed with, up to its strength f, and loses
// strength with the jump beyond. Back from the worst jump, and up to it again, it is a line through the jump without
// traction. With x measured from that one, reach = f(0)/k and k the stiffness of the property's contacts,
//   traction = f(x - reach)                         where x goes beyond reach + worn,
//              f(worn) x/(reach + worn)             else; none for x < 0 across the joint.
// The tangent of the falling branch is negative; the sum with the blocks is positive while blocks are smaller than
// 2 E G/f² (fracture/reduction.h).
#include <algorithm>
#include <array>
#include <unordered_map>

#include "equations/system.h"

namespace talus {

struct Ends;

// In equilibrium; in motion: equations/bridge_motion.h.
class BridgeTerms {
 public:
  void find_slots(const Model& model, const BlockMatrix& matrix);
  void add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) const;
  // Tractions of bridged points at their stored jumps.
  void store_tractions(Model& model) const;
  // Of a search for equilibrium, in which the blocks may not be able to follow what falls. `share`: of the slopes of
  // falling branches, that goes into the matrix from the next add() on.
  void take(double share) { share_ = share; }
  // After a step of it: points that go to and fro between their line and the falling branch are taken along the line.
  void watch(const Model& model);
  void end_search() {
    turns_.clear();
    share_ = 1;
  }
  bool any() const { return !slots_.empty(); }  // at the last find_slots

 private:
  struct Slots {
    int joint;
    BlockMatrix::Slot aa, bb, ab;
  };
  template <int size>  // of the larger block's unknowns
  void add_bridge(const Model& model, const Poses& poses, const Ends& ends, const Scheme& scheme, const Slots& slots,
                  System& system) const;
  std::vector<Slots> slots_;
  double share_ = 1;
  struct Turns {
    std::array<int, 2> branch = {0, 0};                 // across, along
    std::array<int, 2> count = {0, 0}, quiet = {0, 0};  // of turns; steps since the last
  };
  double slope(const Turns& turns, int direction, double own, double line) const;
  std::unordered_map<int, std::array<Turns, JointPoints::most>> turns_;  // by joint
};

// Ends a search for equilibrium wherever it is left: the next takes slopes as they are.
class BridgeSearch {
 public:
  explicit BridgeSearch(BridgeTerms& bridges) : bridges_(bridges) {}
  ~BridgeSearch() { bridges_.end_search(); }
  BridgeSearch(const BridgeSearch&) = delete;
  BridgeSearch& operator=(const BridgeSearch&) = delete;

 private:
  BridgeTerms& bridges_;
};

// Of its bridge across and along the path to the point's in the joint's axes.
void store_bridge_traction(const Joint& joint, JointPoint& point);
// What the contact of a bridged joint's faces carries.
Strength contact_part(const Model& model, const Joint& joint);
// A joint that fails now is bridged, with the tractions stored at its points beyond what its contact takes over.
void begin_bridges(const Model& model, Joint& joint);
// The present jumps of a bridged joint become its worst; it is bridged no more when nothing is left.
void wear_bridges(const Model& model, Joint& joint);

// J/m, that comes back along the lines; of a point of a joint that is bridged.
double bridge_energy(const Joint& joint);
inline double bridge_energy(const JointPoint& point) {
  return point.weight / 2 *
         (point.across.traction * std::max(0.0, point.across.now) + point.along.traction * point.along.now);
}
// J/m that bridges took from where the joint was `then`: work of the mean traction along the jump.
double bridge_work(const Joint& now, const Joint& then);

}  // namespace talus
