#pragma once
// What bounds an automatic step: how far blocks move past what they may meet in it. Flight under gravity is exact (the
// parabola of every scheme), so what flies by itself, a chip or a stone that leaves the scene, does not, nor does
// rubble that flies together but for what moves within it.
#include <utility>
#include <vector>

#include "model/model.h"

namespace talus {

// Whether that is all that acts in flight at this time: no damping, no load that changes.
bool flies_exactly(const Scene& scene, double time);

// m, the most by which a block moves in a step that leads to `moved`, as displacement() has it: less the mean motion,
// by mass, of all that hangs together by `near` pairs and bonds, where nothing that is held or supported is among
// them. O(blocks + joints + pairs).
double motion_past(const Model& model, const std::vector<std::pair<int, int>>& near,
                   const std::vector<BlockState>& moved);

}  // namespace talus
