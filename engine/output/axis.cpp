#include "output/axis.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "output/text.h"

namespace talus {

namespace {

constexpr double tick_size = 12;   // px, of the numbers
constexpr double label_size = 13;  // px, of the axes' labels
constexpr std::string_view minus = "\u2212";

const std::array<std::string, 11> prefixes = {"f", "p", "n", "µ", "m", "", "k", "M", "G", "T", "P"};
const std::array<std::string, 10> superscripts = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

std::string superscript(int number) {
  std::string out = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) out += superscripts[c - '0'];
  return out;
}

// "kg/m3" -> "kg/m³"
std::string with_powers(const std::string& unit) {
  std::string out;
  for (const char c : unit) out += c >= '0' && c <= '9' ? superscripts[c - '0'] : std::string(1, c);
  return out;
}

// A prefix belongs to the unit's first letter: not before a power (mm² is 1e-6 m²), an angle or kilograms.
bool takes_prefix(const std::string& unit) {
  if (unit.empty() || !std::isalpha(static_cast<unsigned char>(unit[0]))) return false;
  if (unit.starts_with("rad") || unit.starts_with("kg")) return false;
  const auto end = unit.find('/');
  return unit.substr(0, end).find_first_of("0123456789") == std::string::npos;
}

double floor_power(double value) {
  return std::pow(10, std::floor(std::log10(value) + 1e-9));
}

// "2·10⁻⁴"
std::string power_text(double value) {
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const double lead = value / std::pow(10, power);
  return (lead > 1.5 ? fixed(lead, 0) + "·" : "") + "10" + superscript(power);
}

struct Tick {
  double value;  // in the axis' own unit
  std::string text;
};

std::vector<Tick> axis_ticks(const Span& span, int wanted, bool log, const ShownUnit& unit) {
  const Span shown = {span.low / unit.factor, span.high / unit.factor};
  const auto values = log ? log_ticks(shown) : linear_ticks(shown, wanted);
  const double step = values.size() > 1 ? values[1] - values[0] : shown.length();
  const bool powers =
      log && !values.empty() && (values.front() < 9e-5 || values.back() > 1.1e5);  // on one axis one style
  std::vector<Tick> ticks;
  for (const double value : values)
    ticks.push_back({value * unit.factor, powers ? power_text(value) : tick_text(value, log ? value : step)});
  return ticks;
}

std::vector<Tick> x_ticks(const Frame& frame, const ShownUnit& unit) {
  for (int wanted = std::max(2, static_cast<int>(frame.width / 95));; --wanted) {
    std::vector<Tick> ticks = axis_ticks(frame.x, wanted, frame.log_x, unit);
    double taken = 0;
    for (const Tick& tick : ticks) taken += text_width(tick.text, tick_size) + tick_size;
    if (taken < frame.width || wanted == 1 || frame.log_x) return ticks;
  }
}

std::vector<Tick> y_ticks(const Span& y, double height, bool log, const ShownUnit& unit) {
  return axis_ticks(y, std::clamp(static_cast<int>(height / 45), 2, 9), log, unit);
}

double fraction(double value, const Span& span, bool log) {
  if (log) return std::log(value / span.low) / std::log(span.high / span.low);
  return (value - span.low) / span.length();
}

}  // namespace

std::vector<double> linear_ticks(const Span& span, int wanted, bool whole) {
  const double rough = span.length() / std::max(1, wanted);
  if (!(rough > 0) || !std::isfinite(rough)) return {span.low};
  const double power = floor_power(rough), lead = rough / power;
  double step = power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
  if (whole) step = std::max(1.0, step);
  std::vector<double> ticks;
  const double slack = 1e-9 * span.length();
  for (double k = std::ceil((span.low - slack) / step); k * step <= span.high + slack; ++k) ticks.push_back(k * step);
  return ticks;
}

std::vector<double> log_ticks(const Span& span) {
  const double decades = std::log10(span.high / span.low);
  const double every = std::max(1.0, std::ceil(decades / 7));
  std::vector<double> ticks;
  for (double k = std::floor(std::log10(span.low)); std::pow(10, k) <= span.high * (1 + 1e-9); k += every)
    for (const double lead : {1., 2., 5.}) {
      const double value = lead * std::pow(10, k);
      const bool inside = value >= span.low * (1 - 1e-9) && value <= span.high * (1 + 1e-9);
      if (inside && (lead == 1 || decades < 3)) ticks.push_back(value);
    }
  return ticks;
}

