#pragma once
// A step of another length than the last.
#include <vector>

#include "model/model.h"

namespace talus {

// Steps look at y = X + a v, a = (θ-½)Δt (theory, § 2). Where Δt changes, and a from `before` to `after` (s), what
// blocks, bonds and contacts store there would change with it. The same model with X moved so that y stays: as far as
// bodies deform, blocks that hang together by bonds; and altogether what lies on something and moves against that, be
// it moving itself, by less than 1e-4 of its size (1e-6 where it slides). How all else flies and turns as a whole is
// left as it is, and momenta are kept.
std::vector<BlockState> keep_stored(const Model& model, double before, double after);

}  // namespace talus
