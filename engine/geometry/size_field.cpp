#include "geometry/size_field.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace talus {

namespace {

Vec2 along_first_edge(const Polyline& outline) {
  return (outline[1] - outline[0]).normalized();
}

}  // namespace

MeshFrame MeshFrame::about_box(const Polyline& outline) {
  const MeshFrame turned(outline[0], 1, along_first_edge(outline));
  Polyline line;
  for (const Vec2& p : outline) line.push_back(turned.local(p));
  const Bounds box = bounds(line);
  return {turned.world(box.min), box.extent(), turned.axis_};
}

MeshFrame MeshFrame::about_first_point(const Polyline& outline) {
  return {outline[0], std::sqrt(signed_area(outline)), along_first_edge(outline)};
}

Vec2 MeshFrame::local(const Vec2& point) const {
  const Vec2 from = (point - origin_) / unit_;
  return {from.dot(axis_), from.dot(perp(axis_))};
}

Vec2 MeshFrame::local_of_given(const Vec2& point) const {
  const Vec2 scaled = local(point);
  return {std::round(scaled.x() / resolution) * resolution, std::round(scaled.y() / resolution) * resolution};
}

// Rounded to single precision for the same reason as given points are.
double SizeField::at(const Vec2& local) const {
  const Vec2 point = frame_.world(local);
  const double size = size_at_(point);
  if (!(size > 0) || !std::isfinite(size)) {
    std::ostringstream text;
    text << "the mesh size at (" << point.x() << ", " << point.y() << ") is " << size
         << ", where a positive length is needed";
    throw std::invalid_argument(text.str());
  }
  constexpr double least = 1e-30;  // keeps 1/size² finite; far below any mesh that is allowed
  return std::max<double>(static_cast<float>(size / frame_.unit()), least);
}

// Running integral of 1/size (trapezoidal rule) at equal steps from a to b. Doubles the steps until they are
// no longer than the edges asked for, so that a size that changes along the line is followed.
std::vector<double> SizeField::cumulated_edges(const Vec2& a, const Vec2& b) const {
  const double length = (b - a).norm();
  constexpr int most = 4096;
  for (int steps = 8;; steps *= 2) {
    std::vector<double> sum{0};
    double last = 1 / at(a);
    for (int i = 1; i <= steps; ++i) {
      const double next = 1 / at(a + (b - a) * (static_cast<double>(i) / steps));
      sum.push_back(sum.back() + (last + next) / 2 * length / steps);
      last = next;
    }
    if (sum.back() <= steps || steps >= most) return sum;
  }
}

double SizeField::edges_along(const Vec2& a, const Vec2& b) const {
  return cumulated_edges(a, b).back();
}

// The inverse of a running integral at equal steps; `i` is where the search goes on from.
double SizeField::fraction(const std::vector<double>& sum, double wanted, std::size_t& i) {
  while (i + 1 < sum.size() && sum[i] < wanted) ++i;
  return (static_cast<double>(i - 1) + (wanted - sum[i - 1]) / (sum[i] - sum[i - 1])) /
         static_cast<double>(sum.size() - 1);
}

double SizeField::where(const Vec2& a, const Vec2& b, double edges) const {
  const std::vector<double> sum = cumulated_edges(a, b);
  std::size_t i = 1;
  return std::clamp(fraction(sum, edges, i), 0.0, 1.0);
}

std::vector<double> SizeField::divisions(const Vec2& a, const Vec2& b) const {
  const std::vector<double> sum = cumulated_edges(a, b);
  const int edges = std::max(1, static_cast<int>(std::lround(sum.back())));
  std::vector<double> cuts;
  std::size_t i = 1;
  for (int k = 1; k < edges; ++k) {
    cuts.push_back(fraction(sum, sum.back() * k / edges, i));
  }
  return cuts;
}

double SizeField::one_point_rule(const Vec2& a, const Vec2& b, const Vec2& c) const {
  const double size = at((a + b + c) / 3);
  return std::abs(cross(b - a, c - a)) / 2 / (size * size);
}

double SizeField::squares_in(const Vec2& a, const Vec2& b, const Vec2& c) const {
  return squares_in(a, b, c, one_point_rule(a, b, c), 0);
}

// Quarters the triangle until quartering changes little; twice at least where it is worth many elements.
double SizeField::squares_in(const Vec2& a, const Vec2& b, const Vec2& c, double one_point, int depth) const {
  const Vec2 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
  const double parts[] = {one_point_rule(a, ab, ca), one_point_rule(ab, b, bc), one_point_rule(ca, bc, c),
                          one_point_rule(ab, bc, ca)};
  const double sum = parts[0] + parts[1] + parts[2] + parts[3];
  const bool settled = std::abs(sum - one_point) <= 0.05 * sum;
  if (sum < 1 || depth >= 7 || (settled && depth >= 1)) return sum;
  return squares_in(a, ab, ca, parts[0], depth + 1) + squares_in(ab, b, bc, parts[1], depth + 1) +
         squares_in(ca, bc, c, parts[2], depth + 1) + squares_in(ab, bc, ca, parts[3], depth + 1);
}

}  // namespace talus
