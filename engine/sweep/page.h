#pragma once
// index.html of a study: what was run, plots, the table with links to the runs' folders. One file that needs no
// other.
#include <string>
#include <vector>

#include "sweep/table.h"

namespace talus {

std::string results_page(const Study& study, const std::vector<StudyRow>& rows);

}  // namespace talus
