#include "script/native.h"

#include <algorithm>
#include <string>
#include <vector>

#include "script/drawing_reader.h"
#include "script/explain.h"
#include "script/laws.h"
#include "script/lua_error.h"
#include "script/nearest.h"
#include "script/plot_view.h"
#include "script/saved_view.h"
#include "script/scene_reader.h"
#include "script/session.h"
#include "script/simulation_view.h"
#include "script/table_view.h"
#include "step/energy_terms.h"

namespace talus {
namespace {

// place() -> file, line of the user's script that led here (nothing outside of one)
int native_place(lua_State* L) {
  const Place place = user_place(L);
  if (place.file.empty()) return 0;
  lua_pushstring(L, place.file.c_str());
  lua_pushinteger(L, place.line);
  return 2;
}

// fail(message): bad input
int native_fail(lua_State* L) {
  throw ScriptError(ErrorKind::input, luaL_checkstring(L, 1));
}

// describe(value) -> how messages show it
int native_describe(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushstring(L, describe(L, 1).c_str());
  return 1;
}

// suggestion(word, known) -> '; did you mean "…"?'
int native_suggestion(lua_State* L) {
  std::vector<std::string> known(lua_rawlen(L, 2));
  for (std::size_t i = 0; i < known.size(); ++i) {
    lua_rawgeti(L, 2, static_cast<lua_Integer>(i + 1));
    known[i] = luaL_checkstring(L, -1);
    lua_pop(L, 1);
  }
  lua_pushstring(L, suggestion(luaL_checkstring(L, 1), known).c_str());
  return 1;
}

// try_law(function, {"t"}, {0}) -> nothing, or what is wrong with it
int native_try_law(lua_State* L) {
  std::vector<std::string> names;
  std::vector<double> arguments;
  for (lua_Integer i = 1; i <= static_cast<lua_Integer>(lua_rawlen(L, 2)); ++i) {
    lua_rawgeti(L, 2, i);
    names.emplace_back(luaL_checkstring(L, -1));
    lua_rawgeti(L, 3, i);
    arguments.push_back(luaL_checknumber(L, -1));
    lua_pop(L, 2);
  }
  std::vector<const char*> words;
  for (const std::string& name : names) words.push_back(name.c_str());
  const LawResult result = call_law(LuaFunction(L, 1), words, arguments);
  if (result.problem.empty()) return 0;
  lua_pushstring(L, result.problem.c_str());
  return 1;
}

// create(scene) -> simulation
int native_create(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_gc(L, LUA_GCCOLLECT);  // simulations the script has dropped end here
  const TableReader table(L, 1);
  RunHandlers handlers;
  for (const auto& [key, handler] : {std::pair{"on_step", &handlers.on_step},
                                     {"on_fracture", &handlers.on_fracture},
                                     {"on_gas", &handlers.on_gas},
                                     {"on_output", &handlers.on_output},
                                     {"stop", &handlers.stop}}) {
    if (!table.push(key)) continue;
    handler->emplace(L, -1);
    lua_pop(L, 1);
  }
  table.each("fields", [&](const TableReader& field) {
    std::string name;
    field.read("name", name);
    field.push("law");
    handlers.fields.emplace_back(name, LuaFunction(L, -1));
    lua_pop(L, 1);
  });
  const auto run = Session::of(L).add_run(read_scene(table), std::move(handlers));
  new_simulation(L, run);
  fill_restart_state(L, run);
  return 1;
}

// explain(simulation, joint) -> text; joint: one of the simulation, or its number, from 1
int native_explain(lua_State* L) {
  const Run& run = check_simulation(L, 1);
  const auto count = lua_Integer(run.simulation.model.joints.size());
  const lua_Integer id = lua_isinteger(L, 2) ? lua_tointeger(L, 2) : item_id(L, 2, run, ViewKind::joints);
  if (id < 1 || id > count)
    refuse(L, "sim:explain: expected a joint of this simulation or its number, from 1 to " + std::to_string(count) +
                  ", got " + describe_item(L, 2, run));
  lua_pushstring(L, explain(run.simulation.model, int(id) - 1).c_str());
  return 1;
}

// What a simulation has no part for that was made without it.
void refuse_late(lua_State* L, const Simulation& simulation, const std::string& list, int index,
                 const TableReader& entry) {
  const Plan& plan = simulation.plan;
  double restitution = 1, spin = 0;
  bool breaks = false;
  if (list == "properties") {
    entry.read("restitution", restitution);
    entry.read("breaks", breaks);
    const auto bonded = [&](const Joint& joint) { return joint.property == index && joint.bonded; };
    const std::vector<Joint>& joints = simulation.model.joints;
    if (breaks && !simulation.model.scene.properties[size_t(index)].breaks &&
        std::any_of(joints.begin(), joints.end(), bonded))
      refuse(
          L,
          "joint.tension: expected a joint that had a strength when the simulation was made; give it a large one there, as in tension = 1e12, cohesion = 1e12");
  }
  if (list == "fixities") entry.read("spin", spin);
  if (restitution < 1 && plan.dynamic && plan.contacts && !plan.restitution)
    refuse(
        L,
        "joint.restitution: expected 1, as no joint of the simulation had one below 1 when it was made; give one of them 0.999 there");
  if (spin != 0 && !plan.dynamic)
    refuse(L, "fix.spin: expected 0, as a static run moves what is held but does not turn it");
}

// update(simulation, list, index, entry): a changed material, joint, fixity or load
int native_update(lua_State* L) {
  Run* run = live_simulation(L, 1);
  if (!run) return 0;  // of an object that others still use
  run->refuse_inside_step(L, "a change of a " + std::string(luaL_checkstring(L, 5)));
  const auto index = static_cast<int>(luaL_checkinteger(L, 3)) - 1;
  Model& model = run->simulation.model;
  refuse_late(L, run->simulation, luaL_checkstring(L, 2), index, TableReader(L, 4));
  const std::string list = luaL_checkstring(L, 2);
  if (list != "point_loads" && list != "edge_loads") run->simulation.before_change();  // they hold no energy
  update_scene(model.scene, list, index, TableReader(L, 4), model.time,
               list == "fixities" ? run->simulation.displacement_until() : run->simulation.change_until());
  model.changed();
  return 0;
}

// add_check(name, value, expected, pass)
int native_add_check(lua_State* L) {
  Session::of(L).add_check(
      {luaL_checkstring(L, 1), luaL_checkstring(L, 2), luaL_checkstring(L, 3), lua_toboolean(L, 4) != 0});
  return 0;
}

// add_result(name, value, unit)
int native_add_result(lua_State* L) {
  ResultLine result{luaL_checkstring(L, 1), luaL_checkstring(L, 3), 0.0};
  if (lua_isboolean(L, 2))
    result.value = lua_toboolean(L, 2) != 0;
  else if (lua_type(L, 2) == LUA_TNUMBER)
    result.value = lua_tonumber(L, 2);
  else
    result.value = std::string(luaL_checkstring(L, 2));
  Session::of(L).add_result(result);
  return 0;
}

// study(flat): what `talus sweep` works on
int native_study(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  Session::of(L).add_study(L, 1);
  return 0;
}

// note(text): for the notes of the next simulation
int native_note(lua_State* L) {
  Session::of(L).add_note(luaL_checkstring(L, 1));
  return 0;
}

// parameter(name, meaning, type) -> text given with -p, or nothing
int native_parameter(lua_State* L) {
  const std::string* value =
      Session::of(L).parameter({luaL_checkstring(L, 1), luaL_checkstring(L, 2), luaL_checkstring(L, 3)});
  if (!value) return 0;
  lua_pushstring(L, value->c_str());
  return 1;
}

// t[#t + 1] = {name, unit, meaning} of the table on the top.
void add_field(lua_State* L, const std::string& name, const std::string& unit, const std::string& meaning) {
  lua_createtable(L, 0, 3);
  for (const auto& [key, text] : {std::pair{"name", &name}, {"unit", &unit}, {"meaning", &meaning}}) {
    lua_pushstring(L, text->c_str());
    lua_setfield(L, -2, key);
  }
  lua_rawseti(L, -2, lua_Integer(lua_rawlen(L, -2)) + 1);
}

// fields() -> { blocks = {{name, unit, meaning}, …}, joints = …, contacts = …, probes = …, energy = … }
int native_fields(lua_State* L) {
  lua_newtable(L);
  lua_newtable(L);
  for (const EnergyTerm& term : energy_terms()) add_field(L, term.name, "J/m", term.meaning);
  add_field(L, "scale", "J/m",
            "kinetic and stored energy at the start, or the largest work put in so far if that is more");
  lua_setfield(L, -2, "energy");
  for (const auto& [name, kind] : {std::pair{"blocks", ViewKind::blocks},
                                   {"joints", ViewKind::joints},
                                   {"contacts", ViewKind::contacts},
                                   {"probes", ViewKind::probes}}) {
    lua_newtable(L);
    for (const ViewField& field : view_fields(kind)) add_field(L, field.name, field.unit, field.meaning);
    lua_setfield(L, -2, name);
  }
  return 1;
}

int load_native(lua_State* L) {
  constexpr luaL_Reg functions[] = {{"place", guarded<native_place>},
                                    {"fail", guarded<native_fail>},
                                    {"describe", guarded<native_describe>},
                                    {"suggestion", guarded<native_suggestion>},
                                    {"try_law", guarded<native_try_law>},
                                    {"create", guarded<native_create>},
                                    {"explain", guarded<native_explain>},
                                    {"update", guarded<native_update>},
                                    {"add_check", guarded<native_add_check>},
                                    {"note", guarded<native_note>},
                                    {"add_result", guarded<native_add_result>},
                                    {"study", guarded<native_study>},
                                    {"read_drawing", guarded<native_read_drawing>},
                                    {"read_gmsh", guarded<native_read_gmsh>},
                                    {"parameter", guarded<native_parameter>},
                                    {"fields", guarded<native_fields>},
                                    {nullptr, nullptr}};
  luaL_newlib(L, functions);
  push_simulation_methods(L);
  lua_setfield(L, -2, "methods");
  add_saving(L);
  add_plots(L);
  return 1;
}

}  // namespace

void open_native(lua_State* L) {
  open_table_views(L);
  open_simulation_view(L);
  open_saved_view(L);
  lua_getglobal(L, LUA_LOADLIBNAME);
  lua_getfield(L, -1, "preload");
  lua_pushcfunction(L, guarded<load_native>);
  lua_setfield(L, -2, "talus.native");
  lua_pop(L, 2);
}

}  // namespace talus
