#include "output/history.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <sstream>
#include <string_view>

#include "fracture/cracks.h"
#include "gas/gas.h"
#include "model/fields.h"
#include "output/curves.h"
#include "output/output.h"
#include "output/text.h"
#include "step/energy_terms.h"

namespace talus {

namespace {

constexpr std::array probe_columns = {"ux", "uy", "vx", "vy", "sxx", "syy", "sxy"};

std::string header(const Model& model, const Plan& plan, const std::vector<std::string>& moving) {
  std::string line = "time [s],step,dt [s],";
  for (const EnergyTerm* term : energy_terms(plan)) line += term->column + " [J/m],";
  line += "closed_contacts,max_residual";
  if (plan.fracture) line += ",failed_bonds,tension_cracks [m],shear_cracks [m],fragments";
  if (plan.gas)
    for (const HoleWall& wall : model.hole_walls)
      for (const char* what : {".volume [m3/m]", ".joined [m3/m]", ".pressure [Pa]"})
        line += "," + csv_cell(model.scene.charges[wall.charge].name + what);
  for (const std::string& name : moving)
    for (const char* axis : {".ux [m]", ".uy [m]", ".reaction_x [N/m]", ".reaction_y [N/m]"})
      line += "," + csv_cell(name + axis);
  for (const ProbePoint& probe : model.probes)
    for (const char* column : probe_columns) {
      const Field& field = *find_field(probe_fields(), column);
      line += "," + csv_cell(model.scene.probes[probe.probe].name + "." + field.name + " [" + field.unit + "]");
    }
  for (const auto& [name, value] : model.scene.output.fields)
    for (const char* what : {".min", ".mean", ".max"}) line += "," + csv_cell(name + what);
  return line;
}

// The file's lines up to its last line end: a row cut short by a crash is no row.
std::string whole_lines(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  std::string lines = content.str();
  lines.resize(lines.rfind('\n') + 1);
  return lines;
}

long step_of(const std::string& row) {
  long step = -1;
  const std::size_t begin = row.find(',') + 1;
  std::from_chars(row.data() + begin, row.data() + row.size(), step);
  return step;
}

}  // namespace

HistoryTable::HistoryTable(const std::string& path, const Model& model, const Plan& plan, bool resumed)
    : path_(path), moving_(moving_names(model, plan)) {
  const std::string columns = header(model, plan, moving_) + "\n";
  std::string content;
  if (resumed) content = whole_lines(path);
  const bool same_columns = content.starts_with(columns);
  if (!same_columns && !content.empty()) write_whole(before(), content);
  begin(same_columns ? content : columns);
}

std::string HistoryTable::before() const {
  return path_.substr(0, path_.size() - std::string_view(".csv").size()) + "_before.csv";
}

void HistoryTable::begin(const std::string& content) {
  file_.close();
  write_whole(path_, content);
  file_.open(path_, std::ios::binary | std::ios::app);
}

void HistoryTable::rewind(long step) {
  const std::string content = whole_lines(path_);
  std::string kept;
  for (std::size_t from = 0, end = 0; from < content.size(); from = end) {
    end = content.find('\n', from) + 1;
    if (from == 0 || step_of(content.substr(from, end - from)) <= step) kept += content.substr(from, end - from);
  }
  if (kept == content) return;
  write_whole(before(), content);
  begin(kept);
}

void HistoryTable::write(const std::string& line) {
  errno = 0;
  const auto before = file_.tellp();
  file_ << line << '\n' << std::flush;
  if (file_) return;
  const int reason = errno;
  file_.close();  // without the half of a row
  std::error_code none;
  std::filesystem::resize_file(path_, std::uintmax_t(std::max<std::streamoff>(before, 0)), none);
  throw RunError("cannot write " + path_ + ": " + (reason != 0 ? std::strerror(reason) : "unknown reason"));
}

void HistoryTable::add(Simulation& simulation, double residual, const std::vector<UserArray>& arrays) {
  const Model& model = simulation.model;
  const FieldContext context = {model, model.probes.empty() ? nullptr : simulation.recovery()};
  std::string line =
      shortest(model.time) + "," + std::to_string(simulation.totals.steps) + "," + shortest(simulation.last.dt) + ",";
  const Energies energies = simulation.energies();
  for (const EnergyTerm* term : energy_terms(simulation.plan)) line += shortest(energies.*term->value) + ",";
  line += std::to_string(simulation.last.closed_contacts) + "," + shortest(residual);
  if (simulation.plan.fracture) {
    const CrackLengths cracks = crack_lengths(model);
    const int fragments = 1 + *std::max_element(model.fragment.begin(), model.fragment.end());
    line += "," + std::to_string(cracks.joints) + "," + shortest(cracks.tension) + "," + shortest(cracks.shear) + "," +
            std::to_string(fragments);
  }
  if (simulation.plan.gas)
    for (size_t wall = 0; wall < model.hole_walls.size(); ++wall) {
      const Chamber& chamber = simulation.gas()->chambers()[simulation.gas()->chamber_of(int(wall))];
      line += "," + shortest(chamber.volume) + "," + shortest(chamber.joined) + "," + shortest(chamber.pressure);
    }
  for (const MovingSupport& support : moving_supports(simulation, moving_))
    for (const Vec2& pair : {support.shift, support.reaction})
      line += "," + shortest(pair.x()) + "," + shortest(pair.y());
  for (int probe = 0; probe < static_cast<int>(model.probes.size()); ++probe)
    for (const char* column : probe_columns) {
      double value = 0;
      find_field(probe_fields(), column)->get(context, probe, &value);
      line += "," + shortest(value);
    }
  for (const UserArray& array : arrays) {
    const auto [least, most] = std::minmax_element(array.values.begin(), array.values.end());
    const double sum = std::accumulate(array.values.begin(), array.values.end(), 0.0);
    line +=
        "," + shortest(*least) + "," + shortest(sum / static_cast<double>(array.values.size())) + "," + shortest(*most);
  }
  write(line);
}

}  // namespace talus
