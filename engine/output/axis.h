#pragma once
// What pictures and plots share: ticks, labels with SI prefixes, and the drawing of a frame with its axes.
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "output/svg.h"

namespace talus {

struct Span {
  double low = 0, high = 1;
  double length() const { return high - low; }
};

// Round values (1, 2 or 5 times a power of ten apart; whole numbers only if asked), about `wanted` of them.
std::vector<double> linear_ticks(const Span& span, int wanted, bool whole = false);
std::vector<double> log_ticks(const Span& span);  // powers of ten, and 2 and 5 times them in a short span

// "−0.25": as many decimals as ticks `step` apart need.
std::string tick_text(double value, double step);

// How numbers up to `largest` of a unit are shown: value / factor, under the name "kPa", "mm", "10⁻³ m²".
struct ShownUnit {
  double factor = 1;
  std::string name;
};
ShownUnit shown_unit(const std::string& unit, double largest);
std::string label(const std::string& symbol, const ShownUnit& unit);          // "σ_xx / kPa"
std::string quantity(double value, const std::string& unit, int digits = 3);  // "5 kN/m"
std::string quantity(double value, const ShownUnit& unit, int digits = 3);

// A rectangle of the drawing (px, y down) that shows `x` × `y`.
struct Frame {
  double left = 0, top = 0, width = 0, height = 0;
  Span x, y;
  bool log_x = false, log_y = false;
  Vec2 at(const Vec2& point) const;
};

double text_width(const std::string& text, double size);  // px, about

// Ticks with numbers at the left and the bottom, thin grid lines if asked, and the axes' labels.
struct AxisLabels {
  std::string x, y;
  ShownUnit x_unit, y_unit;
  bool grid = false;
};
void draw_axes(Svg& svg, const Frame& frame, const AxisLabels& labels);
double left_margin(const Span& y, double height, bool log,
                   const ShownUnit& unit);  // px that its numbers and label need

}  // namespace talus
