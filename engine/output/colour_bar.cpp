#include "output/colour_bar.h"

#include <algorithm>
#include <cmath>

#include "output/text.h"

namespace talus {

namespace {

constexpr double number_size = 12, bar_label_size = 13;  // px
constexpr double outlier_share = 0.02;                   // at either end
constexpr double one_value = 1e-5;  // range / value below which the numbers at the bar would all look the same
constexpr double flattened = 2.5;   // full range / range without outliers from which they are cut off

// Two digits, away from zero or towards it so that the range only grows.
double rounded(double value, bool up) {
  if (value == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
  return (up ? std::ceil(value / unit) : std::floor(value / unit)) * unit;
}

struct BarTick {
  double value;
  std::string text;
};

std::vector<BarTick> bar_ticks(const ColourBar& bar) {
  const ColourScale& scale = bar.scale;
  const double factor = bar.unit.factor;
  const Span shown = {scale.range.low / factor, scale.range.high / factor};
  if (scale.flat) {
    const double value = (shown.low + shown.high) / 2;
    const std::string text = significant(std::abs(value), scale.whole ? 9 : 4);
    return {{value * factor, (value < 0 ? "\u2212" : "") + text}};
  }
  const int wanted = std::clamp(static_cast<int>(bar.length / (bar.upright ? 26 : 60)), 2, 6);
  const auto values = linear_ticks(shown, wanted, scale.whole);
  const double step = values.size() > 1 ? values[1] - values[0] : shown.length();
  const double clear = shown.length() * (bar.upright ? 18 : 60) / bar.length;  // beside the label of a cut end
  std::vector<BarTick> ticks;
  for (const double value : values) {
    const bool covered = (scale.below && value < shown.low + clear) || (scale.above && value > shown.high - clear);
    if (!covered) ticks.push_back({value * factor, tick_text(value, step)});
  }
  if (scale.below) ticks.push_back({scale.range.low, "≤ " + tick_text(shown.low, shown.low)});
  if (scale.above) ticks.push_back({scale.range.high, "≥ " + tick_text(shown.high, shown.high)});
  return ticks;
}

std::string gradient(const ColourBar& bar) {
  constexpr int stops = 32;
  std::string xml = "<defs><linearGradient id=\"bar\" x1=\"0\" x2=\"" + std::string(bar.upright ? "0" : "1") +
                    "\" y1=\"" + (bar.upright ? "1" : "0") + "\" y2=\"0\">";
  for (int k = 0; k <= stops; ++k) {
    const double value = bar.scale.range.low + bar.scale.range.length() * k / stops;
    xml += "<stop offset=\"" + std::to_string(100. * k / stops).substr(0, 5) + "%\" stop-color=\"" +
           colour(bar.scale.map, bar.scale.place(value)) + "\"/>";
  }
  return xml + "</linearGradient></defs>\n";
}

Vec2 along(const ColourBar& bar, double from_low, double across) {
  return bar.upright ? Vec2(bar.corner.x() + across, bar.corner.y() + bar.length - from_low)
                     : Vec2(bar.corner.x() + from_low, bar.corner.y() + across);
}

// A pointed end: there are values beyond.
void draw_point(Svg& svg, const ColourBar& bar, bool high) {
  const double at = high ? bar.length : 0, tip = at + (high ? 9 : -9);
  const Vec2 corners[] = {along(bar, at, 0), along(bar, tip, bar_thickness / 2), along(bar, at, bar_thickness)};
  const std::string fill = colour(bar.scale.map, bar.scale.place(high ? bar.scale.range.high : bar.scale.range.low));
  svg.polyline(corners, true, "fill=\"" + fill + "\" stroke=\"#444\" stroke-width=\"0.8\"");
}

}  // namespace

double ColourScale::place(double value) const {
  if (flat) return 0.5;
  if (map == ColourMap::sequential) return std::clamp((value - range.low) / range.length(), 0.0, 1.0);
  const double largest = std::max(-range.low, range.high);
  return 0.5 + 0.5 * std::clamp(value, range.low, range.high) / largest;
}

int ColourScale::level(double value) const {
  // Numbers that follow each other get levels far apart: steps by the golden section.
  if (categories) return static_cast<int>(levels * std::fmod(std::abs(value) * 0.6180339887498949, 1.0));
  return std::min(levels - 1, static_cast<int>(place(value) * levels));
}

ColourScale colour_scale(std::vector<double> values, bool whole, double noise) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (std::all_of(values.begin(), values.end(), [&](double v) { return std::abs(v) <= noise; })) values = {0};
  std::sort(values.begin(), values.end());
  ColourScale scale;
  scale.whole = whole;
  scale.range = {values.front(), values.back()};
  const double largest = std::max(std::abs(values.front()), std::abs(values.back()));
  if (scale.range.length() <= one_value * largest) {
    scale.flat = true;
    const double half = largest > 0 ? largest / 10 : 1;
    scale.range = {values.front() - half, values.front() + half};
    if (values.front() == 0) scale.map = ColourMap::diverging;  // nothing anywhere: white
    return scale;
  }
  const auto cut = static_cast<std::size_t>(outlier_share * static_cast<double>(values.size()));
  const Span middle = {values[cut], values[values.size() - 1 - cut]};
  if (!whole && middle.length() > 0 && scale.range.length() > flattened * middle.length()) {
    // Only an end that reaches far out is cut.
    scale.below = middle.low - scale.range.low > middle.length() / 2;
    scale.above = scale.range.high - middle.high > middle.length() / 2;
    if (scale.below) scale.range.low = rounded(middle.low, false);
    if (scale.above) scale.range.high = rounded(middle.high, true);
  }
  // Zero belongs on the bar where it is near.
  if (!whole && scale.range.low > 0 && scale.range.low < 0.2 * scale.range.high && !scale.below) scale.range.low = 0;
  if (!whole && scale.range.high < 0 && scale.range.high > 0.2 * scale.range.low && !scale.above) scale.range.high = 0;
  // A trace of the other sign does not make a field one of both signs.
  if (!whole && std::min(-scale.range.low, scale.range.high) > 0.05 * std::max(-scale.range.low, scale.range.high))
    scale.map = ColourMap::diverging;
  return scale;
}

ColourScale given_scale(const Span& range, const std::vector<double>& values, bool whole) {
  ColourScale scale;
  scale.range = range;
  scale.whole = whole;
  // As far as it is drawn: a value that is beyond by rounding is not.
  const double slack = 1e-6 * range.length();
  for (const double value : values) {
    if (value < range.low - slack) scale.below = true;
    if (value > range.high + slack) scale.above = true;
  }
  if (!whole && std::min(-range.low, range.high) > 0.05 * std::max(-range.low, range.high))
    scale.map = ColourMap::diverging;
  return scale;
}

ColourScale category_scale() {
  ColourScale scale;
  scale.map = ColourMap::categories;
  scale.whole = scale.categories = true;
  return scale;
}

double bar_margin(const ColourBar& bar) {
  if (!bar.upright) return bar_thickness + 12 + number_size + 6 + bar_label_size;
  double widest = 0;
  for (const BarTick& tick : bar_ticks(bar)) widest = std::max(widest, text_width(tick.text, number_size));
  return std::max(bar_thickness + 9 + widest, text_width(bar.label, bar_label_size) * (bar.subscripts ? 0.8 : 1));
}

void draw_bar(Svg& svg, const ColourBar& bar) {
  svg.raw(gradient(bar));
  const Vec2 size = bar.upright ? Vec2(bar_thickness, bar.length) : Vec2(bar.length, bar_thickness);
  svg.rectangle(bar.corner, size, "fill=\"url(#bar)\" stroke=\"#444\" stroke-width=\"0.8\"");
  if (bar.scale.below) draw_point(svg, bar, false);
  if (bar.scale.above) draw_point(svg, bar, true);
  for (const BarTick& tick : bar_ticks(bar)) {
    const double at = bar.length * (tick.value - bar.scale.range.low) / bar.scale.range.length();
    svg.line(along(bar, at, bar_thickness), along(bar, at, bar_thickness + 4), "stroke=\"#444\" stroke-width=\"1\"");
    const Vec2 beside = along(bar, at, bar_thickness + 7);
    if (bar.upright) {
      svg.text({beside.x(), beside.y() + 0.36 * number_size}, tick.text, {.size = number_size});
    } else {
      svg.text({beside.x(), beside.y() + number_size}, tick.text, {.size = number_size, .align = Align::middle});
    }
  }
  TextStyle style = {.size = bar_label_size, .subscripts = bar.subscripts};
  if (bar.upright) {
    svg.text(bar.corner - Vec2(0, bar.scale.above ? 18 : 10), bar.label, style);
  } else {
    style.align = Align::middle;
    svg.text(along(bar, bar.length / 2, bar_margin(bar)), bar.label, style);
  }
}

}  // namespace talus
