#pragma once
// The parameters that a study sets against those that its scene declares.
#include "scene/study.h"

namespace talus {

// Asks the scene, in a process of its own, and throws InputError for a name that it does not know and for a value
// that it would refuse: before anything is run.
void check_parameters(const Study& study);

}  // namespace talus
