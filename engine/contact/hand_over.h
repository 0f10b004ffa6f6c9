#pragma once
// What contacts begin a step with: the state of those that go on, and of those that they take over from.
#include <vector>

#include "model/model.h"

namespace talus {

struct Surface;  // contact/detection.h

// outward, as the blocks lie; of a curved edge, at the vertex's foot
Vec2 edge_normal(const Model& model, const Contact& contact);
// m, of a contact as the blocks lie; negative where the vertex is below the edge's line.
double gap_now(const Model& model, const Contact& contact);

// State of the contacts that go on, and of those that hand over. The model's are those of the last search; both lists
// are in the order of key(). `cracked`: bonds have failed in this step, whose bodies met by other corners before.
// Returns what those that ended stored beyond what goes on, J/m.
double carry_over(const Model& model, double dt, bool cracked, std::vector<Contact>& now);
void forgive_depth(Model& model, double dt);   // of a step that is shorter than the last
void lie_as_pressed(Model& model, double dt);  // what rests

}  // namespace talus
