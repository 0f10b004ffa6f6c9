#include "input/arc.h"

#include <cmath>

namespace talus {
namespace {

int chords(double angle, double chord) {
  const double step = 2 * std::acos(1 - chord);
  return std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step - 1e-9)));
}

void mirror(Polyline& points, int side) {
  if (side > 0) return;
  for (Vec2& p : points) p.x() = -p.x();
}

// Points between p and q on the arc, which turns by 4·atan(bulge).
void add_arc(const Vec2& p, const Vec2& q, double bulge, double chord, Polyline& points) {
  const double angle = 4 * std::atan(bulge);
  const Vec2 half = (q - p) / 2;
  const Vec2 centre = p + half + perp(half) * ((1 - bulge * bulge) / (2 * bulge));
  const Vec2 from = p - centre;
  const int count = chords(angle, chord);
  for (int k = 1; k < count; ++k) {
    const double turn = angle * k / count;
    points.push_back(centre + std::cos(turn) * from + std::sin(turn) * perp(from));
  }
}

}  // namespace

Polyline arc(const Vec2& centre, double radius, double from, double to, int side, double chord) {
  const double whole = 2 * M_PI;
  double angle = std::fmod(to - from, whole);
  if (angle <= 0) angle += whole;
  const int count = chords(angle, chord);
  Polyline points;
  for (int k = 0; k <= count; ++k) {
    const double at = from + angle * k / count;
    points.push_back(centre + radius * Vec2(std::cos(at), std::sin(at)));
  }
  if (angle == whole) points.back() = points.front();
  mirror(points, side);
  return points;
}

Polyline with_arcs(const std::vector<BulgedPoint>& vertices, bool closed, int side, double chord) {
  Polyline points;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    points.push_back(vertices[k].at);
    const bool last = k + 1 == vertices.size();
    if (vertices[k].bulge == 0 || (last && !closed)) continue;
    const Vec2& next = vertices[last ? 0 : k + 1].at;
    if (next != vertices[k].at) add_arc(vertices[k].at, next, vertices[k].bulge, chord, points);
  }
  mirror(points, side);
  return points;
}

}  // namespace talus
