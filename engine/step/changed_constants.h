#pragma once
// What a script changes of materials and joints between two load steps of a static run comes over the next one, as
// loads do. With K the stiffness of rock, bonds and supports, K₀u₀ = f₀ before and K₁u₁ = f₁ after (also where only
// contacts hold what moves), by Betti's theorem
//   ½ u₁·K₁u₁ - ½ u₀·K₀u₀ = ½ (f₀ + f₁)·(u₁ - u₀) + ½ u₀·(K₁ - K₀)u₁:
// the first part is the loads', the second the script's. Where no bond can fail the constants themselves come in the
// parts in which a load step is taken, so that what slides and opens as they change is followed.
#include <vector>

#include "equations/joint_terms.h"
#include "equations/supports.h"

namespace talus {

struct Constants {
  std::vector<Material> materials;
  std::vector<JointProperty> properties;
  bool given() const { return !materials.empty(); }
};
Constants constants_of(const Scene& scene);

class ConstantsWay {  // over a load step that begins at the model's time, from `before` to what the model has
 public:
  ConstantsWay(const Model& model, const Constants& before, double ends);
  void go(Model& model, double time) const;  // gives it those that hold when the loads are those of `time`, s

 private:
  Constants from_, to_;
  double begins_, ends_;  // s
};

// The rock as it would be with other constants.
struct WithConstants {
  WithConstants(const Model& as_it_is, const Constants& constants);
  double stored() const;  // J/m, by blocks, bonds and supports

  Model model;
  JointTerms joints;
  Supports supports;
};

class ConstantsBooking {
 public:
  // Of a load step that begins with the blocks where they are and supports displaced by `moved` (m, per fixity), for
  // which `before` held.
  ConstantsBooking(const Model& model, const Constants& before, const std::vector<Vec2>& moved);
  // J/m, ½ u₀·(K₁ - K₀)u₁ with u₁ the displacements of `model`.
  double work(const Model& model, const std::vector<Vec2>& moved) const;

 private:
  Constants before_;
  std::vector<BlockState> blocks_;
  std::vector<Vec2> moved_;
};

}  // namespace talus
