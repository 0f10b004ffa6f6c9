#pragma once
// What a step that has been solved went past: its contacts were sought by the velocities at its start, and each of them
// is a straight line for the whole step.
#include <optional>
#include <utility>
#include <vector>

#include "contact/detection.h"
#include "equations/contact_terms.h"

namespace talus {

// Two blocks that move past each other in a step of `dt`, by `displacement` at most, and come to lie in each other
// deeper than their contacts know of, or begin to press on each other where they do not touch: at the end of the step,
// or at the places y that contacts are judged at. `d` solves the contacts, and leads to `moved`. `deepest`: what they
// may lie in each other, part of the smaller one's √area; `unasked`, no more: what those may that have no contact, open
// or not, as corners with their faces in line that meet in a point.
std::optional<std::pair<int, int>> overlooked(const Model& model, const ContactSearch& search,
                                              const ContactTerms& contacts, const Vector& d,
                                              const std::vector<BlockState>& moved, double dt, double displacement,
                                              double deepest, double unasked);

}  // namespace talus
