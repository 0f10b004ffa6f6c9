#include "contact/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

bool strains(const BlockShape& shape) { return shape.dofs > rigid_dofs; }

// Pa, of its strain: as they are given, blocks under an initial stress lie flush.
double normal_stress(const Model& model, int block, const Vec2& n) {
  if (!strains(model.shapes[size_t(block)])) return 0;
  const BlockState& state = model.blocks[size_t(block)];
  const Vec3 s = turn_stress(Rotation::of(state.angle), elasticity(model.material(block)) * state.strain);
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

}  // namespace

double flush_distance(const Model& model, int a, int b, const Vec2& normal) {
  const double least = std::min(model.shapes[size_t(a)].length, model.shapes[size_t(b)].length);
  const double stress = std::max(normal_stress(model, a, normal), normal_stress(model, b, normal));
  double give = 0;
  for (const int block : {a, b})
    if (stress > 0 && strains(model.shapes[size_t(block)])) give = std::max(give, 2 * extent(model, block, normal) * stress / model.material(block).young);
  return flush_part * least + std::min(give, passing_tolerance * least);
}

}  // namespace talus
