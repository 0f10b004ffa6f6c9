#pragma once
// Pictures of a finished run, from its files alone.
#include <optional>
#include <string>
#include <vector>

#include "output/axis.h"
#include "output/results_folder.h"

namespace talus {

struct ResultPicture {
  std::string field = "s1";  // an array of blocks, joints or cracks, or what is derived of one: ux, speed, …; "none"
  std::optional<Span> range = {};  // of the colours
  std::string vectors = {};        // an array of vectors, drawn as arrows; empty: none
  double scale = 1;                // magnification of displacements
  bool cracks = true, edges = true;
  int width = 1200;  // px
};

// Throws InputError with the nearest name where the run has no such field.
std::string draw_result(const ResultsFolder& run, std::size_t frame, const ResultPicture& options);

// One range for a series: that of all its values, but for a few outliers.
Span range_of(const ResultsFolder& run, const std::vector<std::size_t>& frames, const ResultPicture& options);

// Columns of history.csv over its first; those of one unit only. The file's heading names them.
std::string draw_history(const ResultsFolder& run, const std::vector<std::string>& columns);

}  // namespace talus
