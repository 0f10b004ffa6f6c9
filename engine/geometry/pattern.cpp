#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/polygon.h"
#include "geometry/tessellation.h"

namespace talus {
Polyline turned_corners(Polyline corners) {
  if (signed_area(corners) < 0) std::reverse(corners.begin(), corners.end());
  int first = 0;
  double most = -2;
  for (int i = 0; i < 4; ++i) {
    const double along_x = (corners[(i + 1) % 4] - corners[i]).normalized().x();
    if (along_x > most + 1e-9) {  // an outline turned by 45° has two such edges: the first one counts
      most = along_x;
      first = i;
    }
  }
  std::rotate(corners.begin(), corners.begin() + first, corners.end());
  return corners;
}

namespace {

bool is_rectangle(const Polyline& outline) {
  if (outline.size() != 4) return false;
  const Vec2 u = outline[1] - outline[0], v = outline[3] - outline[0];
  if (!u.allFinite() || !v.allFinite()) return false;
  const double a = u.norm(), b = v.norm();
  const double round_off = 1e-9 * std::max(a, b);
  return a > 0 && b > 0 && (outline[0] + u + v - outline[2]).norm() <= round_off &&
         std::abs(u.dot(v)) <= round_off * std::min(a, b);
}

// The k-th of n equal steps from a to b: the ends exactly, and the same bits when a and b are exchanged, so
// that regions side by side agree on the points of their common edge.
Vec2 between(const Vec2& a, const Vec2& b, int k, int n) {
  if (k == 0) return a;
  if (k == n) return b;
  return (static_cast<double>(n - k) * a + static_cast<double>(k) * b) / n;
}

void add_grid_points(const Polyline& corner, int nx, int ny, std::vector<Vec2>& points) {
  for (int j = 0; j <= ny; ++j) {
    const Vec2 left = between(corner[0], corner[3], j, ny), right = between(corner[1], corner[2], j, ny);
    for (int i = 0; i <= nx; ++i) points.push_back(between(left, right, i, nx));
  }
}

void cut_by_one_diagonal(const std::array<int, 4>& q, bool rising, std::vector<std::vector<int>>& cells) {
  if (rising) {
    cells.push_back({q[0], q[1], q[2]});
    cells.push_back({q[0], q[2], q[3]});
  } else {
    cells.push_back({q[0], q[1], q[3]});
    cells.push_back({q[1], q[2], q[3]});
  }
}

}  // namespace

Tessellation pattern(const Polyline& outline, Pattern kind, int nx, int ny) {
  if (!is_rectangle(outline)) throw std::invalid_argument("a pattern needs an outline that is a rectangle");
  if (nx < 1 || ny < 1) throw std::invalid_argument("a pattern needs at least one rectangle along each side");
  Tessellation t;
  add_grid_points(turned_corners(outline), nx, ny, t.points);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int at = j * (nx + 1) + i;
      const std::array<int, 4> q{at, at + 1, at + nx + 2, at + nx + 1};  // counter-clockwise
      if (kind == Pattern::cross) {
        const int centre = static_cast<int>(t.points.size());
        t.points.push_back((t.points[q[0]] + t.points[q[1]] + t.points[q[2]] + t.points[q[3]]) / 4);
        for (int side = 0; side < 4; ++side) t.cells.push_back({q[side], q[(side + 1) % 4], centre});
      } else {
        const bool rising = kind == Pattern::diagonal || (i + j) % 2 == 0;
        cut_by_one_diagonal(q, rising, t.cells);
      }
    }
  connect(t);
  return t;
}

}  // namespace talus
