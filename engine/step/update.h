#pragma once
// From the unknowns of a step to new block states.
#include "equations/scheme.h"
#include "equations/system.h"

namespace talus {

// States after the step: centroids moved, blocks turned exactly, strain added in the blocks' own axes. The spin
// is what keeps angular momentum about the centroid as the block's moments change with its strain.
std::vector<BlockState> moved_blocks(const Model& model, const Scheme& scheme, const Vector& d);
// Of one.
void move_block(const Model& model, const Scheme& scheme, const Vector& d, int block, BlockState& moved);

// Displacement of a vertex of the block on the way to `to`, at most, m; as seen by what moves by `with` meanwhile.
double displacement(const Model& model, int block, const BlockState& to, const Vec2& with = Vec2::Zero());

// Whether it is squeezed to less than a tenth of its area on that way, further than it is: linear elasticity would turn
// it inside out.
bool crushed(const Model& model, int block, const BlockState& to);

// A contact of something held or supported that its force presses in by more than a tenth of the smaller block, or
// null: with the default stiffness under ten times Young's modulus, as where it is driven against what cannot give way.
// From a sixth on corners come out on the other side. What is free gives way: splinters at the hole of a blast, of
// joints of 1000 GPa/m, may be pressed in as deep for a moment.
const Contact* driven_in(const Model& model);

}  // namespace talus
