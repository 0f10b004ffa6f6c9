#pragma once
// Contacts that come to press in the search for the end of a load step along a face that touched as it began, as where
// that slides on to the next, or do again: they have slid as far in it as their blocks have since then (backward
// Euler). By what the last solves correct, friction would go either way. What lands in it has not slid before.
#include <vector>

#include "model/model.h"

namespace talus {

// Stretches what so touches and does not press by that way. `start`: of the load step.
void slid_so_far(Model& model, const std::vector<BlockState>& start);

}  // namespace talus
