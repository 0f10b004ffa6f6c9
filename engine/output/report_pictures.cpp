#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "output/files.h"
#include "output/plot.h"
#include "output/report_page.h"
#include "output/results_folder.h"

namespace talus {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_file = 2'000'000;  // bytes; a plot of more is not for a page
constexpr std::size_t least_rows = 4;               // of a table that is worth a curve

// <dir>/*.svg of this run, but not the frames of the series.
std::vector<ReportPicture> plots_in(const std::string& dir, fs::file_time_type began) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(dir, error)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".svg" || (name.starts_with("picture_") && frame_number(name) >= 0)) continue;
    if (entry.last_write_time(error) >= began && entry.file_size(error) <= largest_file) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<ReportPicture> plots;
  for (const fs::path& path : paths) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    plots.push_back({path.filename().string(), content.str()});
  }
  return plots;
}

struct ProbePlot {
  const char *title, *unit, *label;
  std::vector<const char*> columns;
};

const std::vector<ProbePlot>& probe_plots() {
  static const std::vector<ProbePlot> plots = {{"Displacement of the probes", "m", "u", {"ux", "uy"}},
                                               {"Velocity of the probes", "m/s", "v", {"vx", "vy"}},
                                               {"Stress at the probes", "Pa", "σ", {"sxx", "syy", "sxy"}}};
  return plots;
}

std::vector<ReportPicture> probe_curves(const std::string& dir, const Model& model) {
  constexpr std::size_t most_probes = 6;  // of more a plot could not be read
  std::vector<ReportPicture> pictures;
  if (model.probes.empty() || model.scene.probes.size() > most_probes) return pictures;
  const std::vector<HistoryColumn> history = read_history(dir + "/history.csv");
  if (history.empty() || history.front().values.size() < least_rows) return pictures;
  for (const ProbePlot& what : probe_plots()) {
    Plot plot = {.title = what.title, .y_label = what.label, .y_unit = what.unit};
    for (const Probe& probe : model.scene.probes)
      for (const char* column : what.columns)
        for (const HistoryColumn& known : history)
          if (known.name == probe.name + "." + column)
            plot.series.push_back({.name = known.name, .x = history.front().values, .y = known.values});
    const bool moves = std::any_of(plot.series.begin(), plot.series.end(), [](const Series& series) {
      return std::any_of(series.y.begin(), series.y.end(), [](double value) { return value != 0; });
    });
    if (moves) pictures.push_back({"", draw_plot(plot)});
  }
  return pictures;
}

}  // namespace

std::vector<ReportPicture> report_pictures(const std::string& dir, const Model& model, const std::string& state,
                                           fs::file_time_type began) {
  std::vector<ReportPicture> pictures;
  if (!state.empty()) pictures.push_back({"the last state", state});
  for (auto& more : {plots_in(dir, began), probe_curves(dir, model)})
    pictures.insert(pictures.end(), more.begin(), more.end());
  return pictures;
}

}  // namespace talus
