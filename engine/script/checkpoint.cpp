#include "script/checkpoint.h"

#include <iostream>

#include "script/lua_error.h"
#include "script/saved_view.h"
#include "script/simulation_view.h"
#include "step/clock.h"
#include "step/part_timer.h"

namespace talus {

std::string checkpoint_file(const std::string& asked, const std::string& dir, int simulation) {
  if (asked.empty()) return dir + "/" + checkpoint_name;
  return simulation > 1 ? asked + "." + std::to_string(simulation) : asked;
}

std::string Checkpoints::file(const Run& run) const {
  return checkpoint_file(options_.file, run.simulation.model.scene.output.dir, run.number());
}

void Checkpoints::check_place(const Run& run) const {
  const Scene& scene = run.simulation.model.scene;
  if (!options_.file.empty() || !scene.output.dir.empty()) return;
  throw InputError(scene.time.place, "--checkpoint", "an output folder (output.dir, or -o) or file=…", "neither");
}

bool Checkpoints::due(const Run& run) const {
  const long steps = run.simulation.totals.steps;
  if (options_.steps > 0) return steps / options_.steps > run.checkpoint.step / options_.steps;
  return wall_seconds() - run.checkpoint.at >= options_.seconds;
}

void Checkpoints::between_steps(lua_State* L, const std::shared_ptr<Run>& run, bool last) {
  const long steps = run->simulation.totals.steps;
  const bool first = run->checkpoint.step < 0;  // it begins, or it was restored
  if (!first && (run->checkpoint.step == steps || !(last || due(*run)))) return;
  if (!first) write(L, run);
  // from its end: a slow disk does not leave the run without time for itself
  run->checkpoint = {steps, wall_seconds()};
}

// As sim:save(file), by the library, which adds the script's own data. Where it cannot be written the run goes on: it
// has its former state, and its results say themselves when they cannot be written.
void Checkpoints::write(lua_State* L, const std::shared_ptr<Run>& run) {
  const PartTimer timer(run->simulation.totals, "checkpoints");
  luaL_checkstack(L, 8, "a checkpoint");
  push_saving(L);
  lua_getfield(L, -1, "checkpoint");
  push_simulation(L, run);
  lua_pushstring(L, file(*run).c_str());
  protected_call(L, 2, 1);
  const std::string trouble = lua_isstring(L, -1) ? lua_tostring(L, -1) : "";
  lua_pop(L, 2);
  if (!trouble.empty() && !failed_) std::cerr << "note: no checkpoint, the former one stays: " << trouble << '\n';
  failed_ = !trouble.empty();
}

}  // namespace talus
