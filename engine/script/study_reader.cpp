#include "script/study_reader.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "output/text.h"
#include "script/laws.h"
#include "script/lua_error.h"
#include "script/table_reader.h"
#include "step/clock.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

// read("history.csv") -> the text of that file of the run's folder, or nothing. Upvalue: the folder.
int read_result(lua_State* L) {
  const std::string folder = lua_tostring(L, lua_upvalueindex(1)), name = luaL_checkstring(L, 1);
  if (name.find("..") != std::string::npos || name.starts_with("/")) return 0;
  std::ifstream file(folder + "/" + name, std::ios::binary);
  if (!file) return 0;
  std::ostringstream text;
  text << file.rdbuf();
  const std::string whole = text.str();
  lua_pushlstring(L, whole.data(), whole.size());
  return 1;
}

Cell cell_at(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER) {
    const double number = lua_tonumber(L, index);
    return {lua_isinteger(L, index) ? std::to_string(lua_tointeger(L, index)) : shortest(number), number};
  }
  if (lua_isboolean(L, index)) return {lua_toboolean(L, index) ? "true" : "false"};
  const char* text = lua_tostring(L, index);
  return {text ? text : ""};
}

// A sweep takes its signals when it asks for them: one that has come, or waits to be taken, stops a function that does
// not come to its end.
constexpr double collect_patience = 1;  // s
double collecting_since = 0;            // s of the clock
bool (*stop_asked)() = nullptr;         // of the sweep

void leave_if_stopped(lua_State* L, lua_Debug*) {
  if (wall_seconds() - collecting_since < collect_patience || !stop_asked()) return;
  lua_sethook(L, leave_if_stopped, LUA_MASKCOUNT, 1);  // no pcall keeps it
  raise_error(L, ErrorKind::interrupt, "its collecting was stopped by a signal");
}

// Looks for such a signal every so many instructions. Hooks of a signal that came unheld (Interrupts) are left alone.
class StopWatched {
 public:
  StopWatched(lua_State* L, bool (*asked)()) : L_(L) {
    collecting_since = wall_seconds();
    stop_asked = asked;
    if (!lua_gethook(L)) lua_sethook(L, leave_if_stopped, LUA_MASKCOUNT, 10000);
  }
  ~StopWatched() {
    if (lua_gethook(L_) == leave_if_stopped) lua_sethook(L_, nullptr, 0, 0);
  }
  StopWatched(const StopWatched&) = delete;
  StopWatched& operator=(const StopWatched&) = delete;

 private:
  lua_State* L_;
};

// collect(run, read) -> values, units, problem
Collected collect(lua_State* L, const LuaFunction& function, std::size_t columns, std::size_t run,
                  const std::string& folder, bool (*asked)()) {
  const int top = lua_gettop(L);
  luaL_checkstack(L, 8, "collecting");
  function.push();
  lua_pushinteger(L, static_cast<lua_Integer>(run) + 1);
  lua_pushstring(L, folder.c_str());
  lua_pushcclosure(L, guarded<read_result>, 1);
  Collected collected;
  try {
    const StopWatched watched(L, asked);
    protected_call(L, 2, 3);
  } catch (const ScriptError& error) {
    lua_settop(L, top);
    if (error.kind != ErrorKind::interrupt || !stop_asked()) throw;
    collected.problem = error.what();
    return collected;
  }
  for (std::size_t column = 0; column < columns; ++column) {
    lua_rawgeti(L, top + 1, static_cast<lua_Integer>(column) + 1);
    collected.cells.push_back(cell_at(L, -1));
    lua_rawgeti(L, top + 2, static_cast<lua_Integer>(column) + 1);
    collected.units.push_back(lua_isstring(L, -1) ? lua_tostring(L, -1) : "");
    lua_pop(L, 2);
  }
  if (lua_isstring(L, top + 3)) collected.problem = lua_tostring(L, top + 3);
  for (char& c : collected.problem)
    if (c == '\n') c = ' ';
  lua_settop(L, top);
  return collected;
}

StudyRun read_run(const TableReader& table) {
  StudyRun run;
  table.read("name", run.name);
  table.each("values", [&](const TableReader& entry) {
    Setting setting;
    entry.read("name", setting.name);
    entry.read("text", setting.text);
    entry.read("kind", setting.type);
    entry.read("number", setting.number);
    run.settings.push_back(setting);
  });
  return run;
}

SlurmResources read_slurm(const TableReader& table) {
  SlurmResources slurm;
  table.read("time", slurm.seconds);
  table.read("memory", slurm.megabytes);
  table.read("cpus", slurm.cpus);
  table.read("at_once", slurm.at_once);
  table.read("partition", slurm.partition);
  table.read("account", slurm.account);
  table.each("extra", [&](const TableReader& entry) { entry.read("text", slurm.extra.emplace_back()); });
  return slurm;
}

}  // namespace

Study read_study(lua_State* L, const std::string& script, const std::string& library) {
  const TableReader table(L, -1);
  Study study;
  study.file = script;
  study.library = library;
  table.read("place", study.place);
  table.read("scene", study.scene);
  study.scene = (fs::path(script).parent_path() / study.scene).lexically_normal().string();
  const std::string name = fs::path(script).stem().string();
  table.read("title", study.title);
  if (study.title.empty()) study.title = name;
  table.read("dir", study.dir);
  if (study.dir.empty()) study.dir = "out/" + name;
  table.read("seed_parameter", study.seed_parameter);
  table.read("time_limit", study.time_limit);
  table.each("parameters", [&](const TableReader& entry) { entry.read("name", study.parameters.emplace_back()); });
  table.each("runs", [&](const TableReader& entry) { study.runs.push_back(read_run(entry)); });
  table.each("columns", [&](const TableReader& entry) {
    StudyColumn& column = study.columns.emplace_back();
    entry.read("name", column.name);
    entry.read("unit", column.unit);
    entry.read("label", column.label);
    entry.read("log", column.log);
  });
  table.with("slurm", [&](const TableReader& entry) { study.slurm = read_slurm(entry); });
  table.push("collect");
  const auto function = std::make_shared<LuaFunction>(L, -1);
  lua_pop(L, 1);
  study.collect = [L, function, columns = study.columns.size()](std::size_t run, const std::string& folder,
                                                                bool (*asked)()) {
    return collect(L, *function, columns, run, folder, asked);
  };
  return study;
}

}  // namespace talus
