#include "script/run.h"

#include <unistd.h>

#include <iostream>

#include "gas/gas.h"
#include "model/fields.h"
#include "output/report.h"
#include "script/fracture_view.h"
#include "script/gas_view.h"
#include "script/interrupt.h"
#include "script/lua_error.h"
#include "script/simulation_view.h"
#include "script/table_view.h"
#include "step/part_timer.h"
#include "step/step_parts.h"

namespace talus {
namespace {

class PhaseScope {
 public:
  PhaseScope(Run::Phase& phase, Run::Phase now) : phase_(phase), before_(phase) { phase = now; }
  ~PhaseScope() { phase_ = before_; }
  PhaseScope(const PhaseScope&) = delete;
  PhaseScope& operator=(const PhaseScope&) = delete;

 private:
  Run::Phase& phase_;
  Run::Phase before_;
};

// A user field of a block: function(block) -> number.
double call_field(const std::weak_ptr<Run>& run, const std::string& name, const LuaFunction& function, int block) {
  lua_State* L = function.state();
  const std::shared_ptr<Run> alive = run.lock();
  const std::string label = alive->simulation.model.scene.output.place.text() + ": output.fields." + name +
                            ": for block " + std::to_string(block + 1);
  LawResult result;
  const RunningLaw running(L);
  try {
    luaL_checkstack(L, 4, "a field");
    function.push();
    push_item(L, alive, ViewKind::blocks, block);
    protected_call(L, 1, 1);
    result = pop_number(L);
  } catch (const ScriptError& error) {
    if (error.kind == ErrorKind::interrupt) throw;
    throw LawError(label + " the function failed: " + error.what());
  }
  if (!result.problem.empty()) throw LawError(label + ": " + result.problem);
  return result.value;
}

}  // namespace

std::shared_ptr<Run> Run::create(Scene scene, RunHandlers handlers, const RunSettings& settings) {
  const auto self = std::make_shared<std::weak_ptr<Run>>();
  for (const auto& [name, function] : handlers.fields) {
    if (name == "id" || find_field(block_fields(), name))
      throw InputError(scene.output.place, "output.fields", "a name that no field of blocks has", '"' + name + '"');
    scene.output.fields.emplace_back(
        name, [self, name, function](int block) { return call_field(*self, name, function, block); });
  }
  if (handlers.on_output) {
    scene.output.on_frame = [self] {
      if (const auto run = self->lock()) run->call_handler(*run->handlers_.on_output);
    };
  }
  auto run = std::make_shared<Run>(std::move(scene));
  *self = run;
  run->self_ = run;
  run->handlers_ = std::move(handlers);
  try {
    for (const auto& [name, field] : run->simulation.model.scene.output.fields) field(0);
  } catch (const RunError& error) {
    throw ScriptError(ErrorKind::input, error.what());
  }
  run->simulation.step_parts().on_equilibrium_solve = throw_if_interrupted;
  run->number_ = settings.number;
  run->command_line_ = settings.command_line;
  run->restart_ = settings.restart;
  if (settings.restart) run->check_restart(*settings.restart);  // before results that lie there are touched
  if (settings.writes) run->start_output(settings);
  return run;
}

void Run::start_output(const RunSettings& settings) {
  if (!simulation.model.scene.output.dir.empty()) {
    output_ = std::make_unique<RunOutput>(simulation, settings.command_line, settings.restart.has_value());
    simulation.on_step.emplace_back([this](Simulation& s) { output_->after_step(s); });
  }
  const auto after_steps = [this](const std::optional<LuaFunction>& handler, auto call) {
    if (!handler) return;
    simulation.on_step.emplace_back([call](Simulation& s) {
      if (s.last.step > 0) call(s);
    });
  };
  after_steps(handlers_.on_fracture, [this](Simulation& s) {
    if (s.fractures().empty()) return;
    call_handler(*handlers_.on_fracture, [&s](lua_State* L) { return push_fractures(L, s); });
  });
  after_steps(handlers_.on_gas, [this](Simulation& s) {
    if (s.gas_events().empty()) return;
    call_handler(*handlers_.on_gas, [&s](lua_State* L) { return push_gas_events(L, s); });
  });
  after_steps(handlers_.on_step, [this](Simulation&) { call_handler(*handlers_.on_step); });
  after_steps(handlers_.stop, [this](Simulation& s) {
    if (call_handler(*handlers_.stop, {}, true)) s.stop();
  });
  if (!settings.progress) return;
  progress_.emplace(isatty(STDERR_FILENO) == 1);
  simulation.on_step.emplace_back([this](Simulation& s) { progress_->after_step(s); });
}

bool Run::call_handler(const LuaFunction& handler, const std::function<int(lua_State*)>& more, bool asks) {
  const PhaseScope handling(phase_, Phase::handling);
  const InterruptsHeld let_through(false);
  lua_State* L = handler.state();
  try {
    luaL_checkstack(L, 4, "a handler");
    handler.push();
    push_simulation(L, self_.lock());
    const int own = more ? more(L) : 0;
    protected_call(L, 1 + own, 1);
    const bool truth = lua_toboolean(L, -1), answers = lua_isboolean(L, -1) || lua_isnil(L, -1);
    const std::string given = asks && !answers ? describe(L, -1) : "";
    lua_pop(L, 1);
    if (asks && !answers)
      throw LawError(simulation.model.scene.time.place.text() +
                     ": simulation.stop: expected true, false or nothing to be returned, got " + given);
    return truth;
  } catch (const ScriptError& error) {
    if (error.kind != ErrorKind::input) throw;
    throw LawError(error.what());
  }
}

std::optional<StepReport> Run::step() {
  if (simulation.finished()) return std::nullopt;
  throw_if_interrupted();
  stepped_ = true;
  try {
    const PhaseScope stepping(phase_, Phase::stepping);
    const InterruptsHeld hold;
    if (!began_) begin();
    if (!began_ && output_) output_->after_step(simulation);  // the start
    began_ = true;
    simulation.step();
    for (const std::string& note : early_venting(simulation)) simulation.notes.push_back(note);
    tell_notes();
  } catch (const LawError& error) {
    failure_ = error.what();
    throw;
  } catch (const RunError& error) {
    const Place& place = simulation.model.scene.time.place;  // the line of talus.simulation
    failure_ = (place.file.empty() ? "" : place.text() + ": ") + error.what();
    throw RunError(failure_);
  } catch (const std::exception&) {
    failure_ = current_error().what();
    throw;
  }
  return simulation.last;
}

void Run::begin() {
  simulation.begin();
  tell_notes();
}

void Run::tell_notes() {
  const Place& place = simulation.model.scene.time.place;  // the line of talus.simulation
  for (; told_ < simulation.notes.size(); ++told_)
    std::cerr << "note: " << (place.file.empty() ? "" : place.text() + ": ") << simulation.notes[told_] << '\n';
}

std::uint64_t Run::layout() const {
  Fnv hash;
  hash.add(hex(simulation.layout()) + hex(RunOutput::layout()));
  return hash.value();
}

SavedRun Run::save() const {
  StateWriter results;
  if (output_) output_->visit_state(results);
  return {.simulation = number_,
          .step = simulation.totals.steps,
          .time = simulation.model.time,
          .scene = simulation.scene_fingerprint(),
          .layout = layout(),
          .talus = own_version(),
          .engine = simulation.save(),
          .output = std::move(results.bytes),
          .script = {}};
}

void Run::check_fits(const SavedRun& saved) const {
  if (saved.layout != layout())
    throw StateError("was saved by Talus " + saved.talus + ", which keeps other tables than this one, " +
                     own_version());
  check_same_scene(saved.scene, simulation.scene_fingerprint());
}

void Run::check_restart(const Restart& restart) const {
  try {
    check_fits(restart.saved);
  } catch (const StateError& error) {
    throw InputError(simulation.model.scene.time.place, restart.option, "a state saved from this scene",
                     '"' + restart.file + "\", which " + error.what());
  }
}

void Run::restore(const SavedRun& saved, const std::string& from) {
  check_fits(saved);
  simulation.restore(saved.engine);
  restart_.reset();
  failure_.clear();
  stopped_ = false;
  began_ = simulation.begun();
  if (!output_) return;
  StateReader results(saved.output);
  if (!saved.output.empty()) output_->visit_state(results);
  output_->rewind(simulation, from);
}

void Run::frame() {
  if (!output_ || in_frame_ || restart_) return;  // what is still to be restored has these frames
  in_frame_ = true;
  try {
    output_->frame(simulation);
  } catch (...) {
    in_frame_ = false;
    throw;
  }
  in_frame_ = false;
}

void Run::stop() {
  stopped_ = true;
  simulation.stop();
}

void Run::add_result(const ResultLine& result) {
  std::erase_if(results_, [&](const ResultLine& one) { return one.name == result.name; });
  results_.push_back(result);
}

std::string Run::full_outcome(const std::string& outcome) const {
  const char* own = simulation.finished() && !stopped_ ? "finished" : "stopped";
  const std::string& known = failure_.empty() ? outcome : failure_;
  return known.empty() ? own : known;
}

bool Run::finish(const std::string& outcome) {
  if (done_) return false;
  done_ = true;
  if (began_ && progress_) progress_->done(simulation, outcome.empty() && failure_.empty());
  if (output_) output_->finish(simulation, full_outcome(outcome), checks_, results_);
  return true;
}

std::string Run::report(const std::string& outcome) const {
  return run_report(simulation, {.command_line = command_line_,
                                 .outcome = full_outcome(outcome),
                                 .wall_seconds = wall_seconds() - made_,
                                 .cpu_seconds = cpu_seconds(),
                                 .checks = checks_,
                                 .results = results_});
}

void Run::refuse_inside_step(lua_State* L, const std::string& what) const {
  if (phase_ != Phase::stepping) return;
  throw ScriptError(ErrorKind::input, user_place(L).text() + ": " + what + " cannot be used inside a step (in a law)");
}

}  // namespace talus
