#pragma once
// Vertex–edge candidates of one pair of blocks.
#include <vector>

#include "contact/detection.h"
#include "model/model.h"

namespace talus {

// Corners of two blocks in one place, whether they press or not.
struct MeetingCorners {
  int a, corner_a, b, corner_b;  // blocks; indices into Model::vertex
};

// Appends the candidates between blocks a and b whose gap is below what they can close in `dt`.
// Kinds: edge_edge where an edge of the vertex lies along the other block's edge within parallel_angle;
// angle_edge; angle_angle where two corners meet (one contact, on the edge that is penetrated last: the
// entrance line of Shi 1988).
void find_contacts(const Model& model, const Surface& surface, const Faces& faces, int a, int b, double dt,
                   std::vector<Contact>& found, std::vector<MeetingCorners>& meeting);

// Corners nearer than this are in one place, m.
double meeting_distance(const Model& model, int a, int b);

}  // namespace talus
