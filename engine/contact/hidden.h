#pragma once
// Contacts of single blocks that are none of the bodies which these are part of, or lie in.
#include <vector>

#include "contact/detection.h"
#include "model/model.h"

namespace talus {

// Drops those of all pairs, in order of their corners, that a side of the body beside them hides, or a face above them.
void drop_hidden(const Model& model, const Surface& surface, const Faces& faces, std::vector<Contact>& found);

}  // namespace talus
