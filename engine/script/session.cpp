#include "script/session.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "model/saved_state.h"
#include "script/estimate.h"
#include "script/interrupt.h"
#include "script/lua_error.h"
#include "script/lua_state.h"
#include "script/native.h"
#include "script/nearest.h"
#include "script/plan_text.h"
#include "script/prompt.h"
#include "script/saved_view.h"
#include "script/simulation_view.h"
#include "script/written_files.h"

namespace talus {
namespace {

const char session_key = 0, study_key = 0;  // their addresses are keys in Lua's registry

int status_of(const ScriptError& error) {
  switch (error.kind) {
    case ErrorKind::run:
      return exit_run_stopped;
    case ErrorKind::interrupt:
      return interrupt_signal() == SIGALRM ? exit_run_stopped : 128 + interrupt_signal();
    case ErrorKind::planned:
      return exit_ok;
    default:
      return exit_bad_input;
  }
}

Restart read_saved(const std::string& file, const std::string& option) {
  try {
    return {file, read_state(file), option};
  } catch (const StateError& error) {
    throw ScriptError(ErrorKind::input,
                      option + ": expected a saved state, got \"" + file + "\", which " + error.what());
  }
}

// However it is written.
std::string folder_name(const std::string& dir) {
  return std::filesystem::absolute(dir + "/").lexically_normal().string();
}

}  // namespace

Session& Session::of(lua_State* L) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, &session_key);
  auto* session = static_cast<Session*>(lua_touserdata(L, -1));
  lua_pop(L, 1);
  return *session;
}

int Session::execute() {
  constexpr double grace = 2;  // s, for the script to come to a step after a signal
  LuaOptions lua;
  if (options_.limits.memory > 0) {
    bound_memory(options_.limits.memory, options_.limits.memory_text);
    lua.memory_cap = std::min(lua.memory_cap, options_.limits.memory);
  }
  lua.trust = options_.trust;
  lua.library = options_.library;
  if (options_.checkpoint) checkpoints_.emplace(*options_.checkpoint);
  LuaState state(lua);
  lua_State* L = state.get();
  lua_pushlightuserdata(L, this);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &session_key);
  set_search_path(L, options_.script, state.library());
  library_ = state.library();
  L_ = L;
  int status = exit_ok;
  std::string outcome;
  try {
    Interrupts interrupts(L, checkpoints_ ? grace : 0);
    const Limits& limits = options_.limits;
    if (limits.seconds > 0) interrupts.limit_time(limits.seconds, "stopped by " + limits.time_text, exit_run_stopped);
    lua_pushcfunction(L, guarded<script_main>);
    protected_call(L, 0, 0);
  } catch (const ScriptError& error) {
    status = status_of(error);
    outcome = error.what();
    if (status != exit_ok) fail(error.what());
  }
  if (options_.estimate && status == exit_ok) status = estimate();
  // Functions of the script are called for the last results, and may let Lua collect a simulation: see release().
  // Models hold such functions, so that they go before the state does.
  while (!runs_.empty()) finish(*take(runs_.begin()), outcome);
  write_inputs();
  end_time_limit();
  if (status == exit_ok && output_failed_) return exit_run_stopped;
  return status == exit_ok && failed_checks_ > 0 ? exit_check_failed : status;
}

int Session::script_main(lua_State* L) {
  Session::of(L).run_script(L);
  return 0;
}

// What a run in motion would take is tried; handlers and results are left out.
int Session::estimate() {
  for (const auto& run : runs_) {
    try {
      const std::string text = estimate_text(*run);
      std::fprintf(stdout, "estimate for %s\n%s", run->simulation.model.scene.title.c_str(), text.c_str());
    } catch (const std::exception& error) {
      fail(error.what());
      return exit_run_stopped;
    }
  }
  std::fputs("nothing is wrong with it\n", stdout);
  return exit_ok;
}

void Session::read_restart() {
  if (options_.restart.empty()) return;
  std::string file = options_.restart;
  if (std::filesystem::is_directory(file)) {
    file = (std::filesystem::path(file) / checkpoint_name).string();
    if (!std::filesystem::exists(file))
      throw ScriptError(ErrorKind::input, "--restart: expected a saved state or a folder with " +
                                              std::string(checkpoint_name) + " in it, got \"" + options_.restart +
                                              "\", which has none");
  }
  restart_ = read_saved(file, "--restart");
}

