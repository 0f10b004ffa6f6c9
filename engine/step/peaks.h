#pragma once
// What a run keeps of its motion beside the present state: the peak velocity at each probe, and how high rock has
// flown.
#include "model/model.h"

namespace talus {

void keep_peaks(Model& model);  // after each accepted step in motion

}  // namespace talus
