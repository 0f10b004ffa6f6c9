#pragma once
// What a study's table looks like: each collected number over the parameters that vary. One parameter: a curve;
// two: a map and curves; more: curves in one picture for each combination of the rest. Samples: points over each
// parameter.
#include <string>
#include <vector>

#include "sweep/table.h"

namespace talus {

struct ColumnPlots {
  std::string column;  // name
  std::vector<std::string> svgs;
  std::size_t left_out = 0;  // pictures that would be too many
};

std::vector<ColumnPlots> plots_of(const Study& study, const std::vector<StudyRow>& rows);

}  // namespace talus
