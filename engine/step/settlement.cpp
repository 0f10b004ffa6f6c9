#include "step/settlement.h"

#include <cmath>

namespace talus {

namespace {

// What stands turns and settles by its strains, and drops by the play it was drawn with.
constexpr double most_turn = 0.1;  // rad
constexpr double most_way = 0.5;   // of the diameter of a disc of its area

}  // namespace

int Settlement::left(const Model& model) const {
  const std::vector<Fragment> now = fragments(model);
  for (size_t k = 0; k < now.size(); ++k) {
    if (now[k].held) continue;
    if (std::abs(now[k].angle - before_[k].angle) > most_turn ||
        (now[k].shift - before_[k].shift).norm() > most_way * now[k].size())
      return now[k].first;
  }
  return -1;
}

}  // namespace talus
