#pragma once
// A finished run's folder, for the commands that show it: its series of frames, history.csv and title.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "output/vtk_reader.h"

namespace talus {

struct HistoryColumn {
  std::string name, unit;  // "tip.uy", "m"
  std::vector<double> values;
};

class ResultsFolder {
 public:
  explicit ResultsFolder(std::string dir);  // throws RunError where there is no blocks.pvd

  using Series = std::vector<std::pair<double, std::string>>;  // time (s), file
  const std::string& dir() const { return dir_; }
  const std::string& title() const { return title_; }
  const Series& times() const { return blocks_; }
  bool has(const std::string& series) const;  // "blocks", "joints", "cracks"
  std::size_t nearest(double time) const;     // frame

  ResultFrame blocks(std::size_t frame) const;
  // Joints or cracks of that frame; nothing where the run wrote none.
  std::optional<ResultFrame> lines(const std::string& series, std::size_t frame) const;
  std::vector<HistoryColumn> history() const;  // empty where there is no history.csv

 private:
  const Series& series(const std::string& name) const;
  std::string dir_, title_;
  Series blocks_, joints_, cracks_;
};

std::vector<HistoryColumn> read_history(const std::string& path);  // throws RunError with file and line

}  // namespace talus
