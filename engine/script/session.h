#pragma once
// One script from start to end: parameters, the simulations it makes, its checks, and the exit status.
#include <functional>
#include <lua.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "script/checkpoint.h"
#include "script/limits.h"
#include "script/run.h"

namespace talus {

struct SessionOptions {
  std::string script;
  std::vector<std::pair<std::string, std::string>> parameters;  // -p name=value
  std::string output_dir;                                       // -o, empty: as the scene says
  std::string restart;                                          // --restart, empty: from the beginning
  bool resume = false;                                          // --resume
  std::optional<CheckpointOptions> checkpoint{};
  Limits limits{};
  bool trust = false;  // --trust
  std::string command_line;
  std::string library{};  // folder of the Lua library; empty: library_folder()
  bool plan_only = false;
  bool estimate = false;     // with plan_only: what the run would take
  bool interactive = false;  // -i
  bool progress = true;
  std::function<void(Run&)> on_run{};  // for every simulation that the script makes, before its first step
  // In a program of one's own: what goes wrong first (else printed to standard error), and what run.json has of each
  // simulation when it is over, in the order of their ends.
  std::function<void(const std::string& message)> on_failure{};
  std::function<void(const Run&, const std::string& report)> on_end{};
  std::string inputs_file{};  // --inputs: where the list of the files that the script was made of goes
  // talus parameters: the script is left at its first simulation, and prints nothing
  bool parameters_only = false;
  // talus sweep: the script is a study; its flat table (lib/talus/study) is on the top of the stack.
  std::function<void(lua_State*, const std::string& library)> on_study{};
};

// Exit status of the program.
enum ExitStatus { exit_ok = 0, exit_check_failed = 1, exit_bad_input = 2, exit_run_stopped = 3 };  // signals: 128 + n

struct DeclaredParameter {
  std::string name, meaning;  // "= 20  (friction angle, degrees)"
  std::string type;           // of its default, in Lua's words
};

class Session {
 public:
  explicit Session(SessionOptions options) : options_(std::move(options)) {}

  // Runs the script, then every simulation it made and never stepped. Prints errors to standard error.
  int execute();

  // What the Lua library asks for (script/native.cpp).
  std::shared_ptr<Run> add_run(Scene scene, RunHandlers handlers);
  // One step of it, or nothing when it is finished; before it what is due between steps. Throws RunError, ScriptError.
  std::optional<StepReport> step(lua_State* L, const std::shared_ptr<Run>& run);
  void release(const std::shared_ptr<Run>& run);  // the script has dropped it: its results are ended
  void add_check(const CheckLine& check);
  void add_result(const ResultLine& result);
  void add_study(lua_State* L, int index);
  void add_note(const std::string& note) { notes_.push_back(note); }  // of the next run that is made
  std::string folder() const;                                         // of the script
  const std::string* parameter(const DeclaredParameter& parameter);   // null: not given
  const std::vector<DeclaredParameter>& declared() const { return known_parameters_; }
  bool trusted() const { return options_.trust; }
  bool plan_only() const { return options_.plan_only; }
  static Session& of(lua_State* L);

 private:
  void read_restart();
  int estimate();
  void find_checkpoint(const std::string& dir, RunSettings& settings) const;
  static int script_main(lua_State* L);
  void run_script(lua_State* L);
  void write_inputs() const;
  void check_parameters() const;
  std::string output_dir(const std::string& wanted, const Place& place);
  void finish(Run& run, const std::string& outcome);
  std::shared_ptr<Run> take(std::vector<std::shared_ptr<Run>>::iterator at);  // out of runs_
  void fail(const std::string& message);                                      // the one that is told

  SessionOptions options_;
  lua_State* L_ = nullptr;                  // while the script runs
  std::string library_;                     // its folder
  std::vector<std::shared_ptr<Run>> runs_;  // made and not released
  bool finishing_ = false;                  // results are being ended
  std::weak_ptr<Run> latest_;
  std::vector<DeclaredParameter> known_parameters_;
  std::set<std::string> output_dirs_;
  std::vector<std::string> notes_;
  std::optional<Restart> restart_;
  std::optional<Checkpoints> checkpoints_;
  bool prompted_ = false;
  long steps_ = 0;
  int runs_made_ = 0, checks_ = 0, failed_checks_ = 0;
  bool failed_ = false, output_failed_ = false;
};

}  // namespace talus
