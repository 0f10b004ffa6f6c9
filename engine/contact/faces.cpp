#include "contact/faces.h"

#include <algorithm>
#include <cmath>

#include "contact/detection.h"
#include "contact/outline.h"

namespace talus {

namespace {

OutlineCorner corner_of(const Outline& outline, int vertex) {
  const Vec2 ahead = outline.ahead(vertex), behind = outline.behind(vertex);
  return {ahead.normalized(), behind.normalized(), outline.turn(vertex),
          std::sqrt(std::min(ahead.squaredNorm(), behind.squaredNorm()))};
}

Pressing pressing_of(const Model& model, int block) {
  if (model.shapes[size_t(block)].dofs <= rigid_dofs) return {};
  const BlockState& state = model.blocks[size_t(block)];
  const Vec3 s = elasticity(model.material(block)) * state.strain;
  return {turn_stress(Rotation::of(state.angle), s),
          (std::abs(s[0] + s[1]) + std::sqrt((s[0] - s[1]) * (s[0] - s[1]) + 4 * s[2] * s[2])) / 2};
}

}  // namespace

void Faces::find(const Model& model, const Surface& surface, const std::vector<std::pair<int, int>>& near) {
  faces_.resize(model.vertex.size());
  corners_.resize(model.vertex.size());
  pressing_.resize(model.shapes.size());
  found_.assign(model.shapes.size(), 0);
  for (const auto& [a, b] : near)
    for (const int block : {a, b}) {
      find(model, surface, block);
      if (surface.whole[size_t(block)]) continue;
      const BlockShape& shape = model.shapes[size_t(block)];
      for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) {
        find(model, surface, surface.leaving[size_t(v)].block);
        find(model, surface, surface.arriving[size_t(v)].block);
      }
    }
}

void Faces::find(const Model& model, const Surface& surface, int block) {
  if (std::exchange(found_[size_t(block)], 1)) return;
  const Outline outline(model, surface);
  const int begin = model.shapes[size_t(block)].vertex_begin;
  for (int e = 0; e < model.vertex_count(block); ++e) {
    const Vec2 from = model.vertex[size_t(begin + e)],
               span = model.vertex[size_t(begin + model.next_vertex(block, e))] - from;
    const double length = span.norm();
    const Vec2 along = span / length;
    faces_[size_t(begin + e)] = {from, along, -perp(along), length};
    corners_[size_t(begin + e)] = corner_of(outline, begin + e);
  }
  pressing_[size_t(block)] = pressing_of(model, block);
}

}  // namespace talus
