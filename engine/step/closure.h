#pragma once
// What the rock gives off on its way from one equilibrium to another that it jumps to, as bonds fail or soften past
// what they bear. Bodies are elastic, so they give off ∫ t · dg = ½ (t0 + t1) · (g1 - g0) over all jumps g that
// tractions t act across (the crack closure integral of Irwin 1957, read backwards); contacts and bridges store some of
// it, friction takes some. Of bonds that fail, t0 is that of the bond, and the change of {σ}n works along the jump it
// had.
#include "equations/joint_terms.h"
#include "model/model.h"

namespace talus {

class Closure {
 public:
  // The rock as it is, with `joints` just failed, and contacts as they were before.
  Closure(const Model& model, const JointTerms& bonds, const std::vector<int>& joints);
  // J/m, where it has come to. friction: J/m, that contacts took on the way.
  double work(const Model& model, double friction) const;

 private:
  struct Before {
    int joint;
    JointPoints points;
    std::vector<BondTraction> flux;  // at the points
  };
  struct Pushed {
    Contact contact;
    Vec2 force;  // N/m, on the corner
    Vec2 foot;   // m, the material point of the edge that it lies beside, from the block's reference centroid
  };
  static Vec2 foot(const Model& model, const Contact& contact);
  std::vector<double> virials(const Model& model, const std::vector<int>& failed) const;
  double of_turns(const Model& model) const;
  Vec2 way(const Model& model, int block, const Vec2& in_block) const;  // m, of a material point
  double of_bond(const Model& model, const Before& before) const;
  std::vector<BondTraction> fluxes(const Model& model, int joint) const;

  const JointTerms& bonds_;
  std::vector<Vec2> vertex_;
  std::vector<BlockState> blocks_;
  double stored_;                // J/m, by contacts
  std::vector<double> virials_;  // J/m, per block
  std::vector<Before> before_;
  std::vector<Pushed> pushed_;
};

}  // namespace talus
