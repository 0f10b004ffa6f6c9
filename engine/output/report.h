#pragma once
// run.json: what was run, with what, how it went.
#include <string>
#include <vector>

#include "step/simulation.h"

namespace talus {

struct RunAccount {
  std::string command_line, outcome;
  double wall_seconds = 0, cpu_seconds = 0;
  std::vector<CheckLine> checks;
  struct Restore {
    std::string from;
    long step = 0;
    double time = 0;  // s
  };
  std::vector<Restore> restores{};
};
std::string run_report(const Simulation& simulation, const RunAccount& account);

}  // namespace talus
