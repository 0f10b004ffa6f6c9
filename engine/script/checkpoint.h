#pragma once
// --checkpoint: the state of the simulation that is being stepped, written now and then.
#include <lua.hpp>
#include <memory>
#include <string>

#include "script/run.h"

namespace talus {

struct CheckpointOptions {
  double seconds = 0;  // of the clock, between two; or
  long steps = 0;
  std::string file;  // empty: checkpoint_name in the run's own output folder; see checkpoint_file
};

constexpr const char* checkpoint_name = "checkpoint.state";
// Of the simulation of this number: the first has the file that was asked for, if one was, the others their number
// behind its name.
std::string checkpoint_file(const std::string& asked, const std::string& dir, int simulation);

class Checkpoints {
 public:
  explicit Checkpoints(CheckpointOptions options) : options_(std::move(options)) {}

  // Throws InputError where there is no place to write to.
  void check_place(const Run& run) const;
  // Between two steps: before each, and once more when the run has ended or is to stop (`last`). A state that nothing
  // has been added to is not written again.
  void between_steps(lua_State* L, const std::shared_ptr<Run>& run, bool last);

 private:
  bool due(const Run& run) const;
  std::string file(const Run& run) const;
  void write(lua_State* L, const std::shared_ptr<Run>& run);

  CheckpointOptions options_;
  bool failed_ = false;
};

}  // namespace talus
