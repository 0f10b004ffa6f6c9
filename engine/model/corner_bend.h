#pragma once
// What of its bend the corners of a second-order block's contact polygon go with, where that is not curved (Model::curved).
//
// Contact sees straight edges there. With the polygon through the bent corners themselves, a pressure that is even along all edges, which
// contacts give back as forces at the corners, would bend the block: loose triangles under one stress are 2.6 times as soft as they
// are, however small (verification, second_order). The polygon is therefore laid so that each of its sides is, in the mean, where the
// bent edge is: for corners v and w of an edge,
//   (m̂_v + m̂_w)/2 = ∫ m ds / L,   m the monomials of model/bend.h.
// Corner forces of an even pressure then do the work of that pressure. Of a triangle these equations have one solution; with an even
// number of corners they may contradict each other, and with many they are near to it: least squares, of least distance from the corners.
#include <vector>

#include "model/bend.h"

namespace talus {

// m̂ of each corner. Corners from the centroid.
std::vector<Vec3> corner_bend(const std::vector<Vec2>& corners, const Bend& bend);

}  // namespace talus
