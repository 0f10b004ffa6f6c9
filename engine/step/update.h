#pragma once
// From the unknowns of a step to new block states.
#include "equations/scheme.h"
#include "equations/system.h"

namespace talus {

// States after the step: centroids moved, blocks turned exactly, strain added in the blocks' own axes. The spin
// is what keeps angular momentum about the centroid as the block's moments change with its strain.
std::vector<BlockState> moved_blocks(const Model& model, const Scheme& scheme, const Vector& d);
// The same in memory that has the states of what sleeps already.
void move_awake(const Model& model, const Scheme& scheme, const Vector& d, std::vector<BlockState>& moved);

// Displacement of a vertex of the block on the way to `to`, at most, m.
double displacement(const Model& model, int block, const BlockState& to);
// Largest displacement of any vertex between the model's states and `moved`, m.
double largest_displacement(const Model& model, const std::vector<BlockState>& moved);

// A block that `moved` squeezes to less than a tenth of its area, further than it is, or -1: linear elasticity would turn it inside out.
int crushed_block(const Model& model, const std::vector<BlockState>& moved);

}  // namespace talus
