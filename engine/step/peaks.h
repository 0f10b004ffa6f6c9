#pragma once
// What a run keeps beside the present state: the peak velocity at each probe, how high rock has flown, and how far
// blocks were strained.
#include "model/model.h"

namespace talus {

// Stress goes with strain, and the energy of a block that turns is right, as far as their squares do not matter.
constexpr double small_strain = 0.1;

// After each accepted step of `dt` (s; 0: of a static run). Whether a strain has passed small_strain for the first
// time.
bool keep_peaks(Model& model, double dt);

}  // namespace talus
