#include "contact/faces.h"

#include "contact/detection.h"

namespace talus {

void Faces::find(const Model& model, const Surface& surface, const std::vector<std::pair<int, int>>& near) {
  faces_.resize(model.vertex.size());
  found_.assign(model.shapes.size(), 0);
  for (const auto& [a, b] : near)
    for (const int block : {a, b}) {
      find(model, block);
      if (surface.whole[size_t(block)]) continue;
      const BlockShape& shape = model.shapes[size_t(block)];
      for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) {
        find(model, surface.leaving[size_t(v)].block);
        find(model, surface.arriving[size_t(v)].block);
      }
    }
}

void Faces::find(const Model& model, int block) {
  if (std::exchange(found_[size_t(block)], 1)) return;
  const int begin = model.shapes[size_t(block)].vertex_begin;
  for (int e = 0; e < model.vertex_count(block); ++e) {
    const Vec2 from = model.vertex[size_t(begin + e)], span = model.vertex[size_t(begin + model.next_vertex(block, e))] - from;
    const double length = span.norm();
    const Vec2 along = span / length;
    faces_[size_t(begin + e)] = {from, along, -perp(along), length};
  }
}

}  // namespace talus
