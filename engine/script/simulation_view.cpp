#include "script/simulation_view.h"

#include <cmath>
#include <new>
#include <vector>

#include "equations/error_estimate.h"
#include "script/fracture_view.h"
#include "script/gas_view.h"
#include "script/laws.h"
#include "script/lua_error.h"
#include "script/lua_fields.h"
#include "script/nearest.h"
#include "script/saved_view.h"
#include "script/session.h"
#include "script/table_view.h"
#include "step/energy_terms.h"

namespace talus {
namespace {

constexpr const char* metatable = "talus.simulation";
constexpr const char* methods_key = "talus.simulation.methods";
constexpr const char* values_key = "talus.simulation.values";    // run -> its Lua value, weak
constexpr const char* waiting_key = "talus.simulation.waiting";  // runs never stepped, kept for the program to run

using Handle = std::shared_ptr<Run>;

// Empty when the script has dropped it: finalizers, and tables with weak keys, still have it until the next collection.
Handle& any_handle(lua_State* L, int index) {
  if (index == 1 && !luaL_testudata(L, 1, metatable))
    refuse(L, "expected a simulation before its method, got " + describe(L, 1) + "; write sim:step(), with a colon");
  return *static_cast<Handle*>(luaL_checkudata(L, index, metatable));
}

Handle& check_handle(lua_State* L, int index) {
  Handle& run = any_handle(L, index);
  if (!run) refuse(L, "this simulation was given up when nothing referred to it any more");
  return run;
}

void push_status(lua_State* L, const StepReport& report) {
  lua_createtable(L, 0, 9);
  set_integer(L, "step", report.step);
  set_number(L, "time", report.time);
  set_number(L, "dt", report.dt);
  set_integer(L, "iterations", report.iterations);
  set_integer(L, "cuts", report.cuts);
  set_integer(L, "factorisations", report.factorisations);
  set_number(L, "residual", report.residual);
  set_number(L, "displacement", report.displacement);
  set_integer(L, "closed_contacts", report.closed_contacts);
  set_integer(L, "failures", report.failures);
  set_number(L, "utilisation", report.utilisation);
  set_number(L, "error", report.error);
}

void push_energy(lua_State* L, Simulation& simulation) {
  const Energies energies = simulation.energies();
  const auto terms = energy_terms(simulation.plan, energies);
  lua_createtable(L, 0, int(terms.size()) + 1);
  for (const EnergyTerm* term : terms) set_number(L, term->name.c_str(), energies.*term->value);
  set_number(L, "scale", energies.scale);
}

void push_islands(lua_State* L, const IslandCounts& islands) {
  lua_createtable(L, 0, 4);
  set_integer(L, "at_rest", islands.at_rest);
  set_integer(L, "single", islands.single);
  set_integer(L, "by_sweeps", islands.by_sweeps);
  set_integer(L, "with_factor", islands.with_factor);
  set_integer(L, "asleep", islands.asleep);
}

void push_totals(lua_State* L, const Simulation& simulation) {
  const RunTotals& totals = simulation.totals;
  lua_createtable(L, 0, 10);
  set_integer(L, "steps", totals.steps);
  set_integer(L, "steps_at_rest", totals.steps_at_rest);
  set_integer(L, "steps_by_sweeps", totals.steps_by_sweeps);
  set_integer(L, "sweeps", totals.sweeps);
  set_integer(L, "splittings", totals.splittings);
  set_integer(L, "pivots", totals.pivots);
  push_islands(L, totals.islands);
  lua_setfield(L, -2, "islands");
  set_integer(L, "iterations", totals.iterations);
  set_integer(L, "cuts", totals.cuts);
  set_integer(L, "factorisations", totals.factorisations);
  set_integer(L, "failures", totals.failures);
  set_integer(L, "inaccurate", totals.inaccurate);
  set_number(L, "largest_utilisation", totals.largest_utilisation);
  set_integer(L, "largest_iterations", totals.largest_iterations);
  set_number(L, "largest_residual", totals.largest_residual);
  lua_newtable(L);
  for (const auto& part : totals.parts) set_number(L, part.name.c_str(), part.seconds);
  lua_setfield(L, -2, "seconds");
}

// Estimated error of stress; nothing where no blocks are bonded, or there is no recovery.
void push_error(lua_State* L, Simulation& simulation) {
  const Recovery* recovery = simulation.recovery();
  if (!recovery) return lua_pushnil(L);
  ErrorNorm whole;
  const std::vector<ErrorNorm> regions = error_of_regions(simulation.model, *recovery);
  lua_createtable(L, 0, 3);
  lua_createtable(L, 0, int(regions.size()));
  for (size_t r = 0; r < regions.size(); ++r) {
    whole += regions[r];
    set_number(L, simulation.model.scene.regions[r].name.c_str(), regions[r].relative());
  }
  lua_setfield(L, -2, "regions");
  set_number(L, "relative", whole.relative());
  set_number(L, "norm", std::sqrt(whole.error));
}

void push_peak(lua_State* L, const Peak& peak, const char* value) {
  if (peak.block < 0) return lua_pushnil(L);
  lua_createtable(L, 0, 3);
  set_integer(L, "block", peak.block + 1);
  set_number(L, value, peak.value);
  set_number(L, "time", peak.at);
}

// The properties of `sim`, beside its methods.
struct Property {
  const char* name;
  void (*push)(lua_State* L, const Handle& run);
};
const Property properties[] = {
    {"time", [](lua_State* L, const Handle& r) { lua_pushnumber(L, r->simulation.model.time); }},
    {"dt", [](lua_State* L, const Handle& r) { lua_pushnumber(L, r->simulation.last.dt); }},
    {"finished", [](lua_State* L, const Handle& r) { lua_pushboolean(L, r->simulation.finished()); }},
    {"last", [](lua_State* L, const Handle& r) { push_status(L, r->simulation.last); }},
    {"energy", [](lua_State* L, const Handle& r) { push_energy(L, r->simulation); }},
    {"error", [](lua_State* L, const Handle& r) { push_error(L, r->simulation); }},
    {"totals", [](lua_State* L, const Handle& r) { push_totals(L, r->simulation); }},
    {"state",
     [](lua_State* L, const Handle& r) {
       push_simulation(L, r);
       lua_getiuservalue(L, -1, 1);
     }},
    {"blocks", [](lua_State* L, const Handle& r) { push_table_view(L, r, ViewKind::blocks); }},
    {"joints", [](lua_State* L, const Handle& r) { push_table_view(L, r, ViewKind::joints); }},
    {"contacts", [](lua_State* L, const Handle& r) { push_table_view(L, r, ViewKind::contacts); }},
    {"cracks", [](lua_State* L, const Handle& r) { push_cracks(L, r->simulation.model); }},
    {"fragments", [](lua_State* L, const Handle& r) { push_fragments(L, r->simulation.model); }},
    {"reactions", [](lua_State* L, const Handle& r) { push_reactions(L, r->simulation); }},
    {"charges", [](lua_State* L, const Handle& r) { push_charges(L, r->simulation); }},
    {"highest", [](lua_State* L, const Handle& r) { push_peak(L, r->simulation.model.highest, "rise"); }},
    {"strained", [](lua_State* L, const Handle& r) { push_peak(L, r->simulation.model.strained, "strain"); }},
    {"collapsed", [](lua_State* L, const Handle& r) { lua_pushboolean(L, r->simulation.collapsed()); }},
    {"probes", [](lua_State* L, const Handle& r) { push_table_view(L, r, ViewKind::probes); }},
};

// registry[key][run] = the value on the top of the stack.
void register_value(lua_State* L, const char* key, const Run* run) {
  lua_getfield(L, LUA_REGISTRYINDEX, key);
  lua_pushvalue(L, -2);
  lua_rawsetp(L, -2, run);
  lua_pop(L, 1);
}

// Stepping asks for a run at rest, and ends `talus plan`. A run that was stepped by the script is no longer
// kept waiting for the program.
const Handle& steppable(lua_State* L, const char* what) {
  const Handle& run = check_handle(L, 1);
  if (run->phase() != Run::Phase::idle) refuse(L, std::string("sim:") + what + " inside a step, a handler or a law");
  if (Session::of(L).plan_only()) throw ScriptError(ErrorKind::planned, "planned");
  lua_pushnil(L);
  register_value(L, waiting_key, run.get());
  lua_pop(L, 1);
  return run;
}

// sim:step() -> status, or nothing when the run is finished
int simulation_step(lua_State* L) {
  const Handle& run = steppable(L, "step");
  const auto report = Session::of(L).step(L, run);
  if (!report) return 0;
  push_status(L, *report);
  return 1;
}

// sim:run() -> status of the last step
int simulation_run(lua_State* L) {
  const Handle& run = steppable(L, "run");
  while (Session::of(L).step(L, run)) {
  }
  push_status(L, run->simulation.last);
  return 1;
}

int simulation_stop(lua_State* L) {
  Run& run = check_simulation(L, 1);
  run.refuse_inside_step(L, "sim:stop()");
  run.stop();
  return 0;
}

int simulation_output(lua_State* L) {
  Run& run = check_simulation(L, 1);
  run.refuse_inside_step(L, "sim:output()");
  run.frame();
  return 0;
}

int simulation_index(lua_State* L) {
  const Handle& run = check_handle(L, 1);
  const std::string name = luaL_tolstring(L, 2, nullptr);
  for (const Property& property : properties) {
    if (name != property.name) continue;
    property.push(L, run);
    return 1;
  }
  push_simulation_methods(L);
  if (lua_getfield(L, -1, name.c_str()) != LUA_TNIL) return 1;
  lua_pop(L, 1);
  std::vector<std::string> known;
  for (const Property& property : properties) known.emplace_back(property.name);
  for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) known.emplace_back(lua_tostring(L, -2));
  refuse(L, "a simulation has no \"" + name + '"' + suggestion(name, known));
}

int simulation_set(lua_State* L) {
  const std::string name = luaL_tolstring(L, 2, nullptr);
  if (name != "state") refuse(L, "sim." + name + " cannot be set; sim.state can");
  check_simulation(L, 1).refuse_inside_step(L, "sim.state = …");
  if (!lua_istable(L, 3)) refuse(L, "sim.state: expected a table, got " + describe(L, 3));
  lua_pushvalue(L, 3);
  lua_setiuservalue(L, 1, 1);
  return 0;
}

int simulation_text(lua_State* L) {
  const Scene& scene = check_simulation(L, 1).simulation.model.scene;
  lua_pushstring(L, ("simulation of " + (scene.title.empty() ? scene.file : scene.title)).c_str());
  return 1;
}

// The script has dropped it: its results end now, and handlers may be given it one last time. When the state
// is closing the session has ended the results before.
int simulation_collect(lua_State* L) {
  Handle& run = *static_cast<Handle*>(lua_touserdata(L, 1));
  lua_settop(L, 1);
  register_value(L, values_key, run.get());
  Session::of(L).release(run);
  lua_pushnil(L);
  register_value(L, values_key, run.get());
  run.reset();
  return 0;
}

void new_registry_table(lua_State* L, const char* key, const char* weak) {
  lua_newtable(L);
  if (weak) {
    lua_createtable(L, 0, 1);
    lua_pushstring(L, weak);
    lua_setfield(L, -2, "__mode");
    lua_setmetatable(L, -2);
  }
  lua_setfield(L, LUA_REGISTRYINDEX, key);
}

}  // namespace

