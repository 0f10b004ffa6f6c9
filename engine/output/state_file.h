#pragma once
// A saved state, in memory or as a file: head, state of the engine, of the run's output and of the script.
#include <string>

#include "model/saved_state.h"

namespace talus {

struct SavedRun {
  int simulation = 1;  // of those its script makes, in order of creation
  long step = 0;
  double time = 0;  // s
  Fingerprint scene;
  std::uint64_t layout = 0;    // of the tables in `engine` and `output`
  std::string talus;           // version and commit that saved it
  std::string engine, output;  // Simulation::save, RunOutput
  std::string script;          // sim.state and the live fields of the script's objects (script/plain_data.h)
};

// Written under a temporary name, brought to disk and renamed: a crash leaves the former file or the new one,
// whole. Throws RunError naming path and reason.
void write_state(const std::string& path, const SavedRun& saved);
// Whether it begins as one: what else lies there is not overwritten by a scene.
bool is_state_file(const std::string& path);
// Throws StateError when it is no file of a state, or not what was written.
SavedRun read_state(const std::string& path);

std::string own_version();

}  // namespace talus
