#pragma once
// A step of another length than the last.
#include <vector>

#include "model/model.h"

namespace talus {

// Steps look at y = X + (θ-½)Δt v (theory, § 2). Where Δt changes, so that y would lie `seconds` less along the velocities, what
// blocks and bonds store there would change with it. The same model with X moved so that y stays, as far as bodies deform: how a
// body flies and turns as a whole, blocks that hang together by bonds, is left as it is, and its momenta are kept.
std::vector<BlockState> keep_deformation(const Model& model, double seconds);

}  // namespace talus
