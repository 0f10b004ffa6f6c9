#pragma once
// How a run of a study ended: run.done in its folder, written whole when the run is over. A folder without it
// holds a run that was not finished.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace talus {

struct InputFile {
  std::string path;  // from the scene's folder on, so that a project can be moved; or "<library>/…"
  std::uint64_t hash = 0;
};

struct Outcome {
  std::uint64_t key = 0;  // of what the run was made with, sweep/key.h
  int exit_status = 0;    // of the engine; 0 where a signal ended it
  int signal = 0;
  double time_limit = 0;     // s, that stopped it; 0: none did
  double wall = 0, cpu = 0;  // s
  std::string message{};     // what went wrong
  std::vector<InputFile> inputs{};

  // Whether it would end so again, good or bad: what a signal from outside ended is run again.
  bool final() const { return time_limit > 0 || (signal == 0 && exit_status >= 0 && exit_status <= 3); }
  bool good() const { return final() && exit_status == 0 && time_limit == 0; }
  bool has_results() const { return final() && exit_status <= 1 && time_limit == 0; }
  std::string status() const;  // "done", "check failed", "bad input", "stopped", "time limit", "killed", "failed"
};

std::optional<Outcome> read_outcome(const std::string& folder);  // nothing where there is none, or not a whole one
void write_outcome(const std::string& folder, const Outcome& outcome);
void remove_outcome(const std::string& folder);

// What the run itself says of its end: the message in its log, or the checks that failed.
std::string message_of_log(const std::string& log, int exit_status, int signal);

}  // namespace talus