void open_simulation_view(lua_State* L) {
  constexpr luaL_Reg functions[] = {{"__index", guarded<simulation_index>},
                                    {"__newindex", guarded<simulation_set>},
                                    {"__tostring", guarded<simulation_text>},
                                    {"__gc", simulation_collect},
                                    {nullptr, nullptr}};
  luaL_newmetatable(L, metatable);
  luaL_setfuncs(L, functions, 0);
  lua_pushboolean(L, false);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);

  constexpr luaL_Reg methods[] = {{"step", guarded<simulation_step>},
                                  {"run", guarded<simulation_run>},
                                  {"stop", guarded<simulation_stop>},
                                  {"output", guarded<simulation_output>},
                                  {nullptr, nullptr}};
  luaL_newlib(L, methods);
  lua_setfield(L, LUA_REGISTRYINDEX, methods_key);
  new_registry_table(L, values_key, "v");
  new_registry_table(L, waiting_key, nullptr);
}

void new_simulation(lua_State* L, const std::shared_ptr<Run>& run) {
  void* memory = lua_newuserdatauv(L, sizeof(Handle), 1);
  new (memory) Handle(run);
  lua_newtable(L);  // sim.state
  lua_setiuservalue(L, -2, 1);
  luaL_setmetatable(L, metatable);
  register_value(L, values_key, run.get());
  register_value(L, waiting_key, run.get());
}

void push_simulation(lua_State* L, const std::shared_ptr<Run>& run) {
  lua_getfield(L, LUA_REGISTRYINDEX, values_key);
  lua_rawgetp(L, -1, run.get());
  lua_remove(L, -2);
}

void push_simulation_methods(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, methods_key);
}

Run& check_simulation(lua_State* L, int index) {
  return *check_handle(L, index);
}

Run* live_simulation(lua_State* L, int index) {
  return any_handle(L, index).get();
}

}  // namespace talus
