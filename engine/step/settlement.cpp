#include "step/settlement.h"

#include <cmath>

namespace talus {

namespace {

// What stands turns and settles by its strains, and drops by the play it was drawn with.
constexpr double most_turn = 0.1;  // rad
constexpr double most_way = 0.5;   // of the diameter of a disc of its area

std::vector<double> mean_angles(const Model& model, const std::vector<Fragment>& fragments) {
  const std::vector<int> of = model.fragment.empty() ? find_fragments(model) : model.fragment;
  std::vector<double> mean(fragments.size(), 0.0);
  for (size_t b = 0; b < of.size(); ++b) mean[size_t(of[b])] += model.mass(int(b)) / fragments[size_t(of[b])].mass * model.blocks[b].angle;
  return mean;
}

}  // namespace

Settlement::Settlement(const Model& model) : before_(fragments(model)), angle_(mean_angles(model, before_)) {}

int Settlement::left(const Model& model) const {
  const std::vector<Fragment> now = fragments(model);
  const std::vector<double> angle = mean_angles(model, now);
  for (size_t k = 0; k < now.size(); ++k) {
    if (now[k].held) continue;
    if (std::abs(angle[k] - angle_[k]) > most_turn || (now[k].shift - before_[k].shift).norm() > most_way * now[k].size()) return now[k].first;
  }
  return -1;
}

}  // namespace talus
