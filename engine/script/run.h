#pragma once
// One simulation of a script with what goes along: its output, progress, handlers and checks.
#include <functional>
#include <lua.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/output.h"
#include "output/state_file.h"
#include "script/laws.h"
#include "step/clock.h"
#include "step/simulation.h"

namespace talus {

struct RunHandlers {
  std::optional<LuaFunction> on_step, on_fracture, on_gas, on_output, stop;
  std::vector<std::pair<std::string, LuaFunction>> fields;  // output.fields
};

struct Restart {
  std::string file;
  SavedRun saved;
  std::string option;  // that asked for it: --restart, --resume
};

struct RunSettings {
  bool writes = true;    // false for `talus plan`
  bool progress = true;  // a progress line on standard error
  std::string command_line;
  int number = 1;                    // of the simulations that the script makes
  std::optional<Restart> restart{};  // the state it is to begin with
};

class Run {
 public:
  enum class Phase { idle, stepping, handling };

  // Builds the model, tries the output fields on the first block, creates the output directory. InputError.
  static std::shared_ptr<Run> create(Scene scene, RunHandlers handlers, const RunSettings& settings);

  // One accepted step, or nothing when the run is finished. Throws RunError, ScriptError.
  std::optional<StepReport> step();
  void frame();  // one output time now
  void stop();
  // Ends the output; once. An empty outcome stands for what the run itself knows: finished, stopped or its error.
  // False where that was done before.
  bool finish(const std::string& outcome);
  std::string report(const std::string& outcome) const;  // run.json, also of a run that writes no results

  // The state between two steps; the script's part is left empty.
  SavedRun save() const;
  // Throws StateError when the state is of another scene, or of a Talus with other tables.
  void check_fits(const SavedRun& saved) const;
  void restore(const SavedRun& saved, const std::string& from);
  const std::optional<Restart>& restart() const { return restart_; }  // that is still to come

  int number() const { return number_; }  // of the simulations that the script makes
  bool stepped() const { return stepped_; }
  // Whether the run has come to its end of itself. One that the script has stopped would go on when it is restored.
  bool ended() const { return simulation.finished() && !simulation.stopped() && !simulation.collapsed(); }
  bool writes() const { return output_ != nullptr; }
  Phase phase() const { return phase_; }
  void add_check(const CheckLine& check) { checks_.push_back(check); }
  void add_result(const ResultLine& result);  // in the place of one of the same name
  // Throws ScriptError(input) with `what` where the model must not be touched: inside a step.
  void refuse_inside_step(lua_State* L, const std::string& what) const;

  Simulation simulation;
  struct CheckpointMark {
    long step = -1;  // -1: none yet
    double at = 0;   // s of the clock
  } checkpoint;      // the last one

  explicit Run(Scene scene) : simulation(std::move(scene)) {}

 private:
  std::string full_outcome(const std::string& outcome) const;
  void begin();
  void tell_notes();  // those that came since
  void start_output(const RunSettings& settings);
  std::uint64_t layout() const;  // of the tables that save() writes
  void check_restart(const Restart& restart) const;
  // Calls it with the simulation and the values that `more` pushes and counts; whether its result is true.
  // asks: for true or false
  bool call_handler(const LuaFunction& handler, const std::function<int(lua_State*)>& more = {}, bool asks = false);

  RunHandlers handlers_;
  std::weak_ptr<Run> self_;
  std::unique_ptr<RunOutput> output_;
  std::optional<Progress> progress_;
  std::vector<CheckLine> checks_;
  std::vector<ResultLine> results_;
  std::optional<Restart> restart_;
  int number_ = 1;
  std::size_t told_ = 0;  // notes
  std::string failure_, command_line_;
  double made_ = wall_seconds();
  Phase phase_ = Phase::idle;
  bool began_ = false, stepped_ = false, stopped_ = false, done_ = false, in_frame_ = false;
};

}  // namespace talus
