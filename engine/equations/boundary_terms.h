#pragma once
// Fixed points, point loads, edge tractions and pressures; the motion of held blocks.
#include "equations/system.h"

namespace talus {

// Displacement (m) a fixity asks for at time `t`: its displacement history, or its velocity summed from 0 to t.
Vec2 fixity_displacement(const Fixity& fixity, double t);

// Gives wholly held blocks the velocity that takes them to where their fixity wants them at the step's end.
void move_held_blocks(Model& model, double dt);

// Equilibrium: held blocks where their fixity wants them at Model::time.
void place_held_blocks(Model& model);

void add_boundary_terms(const Model& model, const Poses& poses, const Scheme& scheme, System& system);

}  // namespace talus