// --resume: what the run itself has written.
void Session::find_checkpoint(const std::string& dir, RunSettings& settings) const {
  const std::string& own = options_.checkpoint ? options_.checkpoint->file : std::string();
  const std::string file = checkpoint_file(own, dir, settings.number);
  if ((own.empty() && dir.empty()) || !std::filesystem::exists(file)) return;
  Restart found = read_saved(file, "--resume");
  if (found.saved.simulation == settings.number) settings.restart = std::move(found);
}

void Session::run_script(lua_State* L) {
  read_restart();
  open_native(L);
  if (options_.parameters_only) {
    lua_pushcfunction(L, [](lua_State*) { return 0; });
    lua_setglobal(L, "print");
  }
  run_file(L, options_.script);
  check_parameters();
  if (options_.parameters_only) return;
  if (options_.on_study) {
    if (lua_rawgetp(L, LUA_REGISTRYINDEX, &study_key) == LUA_TNIL)
      throw ScriptError(ErrorKind::input, options_.script + ": expected a study, the script made no talus.study");
    return options_.on_study(L, library_);
  }
  if (runs_made_ == 0 && checks_ == 0) {
    throw ScriptError(ErrorKind::input, options_.script + ": the script made no talus.simulation and no check");
  }
  if (restart_ && restart_->saved.simulation > runs_made_) {
    throw ScriptError(ErrorKind::input, "--restart: expected a state of one of the " + std::to_string(runs_made_) +
                                            " simulations that " + options_.script + " makes, got \"" + restart_->file +
                                            "\", which is of simulation " + std::to_string(restart_->saved.simulation));
  }
  if (options_.plan_only) return;
  for (const auto& run : std::vector(runs_)) {
    if (run->stepped()) continue;
    push_simulation(L, run);  // handlers are given it
    while (step(L, run)) {
    }
    lua_pop(L, 1);
  }
  throw_if_interrupted();
}

std::optional<StepReport> Session::step(lua_State* L, const std::shared_ptr<Run>& run) {
  const Limits& limits = options_.limits;
  resume(L, run);
  if (options_.interactive && !prompted_) {  // steps that are taken at the prompt come here too
    prompted_ = true;
    prompt(L, run);
  }
  const bool enough = limits.steps > 0 && steps_ >= limits.steps && !run->simulation.finished();
  if (checkpoints_) {
    const InterruptsHeld hold;
    checkpoints_->between_steps(L, run, run->ended() || enough || interrupt_signal() != 0);
  }
  throw_if_interrupted();
  if (enough) throw ScriptError(ErrorKind::run, "stopped by " + limits.steps_text);
  try {
    auto report = run->step();
    if (report) ++steps_;
    return report;
  } catch (const ScriptError& error) {
    // Left in the middle of a search for equilibrium: the state is again that from before the step.
    if (checkpoints_ && error.kind == ErrorKind::interrupt && !law_was_left()) {
      const InterruptsHeld hold;
      checkpoints_->between_steps(L, run, true);
    }
    throw;
  }
}

// What goes wrong after something has is most often the same: one message.
void Session::fail(const std::string& message) {
  if (!failed_ && options_.on_failure) options_.on_failure(message);
  if (!failed_ && !options_.on_failure) std::fprintf(stderr, "talus: %s\n", message.c_str());
  failed_ = true;
}

void Session::finish(Run& run, const std::string& outcome) {
  finishing_ = true;
  try {
    if (run.finish(outcome) && options_.on_end) options_.on_end(run, run.report(outcome));
  } catch (const std::exception& error) {
    fail(error.what());
    output_failed_ = true;
  }
  finishing_ = false;
}

void Session::add_study(lua_State* L, int index) {
  const std::string place = user_place(L).text();
  if (!options_.on_study)
    throw ScriptError(ErrorKind::input, place + ": expected talus sweep " + options_.script +
                                            ", as this is a study, got a run of it as a scene");
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &study_key) != LUA_TNIL)
    throw ScriptError(ErrorKind::input, place + ": expected one talus.study in a script, got a second");
  lua_pushvalue(L, index);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &study_key);
}

// At the first simulation already: a run that is killed has a list too.
void Session::write_inputs() const {
  if (options_.inputs_file.empty()) return;
  std::string list;
  for (const ScriptFile& file : noted_files(L_)) list += hex(file.hash) + " " + file.path + "\n";
  try {
    write_whole(options_.inputs_file, list);
  } catch (const RunError& error) {
    std::fprintf(stderr, "talus: %s\n", error.what());
  }
}

