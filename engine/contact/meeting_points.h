#pragma once
// Where corners of three or more bodies meet in one place, as round a node of a loose mesh, they hold each other by
// their faces. Two of them that share none touch in that point only: what keeps them apart is what lies between, and a
// contact there would bar ways that are free. They may press once the corners have parted.
//
// But for a tip that stands between two bodies with nothing on its other side, as a wedge does on a joint that ends
// under it: along the face of the one it would slide into the other.
#include <vector>

#include "contact/detection.h"
#include "contact/narrow_phase.h"

namespace talus {

void drop_points(const Model& model, const Surface& surface, const std::vector<MeetingCorners>& meeting,
                 std::vector<Contact>& found);

}  // namespace talus
