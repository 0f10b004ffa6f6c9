#include "contact/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

bool strains(const BlockShape& shape) {
  return shape.dofs > rigid_dofs;
}

double normal_stress(const Pressing& pressing, const Vec2& n) {
  const Vec3& s = pressing.stress;
  return std::abs(n.x() * n.x() * s[0] + n.y() * n.y() * s[1] + 2 * n.x() * n.y() * s[2]);
}

double extent(const Model& model, int block, const Vec2& n) {  // m
  const int begin = model.shapes[size_t(block)].vertex_begin;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int v = begin; v < begin + model.vertex_count(block); ++v) {
    const double at = n.dot(model.vertex[size_t(v)] - model.vertex[size_t(begin)]);
    low = std::min(low, at), high = std::max(high, at);
  }
  return high - low;
}

// What is asked of each block: stress, Pa, and extent, m.
template <class Stress, class Extent>
double flush_by(const Model& model, int a, int b, const Stress& stress_in, const Extent& extent_of) {
  const double least = std::min(model.shapes[size_t(a)].length, model.shapes[size_t(b)].length);
  const double stress = std::max(stress_in(a), stress_in(b));
  double give = 0;
  for (const int block : {a, b})
    if (stress > 0 && strains(model.shapes[size_t(block)]))
      give = std::max(give, 2 * extent_of(block) * stress / model.material(block).young);
  return flush_part * least + std::min(give, passing_tolerance * least);
}

}  // namespace

double largest_flush_distance(const Model& model, const Faces& faces, int a, int b) {
  constexpr double widest = 4;  // radii: of a block that is stretched to twice its length
  return flush_by(
      model, a, b, [&](int block) { return faces.pressing(block).largest; },
      [&](int block) { return widest * model.shapes[size_t(block)].radius; });
}

double flush_distance(const Model& model, const Faces& faces, int a, int b, const Vec2& normal) {
  return flush_by(
      model, a, b, [&](int block) { return normal_stress(faces.pressing(block), normal); },
      [&](int block) { return extent(model, block, normal); });
}

}  // namespace talus
