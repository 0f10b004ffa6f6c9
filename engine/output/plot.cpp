#include "output/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "output/axis.h"

namespace talus {

namespace {

constexpr double plot_title_size = 16, legend_size = 13, legend_line = 20, sample = 26;  // px

// Colours that are told apart by colour-blind readers too (Okabe & Ito 2008).
constexpr std::array<std::string_view, 7> palette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                     "#e69f00", "#56b4e9", "#222222"};

std::string_view colour_of(std::size_t series) {
  return palette[series % palette.size()];
}

bool usable(double value, bool log) {
  return std::isfinite(value) && (!log || value > 0);
}

// The range of the values with a little room; of one value a range around it.
Span padded(const std::vector<const std::vector<double>*>& columns, bool log, double share) {
  Span span = {INFINITY, -INFINITY};
  for (const auto* column : columns)
    for (const double value : *column) {
      if (!usable(value, log)) continue;
      span.low = std::min(span.low, value);
      span.high = std::max(span.high, value);
    }
  if (!(span.low <= span.high)) return log ? Span{1, 10} : Span{0, 1};
  if (log) {
    const double room = std::max(std::pow(span.high / span.low, share), 1.1);
    return {span.low / room, span.high * room};
  }
  const double largest = std::max(std::abs(span.low), std::abs(span.high));
  const double room = span.length() > 1e-12 * largest ? share * span.length() : largest > 0 ? largest / 10 : 1;
  return {span.low - room, span.high + room};
}

// One scale for both axes: the frame gets as low as the values are flat, or their range wider than they need.
void make_equal(Frame& frame) {
  const double lowest = frame.width / 5, wanted = frame.width * frame.y.length() / frame.x.length();
  const double height = std::clamp(wanted, lowest, std::max(lowest, frame.height));
  if (wanted > height) {
    const double room = (frame.width * frame.y.length() / height - frame.x.length()) / 2;
    frame.x = {frame.x.low - room, frame.x.high + room};
  } else {
    frame.y.high = frame.y.low + frame.x.length() * height / frame.width;
  }
  frame.height = height;
}

double largest_of(const Span& span) {
  return std::max(std::abs(span.low), std::abs(span.high));
}

std::string line_style(const Series& series, std::size_t index) {
  return "fill=\"none\" stroke-width=\"1.8\" stroke-linejoin=\"round\" stroke=\"" + std::string(colour_of(index)) +
         "\"" + (series.dashed ? " stroke-dasharray=\"7 4\"" : "");
}

// Legend entries in rows from `left`; returns how many rows.
int draw_legend(Svg& svg, const Plot& plot, double left, double right, double top) {
  double x = left;
  int rows = 0;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.name.empty()) continue;
    const double wide = sample + 8 + text_width(series.name, legend_size) + 18;
    if (rows == 0 || x + wide > right) {
      x = left;
      ++rows;
    }
    const double y = top + legend_line * (rows - 0.5);
    const Vec2 ends[] = {{x, y}, {x + sample, y}};
    if (series.line) svg.polyline(ends, false, line_style(series, i));
    if (series.markers) svg.circle({x + sample / 2, y}, 3.5, "fill=\"" + std::string(colour_of(i)) + "\"");
    svg.text({x + sample + 8, y + 0.36 * legend_size}, series.name, {.size = legend_size});
    x += wide;
  }
  return rows;
}

void draw_series(Svg& svg, const Frame& frame, const Series& series, std::size_t index) {
  std::vector<Vec2> run;
  const auto finish = [&] {
    if (series.line && run.size() > 1) svg.polyline(run, false, line_style(series, index));
    run.clear();
  };
  for (std::size_t k = 0; k < std::min(series.x.size(), series.y.size()); ++k) {
    if (!usable(series.x[k], frame.log_x) || !usable(series.y[k], frame.log_y)) {
      finish();
      continue;
    }
    const Vec2 at = frame.at({series.x[k], series.y[k]});
    if (series.markers) svg.circle(at, 3.5, "fill=\"" + std::string(colour_of(index)) + "\"");
    if (run.empty() || (at - run.back()).norm() > 0.3) run.push_back(at);  // a long history has many rows a px
  }
  finish();
}

}  // namespace

std::string draw_plot(const Plot& plot) {
  std::vector<const std::vector<double>*> xs, ys;
  for (const Series& series : plot.series) {
    xs.push_back(&series.x);
    ys.push_back(&series.y);
  }
  Frame frame = {.x = padded(xs, plot.log_x, plot.log_x ? 0.05 : 0),
                 .y = padded(ys, plot.log_y, 0.05),
                 .log_x = plot.log_x,
                 .log_y = plot.log_y};
  // Powers of ten say themselves what they are: prefixes are for linear axes.
  const ShownUnit x_unit = shown_unit(plot.x_unit, plot.log_x ? 1 : largest_of(frame.x));
  const ShownUnit y_unit = shown_unit(plot.y_unit, plot.log_y ? 1 : largest_of(frame.y));
  const double title = plot.title.empty() ? 10 : 18 + plot_title_size;
  frame.left = 10 + left_margin(frame.y, plot.height - 120., frame.log_y, y_unit);
  frame.width = plot.width - frame.left - 24;
  Svg svg;
  if (!plot.title.empty())
    svg.text({frame.left, 10 + plot_title_size}, plot.title, {.size = plot_title_size, .bold = true});
  const int rows = draw_legend(svg, plot, frame.left, plot.width - 10., title);
  frame.top = title + legend_line * rows + 8;
  frame.height = plot.height - frame.top - 52;
  if (plot.equal) make_equal(frame);
  draw_axes(svg, frame, {.x = plot.x_label, .y = plot.y_label, .x_unit = x_unit, .y_unit = y_unit, .grid = true});
  for (std::size_t i = 0; i < plot.series.size(); ++i) draw_series(svg, frame, plot.series[i], i);
  return svg.file(plot.width, frame.top + frame.height + 52);
}

}  // namespace talus
