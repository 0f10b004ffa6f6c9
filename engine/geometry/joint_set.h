#pragma once
// Joint lines of a set, clipped to a box: straight, parallel up to scatter, broken into jointed parts and
// rock bridges when persistence < 1 (parts of trace_length, bridges to match, staggered by the seed; their lengths
// scatter uniformly, each by itself).
// The same seed gives the same lines on every machine (own generator, not std::uniform_*).
#include <vector>

#include "geometry/vec2.h"
#include "scene/scene.h"

namespace talus {
std::vector<Polyline> joint_lines(const JointSet& set, const Vec2& box_min, const Vec2& box_max);
}
