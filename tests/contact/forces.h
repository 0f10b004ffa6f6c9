#pragma once
// Contact forces as the unknowns: blocks that no bond joins move by their own inertia and stiffness under them.
#include "problem.h"

namespace talus::study {

class Forces {
 public:
  explicit Forces(const Desk& desk);  // those of the last step

  std::vector<double> normal, shear;  // N
  Vector motion() const;              // m, the unknowns under the present forces
  void rebuild();                     // motion from the forces
  double gap(size_t k) const;
  double slide(size_t k) const;
  // The dual potential: ½ fᵀK⁻¹f + Σ (gap N + N²/2kn - slide T + T²/2ks)/θ, gap and slide at d = 0.
  double value() const;
  void sweep(bool backwards);  // nonlinear Gauss–Seidel: each contact meets its law, all others held

 private:
  struct Link {
    int i, j;
    DofColumn ni, nj, si, sj;                          // rows
    DofColumn moved_ni, moved_nj, moved_si, moved_sj;  // K⁻¹ row
    double nn, ns, ss;                                 // m/N, motion of the contact under its own forces
  };
  void settle(size_t k);

  const Desk& desk_;
  std::vector<Link> links_;
  std::vector<DofMatrix> inverse_;
  std::vector<DofColumn> load_, motion_;
};

}  // namespace talus::study
