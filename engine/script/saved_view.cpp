#include "script/saved_view.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>

#include "output/state_file.h"
#include "script/laws.h"
#include "script/lua_error.h"
#include "script/plain_data.h"
#include "script/random_state.h"
#include "script/session.h"
#include "script/simulation_view.h"
#include "script/written_files.h"

namespace talus {
namespace {

constexpr const char* saved_metatable = "talus.saved_state";
constexpr const char* saving_key = "talus.saving";

struct SavedState {
  SavedRun run;
  std::string from;  // the file; empty: memory
};

SavedState& check_saved(lua_State* L, int index) {
  return *static_cast<SavedState*>(luaL_checkudata(L, index, saved_metatable));
}

// With one value beside it: the functions that its loads and supports had.
SavedState& push_saved(lua_State* L, SavedRun saved, std::string from) {
  void* memory = lua_newuserdatauv(L, sizeof(SavedState), 1);
  auto* state = new (memory) SavedState{std::move(saved), std::move(from)};
  luaL_setmetatable(L, saved_metatable);
  return *state;
}

int saved_collect(lua_State* L) {
  static_cast<SavedState*>(lua_touserdata(L, 1))->~SavedState();
  return 0;
}

int saved_text(lua_State* L) {
  const SavedRun& saved = check_saved(L, 1).run;
  char text[100];
  std::snprintf(text, sizeof text, "saved state: step %ld, t = %.6g s", saved.step, saved.time);
  lua_pushstring(L, text);
  return 1;
}

struct ScriptParts {
  std::string state, objects, random;
};

ScriptParts script_parts(const SavedRun& saved) {
  ByteReader reader(saved.script);
  ScriptParts parts;
  for (std::string* part : {&parts.state, &parts.objects, &parts.random}) *part = reader.text();
  return parts;
}

// save(sim, objects, laws) -> saved state
int saving_save(lua_State* L) {
  Run& run = check_simulation(L, 1);
  run.refuse_inside_step(L, "sim:save()");
  if (Session::of(L).plan_only()) throw ScriptError(ErrorKind::planned, "planned");
  SavedRun saved = run.save();
  lua_getiuservalue(L, 1, 1);
  append(saved.script, std::string_view(pack_plain(L, -1, "sim.state")));
  append(saved.script, std::string_view(pack_plain(L, 2, "objects")));
  append(saved.script, std::string_view(random_state(L)));
  push_saved(L, std::move(saved), "");
  lua_pushvalue(L, 3);
  lua_setiuservalue(L, -2, 1);
  return 1;
}

// write(saved state, file) -> nothing, or why it cannot be written
int saving_write(lua_State* L) {
  try {
    write_state(luaL_checkstring(L, 2), check_saved(L, 1).run);
  } catch (const RunError& error) {
    lua_pushstring(L, error.what());
    return 1;
  }
  return 0;
}

// check_name(file) -> nothing, or throws: a scene writes states where it may, and over states only
int saving_check_name(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  if (Session::of(L).trusted()) return 0;
  if (!stays_here(name)) refuse(L, "sim:save: expected " + std::string(allowed_place) + ", got \"" + name + '"');
  if (std::filesystem::exists(name) && !is_state_file(name))
    refuse(L, "sim:save: expected a new file or one with a saved state in it, got \"" + name +
                  "\", which is another (--trust overwrites it)");
  return 0;
}

SavedRun read_file(lua_State* L, const std::string& path) {
  try {
    return read_state(path);
  } catch (const StateError& error) {
    refuse(L, "sim:restore: expected a saved state, got \"" + path + "\", which " + error.what());
  }
}

// open(sim, file or saved state) -> saved state, its objects, its laws or nil; refused when it is of another scene
int saving_open(lua_State* L) {
  const Run& run = check_simulation(L, 1);
  if (Session::of(L).plan_only()) throw ScriptError(ErrorKind::planned, "planned");
  if (run.phase() != Run::Phase::idle) refuse(L, "sim:restore inside a step, a handler or a law");
  if (lua_type(L, 2) == LUA_TSTRING) {
    const std::string path = lua_tostring(L, 2);
    push_saved(L, read_file(L, path), path);
  } else if (luaL_testudata(L, 2, saved_metatable)) {
    lua_pushvalue(L, 2);
  } else {
    refuse(L, "sim:restore: expected a file's name or what sim:save() returned, got " + describe(L, 2));
  }
  const SavedState& saved = check_saved(L, -1);
  try {
    run.check_fits(saved.run);
  } catch (const StateError& error) {
    refuse(L, "sim:restore: expected a state saved from this scene, got " +
                  (saved.from.empty() ? "one" : '"' + saved.from + '"') + ", which " + error.what());
  }
  push_plain(L, script_parts(saved.run).objects);
  lua_getiuservalue(L, -2, 1);
  return 3;
}

// The table sim.state stays the same one, for those who hold it.
void fill_state(lua_State* L, int simulation, const SavedRun& saved) {
  lua_getiuservalue(L, simulation, 1);
  const int state = lua_gettop(L);
  for (lua_pushnil(L); lua_next(L, state);) {
    lua_pop(L, 1);
    lua_pushvalue(L, -1);
    lua_pushnil(L);
    lua_rawset(L, state);
  }
  push_plain(L, script_parts(saved).state);
  for (lua_pushnil(L); lua_next(L, state + 1); lua_pop(L, 1)) {
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, state);
  }
  lua_settop(L, state - 1);
}

// restore(sim, saved state): the engine's state, that of the results, and sim.state
int saving_restore(lua_State* L) {
  Run& run = check_simulation(L, 1);
  const SavedState& saved = check_saved(L, 2);
  try {
    run.restore(saved.run, saved.from.empty() ? "memory" : saved.from);
  } catch (const StateError& error) {
    refuse(L, std::string("sim:restore: expected a state saved from this scene, got one that ") + error.what());
  }
  fill_state(L, 1, saved.run);
  return 0;
}

// hash(sim) -> 16 hexadecimal digits
int saving_hash(lua_State* L) {
  lua_pushstring(L, hex(check_simulation(L, 1).simulation.hash()).c_str());
  return 1;
}

}  // namespace

