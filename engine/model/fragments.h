#pragma once
// Blocks that hang together by intact bonds, whether these can fail or not.
#include <vector>

#include "model/model.h"

namespace talus {

// Per block: the number of its fragment, counted by their first blocks.
std::vector<int> find_fragments(const Model& model);

}  // namespace talus
