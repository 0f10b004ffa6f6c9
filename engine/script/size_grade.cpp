#include "script/size_grade.h"

#include <algorithm>
#include <limits>

#include "geometry/polygon.h"

namespace talus {
namespace {

double distance(const SizeGrade::Source& source, const Vec2& point) {
  if (source.points.size() == 1) return (point - source.points.front()).norm();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < source.points.size(); ++i) {
    least = std::min(least, distance_to_segment(source.points[i], source.points[i + 1], point));
  }
  if (source.closed) least = std::min(least, distance_to_segment(source.points.back(), source.points.front(), point));
  return least;
}

}  // namespace

double SizeGrade::operator()(const Vec2& point) const {
  double size = far;
  for (const Source& source : sources) {
    const double part = std::min(1.0, distance(source, point) / source.reach);
    size = std::min(size, source.size + part * (far - source.size));
  }
  return size;
}

std::function<double(Vec2)> read_grade(const TableReader& t, const std::vector<Hole>& holes) {
  SizeGrade grade;
  t.read("far", grade.far);
  t.each("sources", [&](const TableReader& e) {
    SizeGrade::Source& source = grade.sources.emplace_back();
    e.read("size", source.size);
    e.read("reach", source.reach);
    e.read("points", source.points);
    e.read("closed", source.closed);
    int hole = -1;
    e.read_index("hole", hole);
    if (hole < 0) return;
    source.points = holes.at(static_cast<std::size_t>(hole)).outline;
    source.closed = true;
  });
  return grade;
}

}  // namespace talus
