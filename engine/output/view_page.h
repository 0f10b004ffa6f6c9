#pragma once
// A finished run as one page that needs nothing else: time slider, fields, picking, histories. What the page does is in
// view/*.js.
#include <string>
#include <vector>

#include "output/results_folder.h"

namespace talus {

struct ViewOptions {
  std::vector<std::string> fields = {};  // arrays of blocks and joints; empty: all but strain and s1_direction
  int every = 1;                         // frames: one of so many, and the last
};

// Throws RunError or InputError where files or fields are missing.
std::string view_page(const ResultsFolder& run, const ViewOptions& options);

}  // namespace talus
