#pragma once
// results.csv: one row a run, in the order of the study. Apart from the last two columns, wall and CPU time, it is
// the same byte for byte whenever the same runs are finished.
#include <optional>
#include <string>
#include <vector>

#include "scene/study.h"
#include "sweep/outcome.h"

namespace talus {

struct StudyRow {
  std::optional<Outcome> outcome{};  // none: not run
  Collected collected{};
  std::string note{};  // why it was not run, where that is known

  std::string status() const;
  std::string message() const;
  bool good() const { return outcome && outcome->good() && collected.problem.empty(); }
};

// The unit of a column: the study's, else that of what was collected.
std::string unit_of(const Study& study, const std::vector<StudyRow>& rows, std::size_t column);

std::string results_table(const Study& study, const std::vector<StudyRow>& rows);

// The parameter of that name; null where the run leaves it to the scene.
const Setting* setting_of(const StudyRun& run, const std::string& name);

}  // namespace talus
