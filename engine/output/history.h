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
  // Begins the file with its header, or where `resumed` continues one with the same columns. Columns stay as they
  // are here for the whole run. A table that cannot be continued is kept as history_before.csv.
  HistoryTable(const std::string& path, const Model& model, const Plan& plan, bool resumed);
  // Takes out the rows of steps after `step`. The table as it was is kept as history_before.csv.
  void rewind(long step);
  // `residual`: largest since the row before. The row is on disk when this returns.
  void add(Simulation& simulation, double residual, const std::vector<UserArray>& arrays);

 private:
  void write(const std::string& line);
  void begin(const std::string& content);
  std::string before() const;
  std::string path_;
  std::vector<std::string> moving_;  // names of supports that have columns
  std::ofstream file_;
};

}  // namespace talus
