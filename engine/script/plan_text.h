#pragma once
#include <string>

#include "step/simulation.h"

namespace talus {

// What `talus plan` prints: sizes, then the parts a step of this scene goes through.
std::string plan_text(const Simulation& simulation);

}  // namespace talus