void open_saved_view(lua_State* L) {
  constexpr luaL_Reg functions[] = {{"__tostring", guarded<saved_text>}, {"__gc", saved_collect}, {nullptr, nullptr}};
  luaL_newmetatable(L, saved_metatable);
  luaL_setfuncs(L, functions, 0);
  lua_pushboolean(L, false);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

void add_saving(lua_State* L) {
  constexpr luaL_Reg functions[] = {{"save", guarded<saving_save>},
                                    {"write", guarded<saving_write>},
                                    {"check_name", guarded<saving_check_name>},
                                    {"open", guarded<saving_open>},
                                    {"restore", guarded<saving_restore>},
                                    {"hash", guarded<saving_hash>},
                                    {nullptr, nullptr}};
  luaL_newlib(L, functions);
  lua_pushvalue(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, saving_key);
  lua_setfield(L, -2, "saving");
}

void push_saving(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, saving_key);
}

void fill_restart_state(lua_State* L, const std::shared_ptr<Run>& run) {
  push_simulation(L, run);
  if (run->restart()) fill_state(L, lua_gettop(L), run->restart()->saved);
  lua_pop(L, 1);
}

void resume(lua_State* L, const std::shared_ptr<Run>& run) {
  if (!run->restart()) return;
  const Restart restart = *run->restart();
  std::cerr << "restart from " << restart.file << ": step " << restart.saved.step << ", t = " << restart.saved.time
            << " s\n";
  if (restart.saved.talus != own_version())
    std::cerr << "note: it was saved by Talus " << restart.saved.talus << ", this is " << own_version()
              << ": the course may differ from one in a single run\n";
  push_simulation_methods(L);
  lua_getfield(L, -1, "restore");
  push_simulation(L, run);
  push_saved(L, restart.saved, restart.file);
  lua_call(L, 2, 0);
  lua_pop(L, 1);
  set_random_state(L, script_parts(restart.saved).random);
}

}  // namespace talus
