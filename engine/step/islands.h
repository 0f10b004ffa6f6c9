#pragma once
// Islands: blocks that hang together by bonds or may press on each other in this step. Nothing passes
// between two of them, so each is judged and solved by itself. Held blocks pass nothing on and belong to every
// island that touches them; what sleeps is of none.
#include <span>

#include "equations/contact_terms.h"

namespace talus {

// Whether it holds its blocks together: intact, or softening.
inline bool ties(const Joint& joint) {
  return joint.state == JointState::intact || joint.bridged;
}

class Islands {
 public:
  // together: one island, the scene. O(blocks + joints + contacts).
  void find(const Model& model, const ContactTerms& contacts, bool together);

  int count() const { return int(single_.size()); }
  std::span<const int> blocks(int island) const { return blocks_.of(island); }  // rising; held ones among them
  // Of ContactTerms; those that are only watched among them, where both blocks are of the island or one is held.
  std::span<const int> rows(int island) const { return rows_.of(island); }
  // One block on which nothing presses and that no bond holds.
  bool single(int island) const { return single_[island]; }
  int first(int island) const {  // of its blocks with unknowns; a held one first in the list may be of many islands
    for (const int b : blocks(island))
      if (of_[b] >= 0) return b;
    return -1;
  }
  int of(int block) const { return of_[block]; }                           // -1: held, or asleep
  std::span<const int> rows_between() const { return rows_.of(count()); }  // watched, from one island to another

 private:
  struct Lists {  // CSR
    std::vector<int> begin, items;
    void fill(int count, const std::vector<std::pair<int, int>>& pairs);
    std::span<const int> of(int list) const {
      return std::span(items).subspan(size_t(begin[list]), size_t(begin[list + 1] - begin[list]));
    }
  };
  void take_all(const Model& model, const ContactTerms& contacts);
  int join(const Model& model, const ContactTerms& contacts);

  std::vector<int> of_;
  Lists blocks_, rows_;
  std::vector<char> single_;
};

}  // namespace talus
