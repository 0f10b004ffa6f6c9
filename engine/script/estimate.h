#pragma once
// What a run would take, for `talus check`.
#include <string>

#include "script/run.h"

namespace talus {

// Takes up to a second of trial steps of a run in motion; nothing is written, and no handler called. Throws what a step
// throws.
std::string estimate_text(Run& run);

}  // namespace talus