std::shared_ptr<Run> Session::add_run(Scene scene, RunHandlers handlers) {
  if (finishing_)
    throw InputError(scene.time.place, "simulation", "to be made by the script",
                     "one made while the last results of another are written");
  check_parameters();
  if (options_.parameters_only) throw ScriptError(ErrorKind::planned, "the parameters are known");
  if (options_.on_study)
    throw InputError(scene.time.place, "simulation", "a study, which names a scene", "a simulation in it");
  if (!options_.plan_only) scene.output.dir = output_dir(scene.output.dir, scene.output.place);
  RunSettings settings{!options_.plan_only, options_.progress && !options_.plan_only, options_.command_line};
  settings.number = runs_made_ + 1;
  if (restart_ && restart_->saved.simulation == settings.number) settings.restart = restart_;
  if (runs_made_ == 0) write_inputs();
  if (options_.resume) find_checkpoint(scene.output.dir, settings);
  auto run = Run::create(std::move(scene), std::move(handlers), settings);
  if (checkpoints_) checkpoints_->check_place(*run);
  ++runs_made_;
  if (const std::string& dir = run->simulation.model.scene.output.dir; !dir.empty())
    output_dirs_.insert(folder_name(dir));
  std::vector<std::string>& notes = run->simulation.notes;
  notes.insert(notes.begin(), notes_.begin(), notes_.end());
  notes_.clear();
  runs_.push_back(run);
  latest_ = run;
  if (options_.on_run) options_.on_run(*run);
  if (options_.plan_only) std::fputs(plan_text(run->simulation).c_str(), stdout);
  return run;
}

void Session::release(const std::shared_ptr<Run>& run) {
  const auto found = std::find(runs_.begin(), runs_.end(), run);
  if (found != runs_.end()) finish(*take(found), "");
}

std::shared_ptr<Run> Session::take(std::vector<std::shared_ptr<Run>>::iterator at) {
  const std::shared_ptr<Run> run = *at;
  runs_.erase(at);
  return run;
}

// -o replaces what the scene says; the second and later simulations of a script get <dir>/2, <dir>/3, …
std::string Session::output_dir(const std::string& wanted, const Place& place) {
  std::string dir = wanted;
  if (options_.output_dir.empty() && !dir.empty() && !options_.trust && !stays_here(dir))
    throw InputError(place, "output.dir", allowed_place, '"' + dir + '"');
  if (!options_.output_dir.empty()) {
    dir = options_.output_dir + (runs_made_ == 0 ? "" : "/" + std::to_string(runs_made_ + 1));
  }
  if (!dir.empty() && output_dirs_.contains(folder_name(dir)))
    throw InputError(place, "output.dir", "a folder of its own for each simulation", '"' + dir + "\" again");
  return dir;
}

void Session::add_check(const CheckLine& check) {
  ++checks_;
  if (!check.pass) ++failed_checks_;
  if (const auto run = latest_.lock()) run->add_check(check);
}

void Session::add_result(const ResultLine& result) {
  if (const auto run = latest_.lock()) run->add_result(result);
}

std::string Session::folder() const {
  return std::filesystem::path(options_.script).parent_path().string();
}

const std::string* Session::parameter(const DeclaredParameter& parameter) {
  known_parameters_.push_back(parameter);
  const auto named = [&](const auto& p) { return p.first == parameter.name; };
  const auto found = std::find_if(options_.parameters.rbegin(), options_.parameters.rend(), named);
  return found == options_.parameters.rend() ? nullptr : &found->second;
}

void Session::check_parameters() const {
  if (options_.parameters_only) return;
  std::vector<std::string> names;
  std::string table;
  for (const DeclaredParameter& known : known_parameters_) {
    names.push_back(known.name);
    table += "\n  " + known.name + "  " + known.meaning;
  }
  for (const auto& [name, value] : options_.parameters) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string near = nearest(name, names);
    throw ScriptError(ErrorKind::input, "-p " + name + "=" + value + ": " + options_.script + " has no such parameter" +
                                            (near.empty() ? "" : "; did you mean \"" + near + "\"?") +
                                            "; before its first simulation it declares" +
                                            (table.empty() ? " none" : table));
  }
}

}  // namespace talus
