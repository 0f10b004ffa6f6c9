#pragma once
// run.json: what was run, with what, how it went.
#include <string>
#include <variant>
#include <vector>

#include "equations/error_estimate.h"
#include "step/simulation.h"

namespace talus {

// What a script has found out: talus.result. A number, or a text or truth as it is written.
struct ResultLine {
  std::string name, unit;
  std::variant<double, std::string, bool> value;
};

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
  std::vector<ResultLine> results{};
  std::vector<ErrorNorm> errors{};  // per region, where they were asked for
};
std::string run_report(const Simulation& simulation, const RunAccount& account);

}  // namespace talus
