#pragma once
// What a failed bond still carries beside the contact of its faces, where its property softens: tension across it, and
// cohesion along it, both above the residual strength, each as a traction over the jump since it failed.
//
// The law is extrinsic: the bridge begins with the traction that the bond failed with, up to its strength f, and loses
// strength with the jump beyond. Back from the worst jump, and up to it again, it is a line through the jump without
// traction. With x measured from that one, reach = f(0)/k and k the stiffness of the property's contacts,
//   traction = f(x - reach)                         where x goes beyond reach + worn,
//              f(worn) x/(reach + worn)             else; none for x < 0 across the joint.
// The tangent of the falling branch is negative; the sum with the blocks is positive while blocks are smaller than
// 2 E G/f² (fracture/reduction.h).
#include "equations/system.h"

namespace talus {

struct Ends;

class BridgeTerms {
 public:
  void find_slots(const Model& model, const BlockMatrix& matrix);
  void add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) const;
  // Tractions of bridged points at their stored jumps.
  void store_tractions(Model& model) const;
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
};

// A joint that fails now is bridged, with the tractions stored at its points beyond what its contact takes over.
void begin_bridges(const Model& model, Joint& joint);
// The present jumps of a bridged joint become its worst; it is bridged no more when nothing is left.
void wear_bridges(const Model& model, Joint& joint);

double bridge_energy(const Joint& joint);  // J/m, that comes back along the lines
// J/m that bridges took from where the joint was `then`: work of the mean traction along the jump.
double bridge_work(const Joint& now, const Joint& then);

}  // namespace talus
