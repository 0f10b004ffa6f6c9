#include "sweep/map.h"

#include <algorithm>
#include <cmath>

#include "output/axis.h"
#include "output/colour_bar.h"
#include "output/text.h"

namespace talus {

namespace {

constexpr double number_size = 12;  // px, of the values in their cells

// Where one value ends and the next begins: midway, also beyond the first and the last.
struct Levels {
  std::vector<double> values;  // ascending, each once
  std::vector<double> edges;
  Span span() const { return {edges.front(), edges.back()}; }
  std::size_t of(double value) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
  }
};

Levels levels(const std::vector<Vec2>& at, int axis, bool log) {
  Levels result;
  for (const Vec2& point : at) result.values.push_back(point[axis]);
  std::ranges::sort(result.values);
  const auto doubled = std::ranges::unique(result.values);
  result.values.erase(doubled.begin(), doubled.end());
  std::vector<double> places;
  for (const double value : result.values) places.push_back(log ? std::log(value) : value);
  const std::size_t n = places.size();
  const double lone = log ? 0.5 : std::max(0.5, 0.1 * std::abs(places[0]));
  const double first = n > 1 ? places[1] - places[0] : lone, last = n > 1 ? places[n - 1] - places[n - 2] : lone;
  result.edges.push_back(places[0] - first / 2);
  for (std::size_t i = 1; i < n; ++i) result.edges.push_back((places[i - 1] + places[i]) / 2);
  result.edges.push_back(places[n - 1] + last / 2);
  if (log)
    for (double& edge : result.edges) edge = std::exp(edge);
  return result;
}

void draw_cells(Svg& svg, const Frame& frame, const ValueMap& map, const ColourScale& scale, const ShownUnit& unit,
                const Levels& x, const Levels& y) {
  for (std::size_t i = 0; i < map.at.size(); ++i) {
    if (!std::isfinite(map.values[i])) continue;
    const std::size_t column = x.of(map.at[i].x()), row = y.of(map.at[i].y());
    const Vec2 corner = frame.at({x.edges[column], y.edges[row + 1]}),
               other = frame.at({x.edges[column + 1], y.edges[row]});
    const std::string fill = colour(scale.map, scale.place(map.values[i]));
    svg.rectangle(corner, other - corner, "fill=\"" + fill + "\"");
    const std::string number = significant(map.values[i] / unit.factor, 3);
    if (text_width(number, number_size) + 4 > other.x() - corner.x() || number_size + 4 > other.y() - corner.y())
      continue;
    const Vec2 middle = (corner + other) / 2;
    svg.text({middle.x(), middle.y() + 0.36 * number_size}, number,
             {.size = number_size, .align = Align::middle, .colour = dark(fill, 130) ? "#fff" : "#222"});
  }
}

void draw_discs(Svg& svg, const Frame& frame, const ValueMap& map, const ColourScale& scale) {
  for (std::size_t i = 0; i < map.at.size(); ++i)
    if (std::isfinite(map.values[i]))
      svg.circle(frame.at(map.at[i]), 7,
                 "fill=\"" + colour(scale.map, scale.place(map.values[i])) + "\" stroke=\"#444\" stroke-width=\"0.8\"");
}

}  // namespace

std::string draw_map(const ValueMap& map) {
  const Levels x = levels(map.at, 0, map.log_x), y = levels(map.at, 1, map.log_y);
  const ColourScale scale = colour_scale(map.values, false);
  const ShownUnit unit = shown_unit(map.unit, std::max(std::abs(scale.range.low), std::abs(scale.range.high)));
  ColourBar bar = {.scale = scale, .unit = unit, .label = label(map.label, unit), .subscripts = true};
  const double right = bar_margin(bar) + 30;
  const double top = map.title.empty() ? 30 : 44;
  Frame frame = {.top = top,
                 .height = map.height - top - 52,
                 .x = x.span(),
                 .y = y.span(),
                 .log_x = map.log_x,
                 .log_y = map.log_y};
  frame.left = 10 + left_margin(frame.y, frame.height, frame.log_y, {});
  frame.width = map.width - frame.left - right;
  Svg svg;
  if (!map.title.empty()) svg.text({frame.left, 26}, map.title, {.size = 16, .bold = true});
  if (map.cells) draw_cells(svg, frame, map, scale, unit, x, y);
  draw_axes(svg, frame, {.x = map.x_label, .y = map.y_label, .x_unit = {}, .y_unit = {}, .grid = !map.cells});
  if (!map.cells) draw_discs(svg, frame, map, scale);
  bar.corner = {frame.left + frame.width + 18, frame.top};
  bar.length = frame.height;
  draw_bar(svg, bar);
  return svg.file(map.width, map.height);
}

}  // namespace talus
