#pragma once
// Contacts that come to press in the search for the end of a load step, as where a face slides on to the next, or do
// again: they have slid as far in it as their blocks have since it began (backward Euler). By what the last solves
// correct, friction would go either way.
#include <vector>

#include "model/model.h"

namespace talus {

// Stretches what touches and does not press by that way. `start`: of the load step.
void slid_so_far(Model& model, const std::vector<BlockState>& start);

}  // namespace talus
