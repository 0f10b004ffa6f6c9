#pragma once
// history.csv: one row per output time with totals, probes and the range of user arrays.
#include <fstream>
#include <string>
#include <vector>

#include "output/user_arrays.h"
#include "step/simulation.h"

namespace talus {

class HistoryTable {
 public:
  // Begins the file with its header. Columns stay as they are here for the whole run.
  HistoryTable(const std::string& path, const Model& model, const Plan& plan);
  // `residual`: largest since the row before. The row is on disk when this returns.
  void add(Simulation& simulation, double residual, const std::vector<UserArray>& arrays);

 private:
  void write(const std::string& line);
  std::string path_;
  std::ofstream file_;
};

}  // namespace talus
