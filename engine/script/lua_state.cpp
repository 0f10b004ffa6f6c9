#include "script/lua_state.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string_view>

#include "input/file_hash.h"
#include "script/coroutines.h"
#include "script/lua_error.h"
#include "script/random_state.h"

namespace talus {
namespace {

constexpr const char* files_key = "talus.files";  // in Lua's registry: path -> hash

// load(chunk [, name [, mode [, env]]]) of the base library, with the mode held at "t": no bytecode.
int load_text(lua_State* L) {
  lua_settop(L, lua_isnone(L, 4) ? 3 : 4);
  lua_pushliteral(L, "t");
  lua_replace(L, 3);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

// A package searcher for Lua files that loads text only.
int search_text(lua_State* L) {
  const char* name = luaL_checkstring(L, 1);
  lua_getfield(L, lua_upvalueindex(1), "searchpath");
  lua_pushvalue(L, 1);
  lua_getfield(L, lua_upvalueindex(1), "path");
  lua_call(L, 2, 2);
  if (lua_isnil(L, -2)) return 1;
  lua_pop(L, 1);
  const std::string file = lua_tostring(L, -1);
  note_file(L, file);
  if (luaL_loadfilex(L, file.c_str(), "t") != LUA_OK) {
    return luaL_error(L, "cannot load module '%s': %s", name, lua_tostring(L, -1));
  }
  lua_pushstring(L, file.c_str());
  return 2;
}

struct Refusal {
  std::size_t given = 0;  // bytes
  char file[512] = "";
  int line = 0;
} refusal;

void remove_global(lua_State* L, const char* name) {
  lua_pushnil(L);
  lua_setglobal(L, name);
}

// os.execute and the like: upvalues are name and advice.
int not_in_a_scene(lua_State* L) {
  const std::string name = lua_tostring(L, lua_upvalueindex(1)), advice = lua_tostring(L, lua_upvalueindex(2));
  throw ScriptError(ErrorKind::input, user_place(L).text() + ": " + name + ": a scene " + advice);
}

void refuse_in_os(lua_State* L) {
  constexpr const char* files = "has no files: results go where `output` says, lines to print or sim:log";
  constexpr std::pair<const char*, const char*> refused[] = {
      {"execute", "starts no programs"},
      {"exit", "ends with its script: sim:stop() ends a run, error(text) everything"},
      {"getenv", "is given values by talus.param and -p name=value"},
      {"remove", files},
      {"rename", files},
      {"tmpname", files},
      {"setlocale", "has one locale"}};
  for (const auto& [name, advice] : refused) {
    lua_pushfstring(L, "os.%s", name);
    lua_pushstring(L, advice);
    lua_pushcclosure(L, guarded<not_in_a_scene>, 2);
    lua_setfield(L, -2, name);
  }
}

void restrict_os(lua_State* L) {
  lua_getglobal(L, LUA_OSLIBNAME);
  lua_createtable(L, 0, 10);
  refuse_in_os(L);
  for (const char* name : {"time", "clock", "date"}) {
    lua_getfield(L, -2, name);
    lua_setfield(L, -2, name);
  }
  lua_setglobal(L, LUA_OSLIBNAME);
  lua_pop(L, 1);
  lua_getglobal(L, LUA_LOADLIBNAME);
  lua_getfield(L, -1, "loaded");
  lua_getglobal(L, LUA_OSLIBNAME);
  lua_setfield(L, -2, LUA_OSLIBNAME);
  lua_pop(L, 2);
}

void restrict_packages(lua_State* L) {
  lua_getglobal(L, LUA_LOADLIBNAME);
  lua_pushnil(L);
  lua_setfield(L, -2, "loadlib");
  lua_pushliteral(L, "");
  lua_setfield(L, -2, "cpath");
  lua_getfield(L, -1, "searchers");
  lua_pushvalue(L, -2);
  lua_pushcclosure(L, guarded<search_text>, 1);
  lua_rawseti(L, -2, 2);
  for (int i = 3; i <= 4; ++i) {  // the searchers of C libraries
    lua_pushnil(L);
    lua_rawseti(L, -2, i);
  }
  lua_pop(L, 2);
}

int open_sandbox(lua_State* L) {
  const luaL_Reg libraries[] = {{LUA_GNAME, luaopen_base},          {LUA_LOADLIBNAME, luaopen_package},
                                {LUA_COLIBNAME, luaopen_coroutine}, {LUA_TABLIBNAME, luaopen_table},
                                {LUA_OSLIBNAME, luaopen_os},        {LUA_STRLIBNAME, luaopen_string},
                                {LUA_MATHLIBNAME, luaopen_math},    {LUA_UTF8LIBNAME, luaopen_utf8}};
  for (const auto& library : libraries) {
    luaL_requiref(L, library.name, library.func, 1);
    lua_pop(L, 1);
  }
  keep_random_state(L);
  follow_coroutines(L);
  if (lua_toboolean(L, 1)) {
    luaL_openlibs(L);
    return 0;
  }
  restrict_os(L);
  restrict_packages(L);
  lua_getglobal(L, "load");
  lua_pushcclosure(L, load_text, 1);
  lua_setglobal(L, "load");
  remove_global(L, "dofile");
  remove_global(L, "loadfile");
  return 0;
}

}  // namespace

// Lua throws away garbage and asks once more, then its error has no line: found here, without asking for memory.
void LuaState::Memory::note_refusal() const {
  refusal.given = cap;
  refusal.line = 0;
  lua_Debug frame;
  for (int level = 0; L && refusal.line == 0 && lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (*frame.what == 'C' || *frame.source != '@' || std::string_view(frame.source + 1).starts_with(library)) continue;
    std::snprintf(refusal.file, sizeof refusal.file, "%s", frame.source + 1);
    refusal.line = frame.currentline;
  }
}

std::string out_of_lua_memory() {
  const std::string place = refusal.line > 0 ? refusal.file + (":" + std::to_string(refusal.line)) + ": " : "";
  const std::size_t megabytes = refusal.given >> 20;
  return place + "out of memory: the script may have " +
         (megabytes % 1024 == 0 ? std::to_string(megabytes / 1024) + " GB" : std::to_string(megabytes) + " MB");
}

void* LuaState::allocate(void* memory, void* block, std::size_t old_size, std::size_t new_size) {
  Memory& m = *static_cast<Memory*>(memory);
  if (!block) old_size = 0;  // then it tells the kind of object
  if (new_size == 0) {
    std::free(block);
    m.used -= old_size;
    return nullptr;
  }
  const bool too_much = m.cap && new_size > old_size && m.used + (new_size - old_size) > m.cap;
  void* grown = too_much ? nullptr : std::realloc(block, new_size);
  if (grown)
    m.used += new_size - old_size;
  else
    m.note_refusal();
  return grown;
}

LuaState::LuaState(const LuaOptions& options) : library_(options.library.empty() ? library_folder() : options.library) {
  memory_.cap = options.memory_cap;
  L_ = lua_newstate(allocate, &memory_);
  if (!L_) throw std::bad_alloc();
  open_errors(L_, library_);
  lua_pushcfunction(L_, open_sandbox);
  lua_pushboolean(L_, options.trust);
  protected_call(L_, 1, 0);
  memory_.library = library_;
  memory_.L = L_;
}

LuaState::~LuaState() {
  lua_close(L_);
}

std::string library_folder() {
  const char* from_environment = std::getenv("TALUS_LIB");
  if (from_environment && *from_environment) return from_environment;
  std::error_code none;
  Dl_info own;  // the file that this code is in: <prefix>/bin/talus, or <prefix>/lib/lua/5.4/talus/engine.so
  const bool module =
      dladdr(reinterpret_cast<void*>(&library_folder), &own) && std::string_view(own.dli_fname).ends_with(".so");
  std::filesystem::path prefix =
      module ? std::filesystem::canonical(own.dli_fname, none) : std::filesystem::read_symlink("/proc/self/exe", none);
  for (int up = module ? 5 : 2; up > 0; --up) prefix = prefix.parent_path();
  const std::filesystem::path beside = prefix / "share/talus/lib";
  return !none && std::filesystem::exists(beside / "talus/init.lua", none) ? beside.string() : TALUS_LUA_PATH;
}

void set_search_path(lua_State* L, const std::string& script, const std::string& library) {
  const std::string folder = std::filesystem::path(script).parent_path().string();
  std::string path;
  for (const std::string& root : {folder.empty() ? std::string(".") : folder, library}) {
    path += (path.empty() ? "" : ";") + root + "/?.lua;" + root + "/?/init.lua";
  }
  lua_getglobal(L, LUA_LOADLIBNAME);
  lua_pushstring(L, path.c_str());
  lua_setfield(L, -2, "path");
  lua_pop(L, 1);
}

void note_file(lua_State* L, const std::string& path) {
  luaL_getsubtable(L, LUA_REGISTRYINDEX, files_key);
  lua_pushinteger(L, static_cast<lua_Integer>(hash_of_file(path)));
  lua_setfield(L, -2, path.c_str());
  lua_pop(L, 1);
}

std::vector<ScriptFile> noted_files(lua_State* L) {
  std::vector<ScriptFile> files;
  luaL_getsubtable(L, LUA_REGISTRYINDEX, files_key);
  for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1))
    files.push_back({lua_tostring(L, -2), static_cast<std::uint64_t>(lua_tointeger(L, -1))});
  lua_pop(L, 1);
  std::ranges::sort(files, {}, &ScriptFile::path);
  return files;
}

void run_file(lua_State* L, const std::string& path) {
  note_file(L, path);
  if (luaL_loadfilex(L, path.c_str(), "t") != LUA_OK) {
    const ScriptError error = pop_error(L);
    if (std::string_view(error.what()).starts_with("attempt to load a binary"))
      throw ScriptError(ErrorKind::input, path + ": expected a script as text, got compiled Lua");
    throw error;
  }
  protected_call(L, 0, 0);
}

}  // namespace talus
