#include "geometry/segment_grid.h"

#include <algorithm>
#include <cmath>

namespace talus {

SegmentGrid::SegmentGrid(const std::vector<Segment>& segments, double margin) {
  Polyline ends;
  for (const Segment& s : segments) {
    ends.push_back(s.a);
    ends.push_back(s.b);
  }
  if (ends.empty()) ends.push_back(Vec2::Zero());
  box_ = bounds(ends);
  box_.min.array() -= margin;
  box_.max.array() += margin;

  // About as many bins as segments.
  constexpr int most = 2048;
  const Vec2 sides = box_.max - box_.min;
  const double count = static_cast<double>(segments.size()) + 1;
  bin_ = std::max(std::sqrt(sides.x() * sides.y() / count), sides.maxCoeff() / most);
  if (!(bin_ > 0)) bin_ = 1;
  columns_ = std::clamp(static_cast<int>(sides.x() / bin_) + 1, 1, most + 1);
  rows_ = std::clamp(static_cast<int>(sides.y() / bin_) + 1, 1, most + 1);

  begin_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Segment& s : segments) for_each_bin(s, margin, [&](int bin) { ++begin_[bin + 1]; });
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  items_.resize(begin_.back());
  std::vector<int> at(begin_.begin(), begin_.end() - 1);
  for (int i = 0; i < static_cast<int>(segments.size()); ++i)
    for_each_bin(segments[i], margin, [&](int bin) { items_[at[bin]++] = i; });
}

int SegmentGrid::column(double x) const {
  return static_cast<int>(std::clamp((x - box_.min.x()) / bin_, 0.0, columns_ - 1.0));
}

int SegmentGrid::row(double y) const {
  return static_cast<int>(std::clamp((y - box_.min.y()) / bin_, 0.0, rows_ - 1.0));
}

// Column by column: the rows that the part of the segment over this column runs through.
template <class Visit>
void SegmentGrid::for_each_bin(const Segment& segment, double margin, const Visit& visit) const {
  const bool forward = segment.a.x() <= segment.b.x();
  const Vec2 &a = forward ? segment.a : segment.b, &b = forward ? segment.b : segment.a;
  const Vec2 along = b - a;
  const int first = column(a.x() - margin), last = column(b.x() + margin);
  for (int c = first; c <= last; ++c) {
    double t0 = 0, t1 = 1;
    if (along.x() > 0) {
      const double left = box_.min.x() + c * bin_;
      t0 = std::clamp((left - margin - a.x()) / along.x(), 0.0, 1.0);
      t1 = std::clamp((left + bin_ + margin - a.x()) / along.x(), 0.0, 1.0);
    }
    const double y0 = a.y() + t0 * along.y(), y1 = a.y() + t1 * along.y();
    const int bottom = row(std::min(y0, y1) - margin), top = row(std::max(y0, y1) + margin);
    for (int r = bottom; r <= top; ++r) visit(r * columns_ + c);
  }
}

std::span<const int> SegmentGrid::near(const Vec2& point) const {
  const int bin = row(point.y()) * columns_ + column(point.x());
  return {items_.data() + begin_[bin], items_.data() + begin_[bin + 1]};
}

std::vector<std::pair<int, int>> SegmentGrid::pairs() const {
  std::vector<std::pair<int, int>> found;
  for (std::size_t bin = 0; bin + 1 < begin_.size(); ++bin)
    for (int i = begin_[bin]; i < begin_[bin + 1]; ++i)
      for (int j = i + 1; j < begin_[bin + 1]; ++j) found.emplace_back(items_[i], items_[j]);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace talus
