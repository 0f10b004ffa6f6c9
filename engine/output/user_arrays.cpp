#include "output/user_arrays.h"

namespace talus {

std::vector<UserArray> user_arrays(const Model& model) {
  std::vector<UserArray> arrays;
  for (const auto& [name, value] : model.scene.output.fields) {
    arrays.push_back({name, {}});
    arrays.back().values.reserve(model.shapes.size());
    for (int block = 0; block < static_cast<int>(model.shapes.size()); ++block)
      arrays.back().values.push_back(value(block));
  }
  return arrays;
}

}  // namespace talus
