#include "sweep/plots.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "output/plot.h"
#include "output/text.h"
#include "sweep/map.h"

namespace talus {

namespace {

constexpr std::size_t most_series = 7, most_pictures = 12;  // colours of a plot; panels of a column
constexpr double wide_range = 20;  // largest value / least, from which an axis may be logarithmic

// A parameter as an axis: its numbers, or for texts their places in the list of them.
struct Axis {
  std::string name = {}, label = {};
  std::vector<double> of_run = {};            // nan where the run leaves it to the scene
  std::map<double, std::string> levels = {};  // value -> text
  bool numbers = true, log = false;
};

std::string spaced(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

// Whether the values are spread evenly by factors rather than by differences.
bool spread_by_factors(const std::map<double, std::string>& levels) {
  if (levels.size() < 3) return false;
  const double low = levels.begin()->first, high = levels.rbegin()->first;
  if (low <= 0 || high / low < wide_range) return false;
  const double middle = std::next(levels.begin(), static_cast<long>(levels.size() / 2))->first;
  return std::abs(std::log(middle / std::sqrt(low * high))) < std::abs(std::log(middle / ((low + high) / 2)));
}

Axis axis_of(const Study& study, const std::string& name) {
  Axis axis{.name = name, .label = spaced(name)};
  std::map<std::string, double> places;
  for (const StudyRun& run : study.runs) {
    const Setting* setting = setting_of(run, name);
    if (!setting) continue;
    axis.numbers = axis.numbers && setting->type == "number";
    places.try_emplace(setting->text, static_cast<double>(places.size() + 1));
  }
  for (const StudyRun& run : study.runs) {
    const Setting* setting = setting_of(run, name);
    axis.of_run.push_back(!setting ? std::nan("") : axis.numbers ? setting->number : places[setting->text]);
    if (setting) axis.levels[axis.of_run.back()] = setting->text;
  }
  axis.log = axis.numbers && spread_by_factors(axis.levels);
  if (!axis.numbers) {
    axis.label += ":";
    for (const auto& [value, text] : axis.levels) axis.label += " " + fixed(value, 0) + " " + text + ",";
    axis.label.pop_back();
  }
  return axis;
}

// The study's axes that vary, seeds apart.
std::vector<Axis> varying(const Study& study) {
  std::vector<Axis> axes;
  for (const std::string& name : study.parameters) {
    if (name == study.seed_parameter) continue;
    Axis axis = axis_of(study, name);
    if (axis.levels.size() > 1) axes.push_back(std::move(axis));
  }
  // Numbers make the better x axis.
  std::ranges::stable_sort(axes, [](const Axis& a, const Axis& b) { return a.numbers > b.numbers; });
  return axes;
}

// More levels than a grid of so many runs has: a sample.
bool is_sample(const std::vector<Axis>& axes, std::size_t runs) {
  double combinations = 1;
  for (const Axis& axis : axes) combinations *= static_cast<double>(axis.levels.size());
  return axes.size() > 1 && combinations > 4 * static_cast<double>(runs);
}

// One column's values over the runs.
struct Values {
  const StudyColumn* column = nullptr;
  std::string unit;
  std::vector<double> of_run;
};

// Mean over the runs that agree in x (and were chosen): x -> mean.
std::map<double, double> means(const Axis& x, const Values& values, const std::vector<std::size_t>& runs) {
  std::map<double, std::pair<double, int>> sums;
  for (const std::size_t run : runs) {
    if (!std::isfinite(x.of_run[run]) || !std::isfinite(values.of_run[run])) continue;
    auto& [sum, count] = sums[x.of_run[run]];
    sum += values.of_run[run];
    ++count;
  }
  std::map<double, double> result;
  for (const auto& [at, sum] : sums) result[at] = sum.first / sum.second;
  return result;
}

Plot new_plot(const Axis& x, const Values& values, const std::string& title) {
  return {.title = title,
          .x_label = x.label,
          .x_unit = "",
          .y_label = values.column->label,
          .y_unit = values.unit,
          .log_x = x.log,
          .log_y = values.column->log,
          .width = 600,
          .height = 400};
}

void add_curve(Plot& plot, const std::string& name, const Axis& x, const Values& values,
               const std::vector<std::size_t>& runs) {
  Series series{.name = name, .markers = true};
  for (const auto& [at, mean] : means(x, values, runs)) {
    series.x.push_back(at);
    series.y.push_back(mean);
  }
  series.line = x.numbers;
  plot.series.push_back(series);
}

void add_points(Plot& plot, const std::string& name, const Axis& x, const Values& values,
                const std::vector<std::size_t>& runs) {
  Series series{.name = name, .markers = true, .line = false};
  for (const std::size_t run : runs) {
    series.x.push_back(x.of_run[run]);
    series.y.push_back(values.of_run[run]);
  }
  plot.series.push_back(series);
}

// Runs that agree in one axis, by its levels.
std::map<double, std::vector<std::size_t>> groups(const Axis& axis, const std::vector<std::size_t>& runs) {
  std::map<double, std::vector<std::size_t>> result;
  for (const std::size_t run : runs)
    if (std::isfinite(axis.of_run[run])) result[axis.of_run[run]].push_back(run);
  return result;
}

std::string draw_curves(const Axis& x, const Axis& group, const Values& values, const std::vector<std::size_t>& runs,
                        const std::string& title) {
  Plot plot = new_plot(x, values, title);
  for (const auto& [level, members] : groups(group, runs))
    add_curve(plot, spaced(group.name) + " = " + group.levels.at(level), x, values, members);
  return draw_plot(plot);
}

std::string draw_two(const Axis& x, const Axis& y, const Values& values, const std::vector<std::size_t>& runs,
                     bool cells, const std::string& title) {
  ValueMap map{.title = title,
               .x_label = x.label,
               .y_label = y.label,
               .label = values.column->label,
               .unit = values.unit,
               .cells = cells,
               .log_x = x.log,
               .log_y = y.log,
               .width = 600,
               .height = 400};
  for (const auto& [level, members] : groups(y, runs))
    for (const auto& [at, mean] : means(x, values, members)) {
      map.at.emplace_back(at, level);
      map.values.push_back(mean);
    }
  return map.at.empty() ? "" : draw_map(map);
}

struct Panel {
  std::string title;
  std::vector<std::size_t> runs;
};

// The runs by all combinations of the axes from `first` on.
std::vector<Panel> panels(const std::vector<Axis>& axes, std::size_t first, const std::vector<std::size_t>& runs) {
  std::vector<Panel> list = {{"", runs}};
  for (std::size_t a = first; a < axes.size(); ++a) {
    std::vector<Panel> finer;
    for (const Panel& panel : list)
      for (const auto& [level, members] : groups(axes[a], panel.runs))
        finer.push_back(
            {panel.title + (panel.title.empty() ? "" : ", ") + spaced(axes[a].name) + " = " + axes[a].levels.at(level),
             members});
    list = std::move(finer);
  }
  return list;
}

void draw_grid(ColumnPlots& plots, const std::vector<Axis>& axes, const Values& values,
               const std::vector<std::size_t>& runs) {
  const Axis &x = axes[0], &y = axes[1];
  const bool curves = y.levels.size() <= most_series, map = axes.size() == 2 || !curves;
  for (const Panel& panel : panels(axes, 2, runs)) {
    if (plots.svgs.size() >= most_pictures) {
      ++plots.left_out;
      continue;
    }
    if (map) plots.svgs.push_back(draw_two(x, y, values, panel.runs, true, panel.title));
    if (curves) plots.svgs.push_back(draw_curves(x, y, values, panel.runs, panel.title));
  }
}

void draw_sample(ColumnPlots& plots, const std::vector<Axis>& axes, const Values& values,
                 const std::vector<std::size_t>& runs) {
  if (axes.size() == 2) plots.svgs.push_back(draw_two(axes[0], axes[1], values, runs, false, ""));
  for (const Axis& x : axes) {
    if (plots.svgs.size() >= most_pictures) {
      ++plots.left_out;
      continue;
    }
    Plot plot = new_plot(x, values, "");
    add_points(plot, "", x, values, runs);
    plots.svgs.push_back(draw_plot(plot));
  }
}

void draw_one(ColumnPlots& plots, const Axis& x, const Values& values, const std::vector<std::size_t>& runs,
              bool seeds) {
  Plot plot = new_plot(x, values, "");
  add_curve(plot, seeds ? "mean over the seeds" : "", x, values, runs);
  if (seeds) add_points(plot, "each", x, values, runs);
  plots.svgs.push_back(draw_plot(plot));
}

}  // namespace

std::vector<ColumnPlots> plots_of(const Study& study, const std::vector<StudyRow>& rows) {
  std::vector<Axis> axes = varying(study);
  if (axes.empty() && !study.seed_parameter.empty()) axes.push_back(axis_of(study, study.seed_parameter));
  std::vector<ColumnPlots> all;
  for (std::size_t c = 0; c < study.columns.size(); ++c) {
    Values values{&study.columns[c], unit_of(study, rows, c), {}};
    std::vector<std::size_t> runs;
    for (std::size_t run = 0; run < rows.size(); ++run) {
      const auto& cells = rows[run].collected.cells;
      values.of_run.push_back(c < cells.size() ? cells[c].number : std::nan(""));
      if (std::isfinite(values.of_run.back())) runs.push_back(run);
    }
    if (runs.empty() || axes.empty()) continue;
    ColumnPlots plots{study.columns[c].name, {}, 0};
    if (axes.size() == 1) {
      draw_one(plots, axes[0], values, runs, !study.seed_parameter.empty() && axes[0].name != study.seed_parameter);
    } else if (is_sample(axes, study.runs.size())) {
      draw_sample(plots, axes, values, runs);
    } else {
      draw_grid(plots, axes, values, runs);
    }
    all.push_back(std::move(plots));
  }
  return all;
}

}  // namespace talus
