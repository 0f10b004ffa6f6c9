#pragma once
// Paths of cracks in tension that do not follow the mesh. Each bond takes a crack up to 30 degrees off its way, and
// nothing takes it back: a walk, whose error grows with the root of the number of bonds. And aslant a bond is pulled
// less: the crack needs more load than without a mesh, on any mesh. A tracked crack has a path beside its bonds. It
// goes on from where the path was, in the direction of the highest hoop stress around the tip (Erdogan & Sih 1963) in
// the mean over some blocks, and of the bonds at the tip the one fails that ends nearest to it: when one of them
// reaches its strength, or the hoop stress does. What still bridges it pulls across the path (Joint::path_turn).
#include <vector>

#include "model/model.h"

namespace talus {

class CrackTracking {
 public:
  CrackTracking(Model& model, const std::vector<std::vector<int>>& bonds_at_node);

  // The bonds that lead on from a tip get the utilisation of the hoop stress where it is higher.
  void judge();
  // Instead of each bond that is due in tension at the tip of one crack, the bond or bonds there that lead along its
  // path: their Joint::off_path and path_turn are written. In order of their numbers. The model is as it was judged.
  std::vector<int> lead(const std::vector<int>& due);

 private:
  struct Way {
    int joint;
    Vec2 off;  // m, reference: from its far end to the path
  };
  struct Tip {
    Vec2 ahead = Vec2::Zero();  // in which it goes on, reference, of length 1
    double hoop_stress = 0;     // Pa, there
    std::vector<Way> ways;      // the bonds nearest to it
  };
  std::vector<int> last_bonds() const;
  Tip tip(int node, int last) const;
  std::vector<Way> ways(int node, const Vec2& path, const Vec2& ahead) const;
  void lead(int due, const std::vector<int>& last, std::vector<int>& chosen);

  Model& model_;
  const std::vector<std::vector<int>>& bonds_at_node_;
  std::vector<std::vector<int>> bonds_of_block_;
};

}  // namespace talus
