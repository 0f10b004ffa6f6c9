#pragma once
// What the rock gives off on its way from one equilibrium to another that it jumps to, as bonds fail or soften past what they
// bear. Bodies are elastic, so they give off ∫ t · dg = ½ (t0 + t1) · (g1 - g0) over all jumps g that tractions t act across (the
// crack closure integral of Irwin 1957, read backwards); contacts and bridges store some of it, friction takes some. Of bonds
// that fail, t0 is that of the bond, and the change of {σ}n works along the jump it had.
#include "equations/joint_terms.h"
#include "model/model.h"

namespace talus {

class Closure {
 public:
  // The rock as it is, with `joints` just failed.
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
  struct Body {  // what hangs together by intact bonds, over its area: centroids then and now, m, and its turn, rad
    Vec2 then = Vec2::Zero(), now = Vec2::Zero();
    double turn = 0, area = 0;
  };
  static Vec2 foot(const Model& model, const Contact& contact);
  std::vector<Body> bodies_of(const Model& model) const;  // per block
  Vec2 way(const Model& model, const std::vector<Body>& bodies, int block, const Vec2& then, const Vec2& now, bool acts_then) const;
  Vec2 way(const Model& model, const std::vector<Body>& bodies, int block, const Vec2& in_block, bool acts_then) const;  // of a material point
  double of_bond(const Model& model, const std::vector<Body>& bodies, const Before& before) const;
  std::vector<BondTraction> fluxes(const Model& model, int joint) const;

  const JointTerms& bonds_;
  std::vector<Vec2> vertex_;
  std::vector<BlockState> blocks_;
  double stored_;  // J/m, by contacts
  std::vector<Before> before_;
  std::vector<Pushed> pushed_;
};

}  // namespace talus
