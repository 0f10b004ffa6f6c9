#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/box_grid.h"
#include "contact/detection.h"

namespace talus {

namespace {

// Of the boxes that NearBlocks keeps: they hold for some steps at present velocities, and for what velocities change by
// meanwhile.
constexpr double steps_ahead = 6, wider = search_margin / 2;

}  // namespace

Box swept_box(const Model& model, int block, std::span<const double> v, double dt) {
  const BlockShape& shape = model.shapes[block];
  Box box{model.vertex[shape.vertex_begin], model.vertex[shape.vertex_begin]};
  for (int k = shape.vertex_begin; k < shape.vertex_end; ++k) {
    box.low = box.low.cwiseMin(model.vertex[k]);
    box.high = box.high.cwiseMax(model.vertex[k]);
  }
  const double turn = std::abs(v[2]) / shape.length * shape.radius * dt, margin = search_margin * shape.length + turn;
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
    if (levels_.empty() || levels_.back().number != entries_[e].level) levels_.push_back({entries_[e].level, e, e});
    levels_.back().end = e + 1;
  }
}

namespace {

// Pairs (places in `blocks`, sorted) whose boxes meet. What is held is near what moves, or of no account; and what is
// held is not sought by it.
std::vector<std::pair<int, int>> that_meet(const Model& model, const std::vector<int>& blocks,
                                           const std::vector<Box>& boxes) {
  struct Part {
    std::vector<int> places;
    std::vector<Box> boxes;
    BoxGrid grid;
    void take(int place, const Box& box) {
      places.push_back(place);
      boxes.push_back(box);
    }
  } moving, held;
  const auto moves = [&](size_t k) { return model.shapes[size_t(blocks[k])].dofs > 0; };
  for (size_t k = 0; k < blocks.size(); ++k)
    if (moves(k)) moving.take(int(k), boxes[k]);
  if (moving.boxes.empty()) return {};
  Box all = moving.boxes[0];
  for (const Box& box : moving.boxes) all = {all.low.cwiseMin(box.low), all.high.cwiseMax(box.high)};
  for (size_t k = 0; k < blocks.size(); ++k)
    if (!moves(k) && boxes[k].meets(all)) held.take(int(k), boxes[k]);
  for (Part* part : {&moving, &held}) part->grid.fill(std::move(part->boxes));

  std::vector<std::pair<int, int>> pairs;
  for (int k = 0; k < moving.grid.count(); ++k) {
    const Box& box = moving.grid.box(k);
    const int level = BoxGrid::level_of(box);
    moving.grid.each_meeting(box, level, [&](int other) {
      if (other > k || BoxGrid::level_of(moving.grid.box(other)) != level)
        pairs.push_back(std::minmax(moving.places[k], moving.places[other]));
    });
    held.grid.each_meeting(box, std::numeric_limits<int>::min(),
                           [&](int other) { pairs.push_back(std::minmax(moving.places[k], held.places[other])); });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

std::vector<std::pair<int, int>> NearBlocks::find(const Model& model, const std::vector<BlockState>& states,
                                                  const std::vector<int>& blocks, double dt) {
  const auto box_of = [&](int block, double time) {
    return swept_box(model, block, states[size_t(block)].velocity, time);
  };
  std::vector<Box> boxes;
  boxes.reserve(blocks.size());
  for (const int b : blocks) boxes.push_back(box_of(b, dt));
  bool within = blocks == blocks_;
  for (size_t k = 0; within && k < boxes.size(); ++k) within = wide_[k].contains(boxes[k]);
  if (!within) {
    blocks_ = blocks;
    wide_.clear();
    for (const int b : blocks)
      wide_.push_back(box_of(b, steps_ahead * dt).grown(wider * model.shapes[size_t(b)].length));
    pairs_ = that_meet(model, blocks, wide_);
  }
  std::vector<std::pair<int, int>> near;
  for (const auto& [a, b] : pairs_)
    if (boxes[size_t(a)].meets(boxes[size_t(b)])) near.push_back({blocks[size_t(a)], blocks[size_t(b)]});
  return near;
}

}  // namespace talus
