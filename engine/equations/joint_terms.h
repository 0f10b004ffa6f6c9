#pragma once
// Bonds: intact joints. What holds edges to the ground is in supports.h.
//
// exact: Nitsche's method (Nitsche 1971; in elasticity Hansbo & Larson 2002). With g the jump of place across
// the joint and {σ}n the weighted mean of the two blocks' tractions, the bond's energy is
//   ∫ {σ}n · g + ½ k g · g  ds,      traction  t = {σ}n + k g.
// It is consistent: where the exact solution has no jump the traction is the rock's own, so intact rock has
// no joint compliance. The sum with the blocks' strain energy is positive when, for each block,
//   Σ_e w_e² L_e |N_e D ε|² / κ_e <= A ε·D ε        (Young's inequality on each edge's flux),
// so with κ the largest eigenvalue of that quotient at κ_e = 1, k = penalty (κ_a + κ_b), penalty > 1, is
// positive definite by proof, on any mesh. κ ~ E/h. Of second-order blocks ε and σ vary, and both are integrals.
//
// spring: springs at the edge's ends (Ning et al. 2011), normal and shear.
#include "equations/block_strain.h"
#include "equations/system.h"

namespace talus {

struct Ends;

class JointTerms {
 public:
  void prepare(const Model& model);  // stiffnesses; again when Model::revision has changed
  void find_slots(const Model& model, const BlockMatrix& matrix);
  void add(const Model& model, const Poses& poses, const Scheme& scheme, System& system) const;
  // A step is solved with jumps that are linear in d about turning at the spin it begins with. Where that is another at
  // its end, as after a hit, they are not those of `moved`, where d leads: from then on, until begin(), they are linear
  // about this d. Whether they agreed.
  bool agrees(const Model& model, const Poses& poses, const Scheme& scheme, const Vector& d,
              const std::vector<BlockState>& moved);
  // Whether they may not, by the change of spins alone.
  bool may_disagree(const Model& model, const Scheme& scheme, const Vector& d) const;
  void begin() { missing_.clear(); }
  struct Turning {    // J/m, of a step, by bonds of blocks that turn
    double loss = 0;  // the integrator's (step/ledger.cpp), less what the matrix makes of it
    double lift = 0;  // of y (step/turning.h)
  };
  Turning turning(const Model& model, const Poses& poses, const Scheme& scheme, const Vector& d,
                  const std::vector<BlockState>& moved) const;
  // Tractions, openings and slips of the joints' points in the model's present state.
  void store_tractions(Model& model) const;

  // J/m: the bonds' potential `ahead` seconds along the present velocities, each in axes that turn with its pair.
  double energy(const Model& model, double ahead) const;
  double energy_of(const Model& model, int joint, double ahead) const;  // whether intact or not

  // In the axes of blocks a and b: what the jump g of an exact bond adds to their strain, (w L/A) sym(n ⊗ g) where that
  // is constant, with which the work of {σ}n on g is that of the stress on a strain (the lifting of discontinuous
  // Galerkin methods; theory, § 4).
  std::array<BlockStrain, 2> strain_of_jump(const Model& model, int joint, double ahead) const;

  // Pa, {σ}n of an exact bond in the joint's axes at the place `at` along it, whether intact or not; nothing for
  // springs.
  BondTraction flux(const Model& model, int joint, double at) const;

  // N/m3: {normal, shear} stiffness per area of joint `j`; k twice for an exact bond.
  std::array<double, 2> stiffness(int j) const { return stiffness_[j]; }
  const std::vector<double>& ground_stiffness() const { return ground_stiffness_; }  // N/m3, per EdgeFixity

 private:
  double energy_of(const Model& model, int joint, const Pose& a, const Pose& b, double ahead) const;
  template <int size>  // of the larger block's unknowns
  void add_bond(const Model& model, const Poses& poses, const Ends& ends, const Scheme& scheme, int joint,
                System& system) const;
  template <int size>
  double find_missing(const Model& model, const Poses& poses, const Ends& ends, const Scheme& scheme, int joint,
                      const Vector& d, const std::array<Pose, 2>& after);
  Vec2 missing(int joint, int point) const {
    return missing_.empty() ? Vec2(0, 0) : missing_[size_t(joint)][size_t(point)];
  }
  template <int size>
  Turning turning_of_bond(const Model& model, const Poses& poses, const Ends& ends, const Scheme& scheme, int joint,
                          const Vector& d, const std::array<Pose, 2>& after, const std::array<double, 2>& bends) const;

  std::vector<std::array<double, 2>> stiffness_;
  std::vector<double> ground_stiffness_;
  // m, per joint and point, what jumps are more than linear; empty: none
  std::vector<std::array<Vec2, JointPoints::most>> missing_;
  struct Slots {
    BlockMatrix::Slot aa, bb, ab;
  };
  std::vector<Slots> slots_;
};

}  // namespace talus
