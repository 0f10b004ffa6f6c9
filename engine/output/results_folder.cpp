#include "output/results_folder.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "output/pvd.h"
#include "scene/error.h"

namespace talus {

namespace fs = std::filesystem;

namespace {

// Cells of a row of RFC 4180; no cell of ours has a line end in it.
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const char c = row[i];
    if (c == '"' && quoted && i + 1 < row.size() && row[i + 1] == '"') {
      cells.back() += row[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

// "tip.uy [m]"
HistoryColumn column_of(const std::string& heading) {
  const std::size_t open = heading.rfind(" [");
  if (open == std::string::npos || !heading.ends_with(']')) return {heading, "", {}};
  return {heading.substr(0, open), heading.substr(open + 2, heading.size() - open - 3), {}};
}

double number_of(const std::string& cell) {
  double value = NAN;
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

// The value of a line `"title": "…",` of run.json, which Talus writes with a key a line. Empty where there is none.
std::string title_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    const std::string key = "\"title\": \"";
    const std::size_t begin = line.find(key), end = line.rfind('"');
    if (begin == std::string::npos || end < begin + key.size()) continue;
    std::string text;
    for (std::size_t i = begin + key.size(); i < end; ++i) text += line[i == end || line[i] != '\\' ? i : ++i];
    return text;
  }
  return "";
}

}  // namespace

std::vector<HistoryColumn> read_history(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<HistoryColumn> columns;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    const std::vector<std::string> cells = cells_of(line);
    if (number == 1) {
      for (const std::string& heading : cells) columns.push_back(column_of(heading));
      continue;
    }
    if (cells.size() != columns.size() && file.peek() == EOF) break;  // a row cut short by a crash is no row
    if (cells.size() != columns.size())
      throw RunError(path + ":" + std::to_string(number) + ": expected " + std::to_string(columns.size()) +
                     " columns as in the heading, got " + std::to_string(cells.size()));
    for (std::size_t k = 0; k < cells.size(); ++k) columns[k].values.push_back(number_of(cells[k]));
  }
  return columns;
}

ResultsFolder::ResultsFolder(std::string dir) : dir_(std::move(dir)) {
  while (dir_.size() > 1 && dir_.ends_with('/')) dir_.pop_back();
  std::error_code error;
  if (!fs::is_directory(dir_, error)) throw RunError(dir_ + ": expected a run's results folder, got none of this name");
  blocks_ = read_pvd(dir_ + "/blocks.pvd");
  joints_ = read_pvd(dir_ + "/joints.pvd");
  cracks_ = read_pvd(dir_ + "/cracks.pvd");
  if (blocks_.empty())
    throw RunError(
        dir_ +
        ": expected blocks.pvd with a frame or more, got none: is it the output.dir of a run, with output.vtk not"
        " false?");
  title_ = title_in(dir_ + "/run.json");
  if (title_.empty()) title_ = fs::absolute(dir_).lexically_normal().filename().string();
}

const ResultsFolder::Series& ResultsFolder::series(const std::string& name) const {
  return name == "joints" ? joints_ : name == "cracks" ? cracks_ : blocks_;
}

bool ResultsFolder::has(const std::string& name) const {
  return !series(name).empty();
}

std::size_t ResultsFolder::nearest(double time) const {
  const auto closer = [&](const auto& a, const auto& b) { return std::abs(a.first - time) < std::abs(b.first - time); };
  return static_cast<std::size_t>(std::min_element(blocks_.begin(), blocks_.end(), closer) - blocks_.begin());
}

ResultFrame ResultsFolder::blocks(std::size_t frame) const {
  return read_vtp(dir_ + "/" + blocks_[frame].second);
}

std::optional<ResultFrame> ResultsFolder::lines(const std::string& name, std::size_t frame) const {
  const Series& list = series(name);
  if (frame >= list.size()) return std::nullopt;  // a run that was killed between the two
  return read_vtp(dir_ + "/" + list[frame].second);
}

std::vector<HistoryColumn> ResultsFolder::history() const {
  return read_history(dir_ + "/history.csv");
}

}  // namespace talus
