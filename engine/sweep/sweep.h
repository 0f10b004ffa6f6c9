#pragma once
// `talus sweep`: from a study to its table and its page.
#include <string>
#include <vector>

#include "scene/study.h"

namespace talus {

struct SweepOptions {
  int jobs = 0;                        // -j; 0: as many as there are processors
  bool resume = false;                 // --resume: there must be something to go on with
  bool retry = false;                  // --retry: runs that failed are made again
  bool list = false;                   // --list
  bool collect = false;                // --collect: nothing is run
  bool slurm = false, wait = true;     // --slurm, --no-wait
  std::vector<std::string> only{};     // --only: runs by name or number
  std::vector<std::string> command{};  // this sweep again, without the options above
};

// The exit status of the program: 0 all is well, 1 some runs are not, 128 + n stopped by signal n.
int sweep(const Study& study, const SweepOptions& options);

}  // namespace talus
