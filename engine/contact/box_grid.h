#pragma once
// Boxes of blocks, in a hierarchical grid: a box lies in the level whose cells are at least as large, so it covers
// at most four of them, whatever the sizes of the others.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "model/model.h"

namespace talus {

struct Box {
  Vec2 low, high;
  bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  bool contains(const Box& other) const {
    return (low.array() <= other.low.array()).all() && (other.high.array() <= high.array()).all();
  }
  Box grown(double margin) const { return {low - Vec2(margin, margin), high + Vec2(margin, margin)}; }
};

// Of a block, grown by its motion in `dt`, of which the first three rates are asked for, and by search_margin of its
// length.
Box swept_box(const Model& model, int block, std::span<const double> velocity, double dt);

class BoxGrid {
 public:
  void fill(std::vector<Box> boxes);
  // visit(number) for each box that meets `box`, of the levels from `from` on; a number may come up to four times.
  template <typename Visit>
  void each_meeting(const Box& box, int from, Visit visit) const {
    for (const Level& level : levels_)
      if (level.number >= from)
        each_in(level, box, [&](int k) {
          if (boxes_[k].meets(box)) visit(k);
        });
  }
  int count() const { return int(boxes_.size()); }
  const Box& box(int k) const { return boxes_[k]; }
  static int level_of(const Box& box);

 private:
  struct Entry {
    int level;
    std::int64_t x, y;
    int box;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  struct Level {
    int number;
    std::size_t begin, end;  // of entries_
  };
  struct Cells {
    std::int64_t x0, x1, y0, y1;
  };
  static Cells cells_of(const Box& box, int level);

  template <typename Visit>
  void each_in(const Level& level, const Box& box, Visit visit) const {
    const Cells cells = cells_of(box, level.number);
    const auto begin = entries_.begin() + long(level.begin), end = entries_.begin() + long(level.end);
    if (double(cells.x1 - cells.x0 + 1) * double(cells.y1 - cells.y0 + 1) > double(end - begin)) {
      for (auto e = begin; e != end; ++e)
        visit(e->box);  // a large box among small ones covers more cells than there are
      return;
    }
    for (std::int64_t x = cells.x0; x <= cells.x1; ++x)  // of one x, cells lie behind each other
      for (auto e = std::lower_bound(begin, end, Entry{level.number, x, cells.y0, 0});
           e != end && e->x == x && e->y <= cells.y1; ++e)
        visit(e->box);
  }

  std::vector<Box> boxes_;
  std::vector<Entry> entries_;  // sorted
  std::vector<Level> levels_;
};

}  // namespace talus
