#pragma once
// The arrays a scene adds to its output (output.fields), evaluated once per output time.
#include <string>
#include <vector>

#include "model/model.h"

namespace talus {

struct UserArray {
  std::string name;
  std::vector<double> values;  // per block
};
std::vector<UserArray> user_arrays(const Model& model);

}  // namespace talus
