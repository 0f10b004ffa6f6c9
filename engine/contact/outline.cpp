#include "contact/outline.h"

#include <algorithm>

namespace talus {

namespace {

double largest_stress(const Model& model, int block) {  // Pa
  return model.shapes[size_t(block)].dofs > rigid_dofs ? model.stress(block).lpNorm<Eigen::Infinity>() : 0;
}

}  // namespace

double flush_distance(const Model& model, int a, int b) {
  const double least = std::min(model.shapes[size_t(a)].length, model.shapes[size_t(b)].length);
  const double stress = std::max(largest_stress(model, a), largest_stress(model, b));
  double give = 0;
  for (const int block : {a, b})
    if (model.shapes[size_t(block)].dofs > rigid_dofs) give = std::max(give, 2 * model.shapes[size_t(block)].radius * stress / model.material(block).young);
  return flush_part * least + std::min(give, passing_tolerance * least);
}

}  // namespace talus
