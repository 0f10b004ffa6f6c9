#pragma once
// What a bond that fails in motion gives off, and what the blocks beside it go on with (docs/theory.md, § 12).
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "equations/joint_terms.h"
#include "model/model.h"

namespace talus {

class BondRelease {
 public:
  // Of the bonds `due`, with the blocks where they are, energies weighed `ahead` s from there.
  BondRelease(const Model& model, const JointTerms& bonds, const std::vector<int>& due, double ahead);
  // Strains that its blocks a and b go on with beside their own, so that no energy is made; nothing where there are
  // none, and it is not to fail. Of the one bond after the other, those strains added to the blocks.
  std::optional<std::array<BlockStrain, 2>> fail(int joint);

 private:
  const Model& model_;
  const JointTerms& bonds_;
  double ahead_;
  std::map<int, BlockStrain> strain_of_jumps_;  // of the blocks beside, by all their bonds that hold
};

}  // namespace talus
