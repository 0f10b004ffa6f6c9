#pragma once
// Blocks and edges that cuts leave too small for a region: merged, refused or kept, as the region says.
#include <string>
#include <vector>

#include "geometry/tessellation.h"
#include "scene/scene.h"

namespace talus {

// `origin`: of the model, for places in messages. Throws InputError where the region refuses slivers and has some.
void treat_slivers(const Region& region, const Vec2& origin, Tessellation& t, std::vector<std::string>& notes);

}  // namespace talus
