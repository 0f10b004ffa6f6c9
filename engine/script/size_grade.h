#pragma once
// Graded mesh sizes: a size at each of some places, growing linearly with the distance from it up to `far`.
#include <functional>
#include <vector>

#include "scene/scene.h"
#include "script/table_reader.h"

namespace talus {

struct SizeGrade {
  struct Source {
    Polyline points;      // one point, or a line
    bool closed = false;  // an outline: distance to its boundary
    double size = 0;      // m, at the source
    double reach = 0;     // m, distance at which `far` is reached
  };
  std::vector<Source> sources;
  double far = 0;  // m
  double operator()(const Vec2& point) const;
};

std::function<double(Vec2)> read_grade(const TableReader& grade, const std::vector<Hole>& holes);

}  // namespace talus
