#include <algorithm>
#include <cmath>

#include "contact/box_grid.h"
#include "contact/detection.h"

namespace talus {

Box swept_box(const Model& model, int block, const std::array<double, max_dofs>& v, double dt) {
  const BlockShape& shape = model.shapes[block];
  Box box{model.vertex[shape.vertex_begin], model.vertex[shape.vertex_begin]};
  for (int k = shape.vertex_begin; k < shape.vertex_end; ++k) {
    box.low = box.low.cwiseMin(model.vertex[k]);
    box.high = box.high.cwiseMax(model.vertex[k]);
  }
  const double turn = std::abs(v[2]) / shape.length * shape.radius * dt,
               margin = search_margin * shape.length + turn;
  const Vec2 motion(v[0] * dt, v[1] * dt);
  box.low += motion.cwiseMin(0) - Vec2(margin, margin);
  box.high += motion.cwiseMax(0) + Vec2(margin, margin);
  return box;
}

int BoxGrid::level_of(const Box& box) {
  return int(std::ceil(std::log2((box.high - box.low).maxCoeff())));
}

BoxGrid::Cells BoxGrid::cells_of(const Box& box, int level) {
  const auto cell = [size = std::ldexp(1.0, level)](double x) { return std::int64_t(std::floor(x / size)); };
  return {cell(box.low.x()), cell(box.high.x()), cell(box.low.y()), cell(box.high.y())};
}

void BoxGrid::fill(std::vector<Box> boxes) {
  boxes_ = std::move(boxes);
  entries_.clear();
  levels_.clear();
  for (int k = 0; k < count(); ++k) {
    const int level = level_of(boxes_[k]);
    const Cells cells = cells_of(boxes_[k], level);
    for (std::int64_t x = cells.x0; x <= cells.x1; ++x)
      for (std::int64_t y = cells.y0; y <= cells.y1; ++y) entries_.push_back({level, x, y, k});
  }
  std::sort(entries_.begin(), entries_.end());
  for (size_t e = 0; e < entries_.size(); ++e) {
    if (levels_.empty() || levels_.back().number != entries_[e].level)
      levels_.push_back({entries_[e].level, e, e});
    levels_.back().end = e + 1;
  }
}

std::vector<std::pair<int, int>> broad_phase(const Model& model, const std::vector<BlockState>& states, const std::vector<int>& blocks,
                                             double dt) {
  std::vector<Box> boxes;
  for (const int b : blocks) boxes.push_back(swept_box(model, b, states[b].velocity, dt));
  BoxGrid grid;
  grid.fill(std::move(boxes));
  std::vector<std::pair<int, int>> pairs;
  for (int k = 0; k < grid.count(); ++k) {
    const int level = BoxGrid::level_of(grid.box(k));
    grid.each_meeting(grid.box(k), level, [&](int other) {
      if (other <= k && BoxGrid::level_of(grid.box(other)) == level) return;
      if (model.shapes[blocks[k]].dofs == 0 && model.shapes[blocks[other]].dofs == 0) return;
      pairs.push_back(std::minmax(blocks[k], blocks[other]));
    });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace talus
