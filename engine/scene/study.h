#pragma once
// A study: runs of one scene, and what is collected from each. What `talus sweep` works on.
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "scene/error.h"

namespace talus {

struct Setting {  // a parameter of a run
  std::string name, text;
  std::string type;  // in Lua's words: number, string, boolean
  double number = std::nan("");
};

struct StudyRun {
  std::string name;  // of its folder too
  std::vector<Setting> settings;
};

struct StudyColumn {
  std::string name, unit, label;
  bool log = false;
};

struct Cell {
  std::string text{};            // as in the table
  double number = std::nan("");  // for the plots
};

struct Collected {
  std::vector<Cell> cells{};         // one a column
  std::vector<std::string> units{};  // likewise
  std::string problem{};             // what could not be collected
};

struct SlurmResources {
  double seconds = 0, megabytes = 0;  // 0: the cluster's defaults
  int cpus = 1, at_once = 0;
  std::string partition{}, account{};
  std::vector<std::string> extra{};
};

struct Study {
  std::string file;   // the script
  Place place;        // of talus.study in it
  std::string scene;  // path
  std::string title, dir;
  std::string library;                  // folder of the Lua library
  std::vector<std::string> parameters;  // names, in the order of the study
  std::string seed_parameter;           // plots show the mean over it; empty: none
  std::vector<StudyRun> runs;
  std::vector<StudyColumn> columns;
  double time_limit = 0;  // s of wall time a run; 0: none
  SlurmResources slurm;
  // Left in the middle, with a problem, once `stop_asked` has answered yes for a second.
  std::function<Collected(std::size_t run, const std::string& folder, bool (*stop_asked)())> collect;

  std::string folder(std::size_t run) const { return dir + "/runs/" + runs[run].name; }
};

}  // namespace talus
