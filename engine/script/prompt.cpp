#include "script/prompt.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>

#include "script/interrupt.h"
#include "script/lua_error.h"
#include "script/simulation_view.h"

namespace talus {
namespace {

constexpr const char* chunk_name = "@prompt";

// The names of the prompt: its own, then those of the script.
void push_names(lua_State* L, const std::shared_ptr<Run>& run) {
  lua_newtable(L);
  push_simulation(L, run);
  lua_setfield(L, -2, "sim");
  lua_getglobal(L, "require");
  lua_pushliteral(L, "talus");
  lua_call(L, 1, 1);
  lua_setfield(L, -2, "talus");
  lua_createtable(L, 0, 1);
  lua_pushglobaltable(L);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
}

bool loads(lua_State* L, const std::string& text) {
  return luaL_loadbufferx(L, text.data(), text.size(), chunk_name, "t") == LUA_OK;
}

// As an expression whose value is shown, else as a statement. Pushes the function, or the message.
enum class Loaded { good, wrong, unfinished };
Loaded load_line(lua_State* L, const std::string& text) {
  if (loads(L, "return " + text)) return Loaded::good;
  if (std::string(lua_tostring(L, -1)).ends_with("<eof>")) return Loaded::unfinished;
  lua_pop(L, 1);
  if (loads(L, text)) return Loaded::good;
  return std::string(lua_tostring(L, -1)).ends_with("<eof>") ? Loaded::unfinished : Loaded::wrong;
}

// Runs the function on the top with the names at `names` and prints what it returns.
void run_line(lua_State* L, int names) {
  const int base = lua_gettop(L) - 1;
  lua_pushvalue(L, names);
  lua_setupvalue(L, -2, 1);
  protected_call(L, 0, LUA_MULTRET);
  const int results = lua_gettop(L) - base;
  if (results > 0) {
    luaL_checkstack(L, 2, "the prompt");
    lua_getglobal(L, "print");
    lua_insert(L, base + 1);
    protected_call(L, results, 0);
  }
}

void ask(bool more) {
  if (isatty(STDIN_FILENO) == 1) std::fputs(more ? ">> " : "> ", stdout);
  std::fflush(stdout);
}

}  // namespace

void prompt(lua_State* L, const std::shared_ptr<Run>& run) {
  luaL_checkstack(L, 20, "the prompt");
  const int top = lua_gettop(L), names = top + 1;
  push_names(L, run);
  if (isatty(STDIN_FILENO) == 1)
    std::puts("sim is the simulation: sim:step(), sim.blocks[1].uy; `continue` or Ctrl-D goes on with the script");
  std::string text;
  for (std::string line; ask(!text.empty()), std::getline(std::cin, line);) {
    throw_if_interrupted();
    if (text.empty() && line == "continue") break;
    if (text.empty() && line.find_first_not_of(" \t") == std::string::npos) continue;
    text += (text.empty() ? "" : "\n") + line;
    try {
      const Loaded loaded = load_line(L, text);
      if (loaded == Loaded::unfinished) {
        lua_settop(L, names);
        continue;
      }
      if (loaded == Loaded::wrong) throw pop_error(L);
      run_line(L, names);
    } catch (const ScriptError& error) {
      if (error.kind == ErrorKind::interrupt) throw;
      std::fprintf(stderr, "%s\n", error.what());
    }
    text.clear();
    lua_settop(L, names);
  }
  lua_settop(L, top);
}

}  // namespace talus
