#pragma once
// Which numbers get which colours, and the bar that says so.
#include <string>
#include <vector>

#include "output/axis.h"
#include "output/colour_map.h"
#include "output/svg.h"

namespace talus {

struct ColourScale {
  static constexpr int levels = 128;
  ColourMap map = ColourMap::sequential;
  Span range;
  bool below = false, above = false;  // some values lie outside the range
  bool flat = false;                  // one value only
  bool whole = false;
  bool categories = false;  // colours only tell one number from the next; there is no bar

  double place(double value) const;  // 0–1 in the map
  int level(double value) const;
  static double place_of(int level) { return (level + 0.5) / levels; }
};

// Values of both signs: white at zero, equal steps to both sides. A few outliers that would flatten the rest
// (2 % at either end) are cut off. Non-finite values are left out. Where none is larger than `noise` all count as
// 0.
ColourScale colour_scale(std::vector<double> values, bool whole, double noise = 0);
// The range that is wanted; `below`, `above` say whether the values go beyond it.
ColourScale given_scale(const Span& range, const std::vector<double>& values, bool whole);
ColourScale category_scale();

struct ColourBar {
  ColourScale scale;
  ShownUnit unit;
  std::string label;
  bool subscripts = false;  // in the label
  Vec2 corner = Vec2::Zero();
  double length = 0;  // px
  bool upright = true;
};
constexpr double bar_thickness = 16;      // px
double bar_margin(const ColourBar& bar);  // px beside its corner, across its length, for numbers and label
void draw_bar(Svg& svg, const ColourBar& bar);

}  // namespace talus
