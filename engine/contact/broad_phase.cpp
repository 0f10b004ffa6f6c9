#include <algorithm>
#include <cmath>
#include <cstdint>

#include "contact/detection.h"

namespace talus {

namespace {

struct Box {
  Vec2 low, high;
  bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

// A block lies in the level whose cells are at least as large as its box, so it covers at most four of them.
struct Entry {
  int level;
  std::int64_t x, y;
  int block;
  friend auto operator<=>(const Entry&, const Entry&) = default;
};

Box swept_box(const Model& model, int block, double dt) {
  const BlockShape& shape = model.shapes[block];
  Box box{model.vertex[shape.vertex_begin], model.vertex[shape.vertex_begin]};
  for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) {
    box.low = box.low.cwiseMin(model.vertex[v]);
    box.high = box.high.cwiseMax(model.vertex[v]);
  }
  const auto& v = model.blocks[block].velocity;
  const double turn = std::abs(v[2]) / shape.length * shape.radius * dt, margin = search_margin * shape.length + turn;
  const Vec2 motion(v[0] * dt, v[1] * dt);
  box.low += motion.cwiseMin(0) - Vec2(margin, margin);
  box.high += motion.cwiseMax(0) + Vec2(margin, margin);
  return box;
}

template <typename Visit>
void cells_of(const Box& box, double size, Visit visit) {
  const auto cell = [size](double x) { return std::int64_t(std::floor(x / size)); };
  for (std::int64_t x = cell(box.low.x()); x <= cell(box.high.x()); ++x)
    for (std::int64_t y = cell(box.low.y()); y <= cell(box.high.y()); ++y) visit(x, y);
}

}  // namespace

std::vector<std::pair<int, int>> broad_phase(const Model& model, const std::vector<int>& blocks, double dt) {
  const int count = int(blocks.size());
  std::vector<Box> boxes(count);
  std::vector<int> level(count), levels;
  std::vector<Entry> entries;
  for (int k = 0; k < count; ++k) {
    boxes[k] = swept_box(model, blocks[k], dt);
    level[k] = int(std::ceil(std::log2((boxes[k].high - boxes[k].low).maxCoeff())));
    cells_of(boxes[k], std::ldexp(1.0, level[k]),
             [&](std::int64_t x, std::int64_t y) { entries.push_back({level[k], x, y, k}); });
    levels.push_back(level[k]);
  }
  std::sort(entries.begin(), entries.end());
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());

  std::vector<std::pair<int, int>> pairs;
  for (int k = 0; k < count; ++k) {
    const auto visit = [&](int at, std::int64_t x, std::int64_t y) {
      for (auto e = std::lower_bound(entries.begin(), entries.end(), Entry{at, x, y, 0});
           e != entries.end() && e->level == at && e->x == x && e->y == y; ++e) {
        const int other = e->block;
        if (at == level[k] && other <= k) continue;
        if (model.shapes[blocks[k]].dofs == 0 && model.shapes[blocks[other]].dofs == 0) continue;
        if (boxes[k].meets(boxes[other])) pairs.push_back(std::minmax(blocks[k], blocks[other]));
      }
    };
    for (auto at = std::lower_bound(levels.begin(), levels.end(), level[k]); at != levels.end(); ++at)
      cells_of(boxes[k], std::ldexp(1.0, *at), [&](std::int64_t x, std::int64_t y) { visit(*at, x, y); });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace talus
