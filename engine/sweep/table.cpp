#include "sweep/table.h"

#include <algorithm>

#include "output/text.h"

namespace talus {

std::string StudyRow::status() const {
  if (!outcome) return "not run";
  return outcome->good() && !collected.problem.empty() ? "not collected" : outcome->status();
}

std::string StudyRow::message() const {
  if (!outcome) return note;
  return outcome->message.empty() ? collected.problem : outcome->message;
}

std::string unit_of(const Study& study, const std::vector<StudyRow>& rows, std::size_t column) {
  if (!study.columns[column].unit.empty()) return study.columns[column].unit;
  for (const StudyRow& row : rows)
    if (column < row.collected.units.size() && !row.collected.units[column].empty()) return row.collected.units[column];
  return "";
}

const Setting* setting_of(const StudyRun& run, const std::string& name) {
  const auto found = std::ranges::find(run.settings, name, &Setting::name);
  return found == run.settings.end() ? nullptr : &*found;
}

std::string results_table(const Study& study, const std::vector<StudyRow>& rows) {
  std::string text = "run";
  for (const std::string& name : study.parameters) text += "," + csv_cell(name);
  text += ",status";
  for (std::size_t c = 0; c < study.columns.size(); ++c) {
    const std::string unit = unit_of(study, rows, c);
    text += "," + csv_cell(study.columns[c].name + (unit.empty() ? "" : " [" + unit + "]"));
  }
  text += ",message,wall [s],cpu [s]\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const StudyRow& row = rows[r];
    text += csv_cell(study.runs[r].name);
    for (const std::string& name : study.parameters) {
      const Setting* setting = setting_of(study.runs[r], name);
      text += "," + (setting ? csv_cell(setting->text) : "");
    }
    text += "," + row.status();
    for (std::size_t c = 0; c < study.columns.size(); ++c)
      text += "," + (c < row.collected.cells.size() ? csv_cell(row.collected.cells[c].text) : "");
    text += "," + csv_cell(row.message()) + ",";
    if (row.outcome)
      text += fixed(row.outcome->wall, 3) + "," + fixed(row.outcome->cpu, 3);
    else
      text += ",";
    text += "\n";
  }
  return text;
}

}  // namespace talus