std::string tick_text(double value, double step) {
  step = std::abs(step);
  if (value != 0 && (std::abs(value) >= 1e7 || step < 1e-6)) return significant(value, 4);
  // Decimals until the step itself is written exactly (0.25 takes two), up to six.
  int decimals = 0;
  double scaled = step;
  while (decimals < 6 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled) {
    scaled *= 10;
    ++decimals;
  }
  const std::string text = fixed(value, decimals);
  return text[0] == '-' ? std::string(minus) + text.substr(1) : text;
}

ShownUnit shown_unit(const std::string& unit, double largest) {
  if (!(largest > 0) || !std::isfinite(largest)) return {1, with_powers(unit)};
  const int thousands = static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  if (takes_prefix(unit)) {
    const int k = std::clamp(thousands, -5, unit == "s" ? 0 : 5);  // no kiloseconds
    return {std::pow(1000, k), prefixes[k + 5] + with_powers(unit)};
  }
  if (largest >= 1e-2 && largest < 1e5) return {1, with_powers(unit)};
  return {std::pow(1000, thousands), "10" + superscript(3 * thousands) + (unit.empty() ? "" : " ") + with_powers(unit)};
}

std::string label(const std::string& symbol, const ShownUnit& unit) {
  if (unit.name.empty()) return symbol;
  const bool compound = unit.name.find_first_of("/ ") != std::string::npos;
  return symbol + " / " + (compound ? "(" + unit.name + ")" : unit.name);
}

std::string quantity(double value, const std::string& unit, int digits) {
  return quantity(value, shown_unit(unit, std::abs(value)), digits);
}

std::string quantity(double value, const ShownUnit& shown, int digits) {
  const std::string number = significant(value / shown.factor, digits);
  return (number[0] == '-' ? std::string(minus) + number.substr(1) : number) + " " + shown.name;
}

Vec2 Frame::at(const Vec2& point) const {
  return {left + width * fraction(point.x(), x, log_x), top + height * (1 - fraction(point.y(), y, log_y))};
}

double text_width(const std::string& text, double size) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 0.62 * size * static_cast<double>(characters);
}

double left_margin(const Span& y, double height, bool log, const ShownUnit& unit) {
  double widest = 0;
  for (const Tick& tick : y_ticks(y, height, log, unit)) widest = std::max(widest, text_width(tick.text, tick_size));
  return widest + 14 + 2 * label_size;
}

void draw_axes(Svg& svg, const Frame& frame, const AxisLabels& labels) {
  const std::string_view thin = "stroke=\"#444\" stroke-width=\"1\" fill=\"none\"";
  const std::string_view grid = "stroke=\"#ddd\" stroke-width=\"0.7\"";
  const double bottom = frame.top + frame.height;
  for (const Tick& tick : x_ticks(frame, labels.x_unit)) {
    const double x = frame.at({tick.value, frame.y.low}).x();
    if (labels.grid) svg.line({x, frame.top}, {x, bottom}, grid);
    svg.line({x, bottom}, {x, bottom + 5}, thin);
    svg.text({x, bottom + 8 + tick_size}, tick.text, {.size = tick_size, .align = Align::middle});
  }
  for (const Tick& tick : y_ticks(frame.y, frame.height, frame.log_y, labels.y_unit)) {
    const double y = frame.at({frame.x.low, tick.value}).y();
    if (labels.grid) svg.line({frame.left, y}, {frame.left + frame.width, y}, grid);
    svg.line({frame.left - 5, y}, {frame.left, y}, thin);
    svg.text({frame.left - 8, y + 0.36 * tick_size}, tick.text, {.size = tick_size, .align = Align::end});
  }
  svg.rectangle({frame.left, frame.top}, {frame.width, frame.height}, thin);
  svg.text({frame.left + frame.width / 2, bottom + 16 + tick_size + label_size}, label(labels.x, labels.x_unit),
           {.size = label_size, .align = Align::middle, .subscripts = true});
  const double margin = left_margin(frame.y, frame.height, frame.log_y, labels.y_unit);
  svg.text({frame.left - margin + label_size, frame.top + frame.height / 2}, label(labels.y, labels.y_unit),
           {.size = label_size, .align = Align::middle, .upright = true, .subscripts = true});
}

}  // namespace talus
