#pragma once
// Paths of cracks in tension that do not stray with the mesh. Each bond takes a crack up to 30 degrees off its way, and
// nothing takes it back: a walk, whose error grows with the root of the number of bonds. A tracked crack has a path beside
// its bonds. It goes on from where the path was, in the direction of the highest hoop stress around the tip (Erdogan & Sih
// 1963) in the mean over some blocks, and of the bonds at the tip the one fails that ends nearest to it. When it fails is as
// without: when the first bond at the tip reaches its strength.
#include <optional>
#include <vector>

#include "model/model.h"

namespace talus {

class CrackTracking {
 public:
  CrackTracking(Model& model, const std::vector<std::vector<int>>& bonds_at_node);

  // Instead of each bond that is due in tension at the tip of one crack, the bond or bonds there that lead along its path:
  // their Joint::off_path is written. In order of their numbers.
  std::vector<int> lead(const std::vector<int>& due);

 private:
  struct Tip {
    Vec2 path = Vec2::Zero();   // m, reference: where the crack would be without the mesh
    Vec2 ahead = Vec2::Zero();  // in which it goes on, of length 1
  };
  std::vector<int> last_bonds() const;
  std::optional<Tip> tip(int node, int last) const;
  void lead(int due, const std::vector<int>& last, std::vector<int>& chosen);

  Model& model_;
  const std::vector<std::vector<int>>& bonds_at_node_;
  std::vector<std::vector<int>> bonds_of_block_;
};

}  // namespace talus
