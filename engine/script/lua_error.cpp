#include "script/lua_error.h"

#include <algorithm>
#include <array>
#include <new>
#include <string_view>

#include "script/limits.h"
#include "script/lua_state.h"

namespace talus {
namespace {

constexpr const char* error_metatable = "talus.error";
constexpr const char* library_key = "talus.library";
constexpr std::array kind_names = {"input", "run", "internal", "interrupt", "planned"};

int error_text(lua_State* L) {
  lua_getfield(L, 1, "message");
  return 1;
}

// "a" .. error and error .. "b" work as with a plain message.
int error_concat(lua_State* L) {
  luaL_tolstring(L, 1, nullptr);
  luaL_tolstring(L, 2, nullptr);
  lua_concat(L, 2);
  return 1;
}

int string_method(lua_State* L) {
  luaL_tolstring(L, 1, nullptr);
  lua_replace(L, 1);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

// error:find("text") and its like, too.
int error_index(lua_State* L) {
  lua_pushliteral(L, "");
  luaL_getmetafield(L, -1, "__index");
  lua_pushvalue(L, 2);
  if (lua_rawget(L, -2) != LUA_TFUNCTION) return 0;
  lua_pushcclosure(L, string_method, 1);
  return 1;
}

bool is_error_object(lua_State* L, int index) {
  if (!lua_istable(L, index) || !lua_getmetatable(L, index)) return false;
  luaL_getmetatable(L, error_metatable);
  const bool same = lua_rawequal(L, -1, -2);
  lua_pop(L, 2);
  return same;
}

bool is_library(lua_State* L, const lua_Debug& frame) {
  lua_getfield(L, LUA_REGISTRYINDEX, library_key);
  const std::string prefix = lua_tostring(L, -1);
  lua_pop(L, 1);
  return std::string(frame.source).starts_with(prefix);
}

// Whether the innermost Lua function of the stack belongs to the library.
bool raised_in_library(lua_State* L) {
  lua_Debug frame;
  for (int level = 1; lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "S", &frame);
    if (*frame.what != 'C') return is_library(L, frame);
  }
  return false;
}

struct Nothing {
  Place place;
  std::string text;
} nothing;

// The message with what stands in for a part of Lua that scenes do not have; ours, where it is of an item that there is
// not.
std::string instead(lua_State* L, std::string_view message) {
  constexpr std::pair<std::string_view, const char*> missing[] = {
      {"(global 'io')",
       "; a scene has no files: results go where `output` says, lines to print or sim:log, parts of a scene come by "
       "require"},
      {"(global 'dofile')", "; a scene has no files: parts of it come by require"},
      {"(global 'loadfile')", "; a scene has no files: parts of it come by require"},
      {"(global 'debug')", "; a scene has no debug library"}};
  for (const auto& [name, advice] : missing)
    if (message.ends_with(name)) return std::string(message) + advice;
  const bool of_nothing = message.find("attempt to index a nil value (field ") != message.npos;
  return of_nothing && !nothing.text.empty() && user_place(L).text() == nothing.place.text()
             ? nothing.place.text() + ": " + nothing.text
             : std::string(message);
}

int message_handler(lua_State* L) {
  if (is_error_object(L, 1)) return 1;
  std::string message = luaL_tolstring(L, 1, nullptr);
  if (lua_type(L, 1) != LUA_TSTRING && lua_type(L, 1) != LUA_TNUMBER &&
      luaL_getmetafield(L, 1, "__tostring") == LUA_TNIL)
    message = user_place(L).text() + ": an error without a text: error(…) was given " +
              (lua_isnil(L, 1) ? "nothing" : std::string("a ") + luaL_typename(L, 1));
  message = instead(L, message);
  if (!raised_in_library(L)) {
    push_error(L, ErrorKind::input, message);
    return 1;
  }
  luaL_traceback(L, L, message.c_str(), 1);
  push_error(L, ErrorKind::internal, lua_tostring(L, -1));
  return 1;
}

}  // namespace

void open_errors(lua_State* L, const std::string& library) {
  lua_pushstring(L, ("@" + library + "/").c_str());
  lua_setfield(L, LUA_REGISTRYINDEX, library_key);
  luaL_newmetatable(L, error_metatable);
  lua_pushcfunction(L, error_text);
  lua_setfield(L, -2, "__tostring");
  lua_pushcfunction(L, error_concat);
  lua_setfield(L, -2, "__concat");
  lua_pushcfunction(L, error_index);
  lua_setfield(L, -2, "__index");
  lua_pop(L, 1);
}

void push_error(lua_State* L, ErrorKind kind, const std::string& message) {
  lua_createtable(L, 0, 2);
  lua_pushstring(L, kind_names[static_cast<std::size_t>(kind)]);
  lua_setfield(L, -2, "kind");
  lua_pushlstring(L, message.data(), message.size());
  lua_setfield(L, -2, "message");
  luaL_setmetatable(L, error_metatable);
}

void raise_error(lua_State* L, ErrorKind kind, const std::string& message) {
  push_error(L, kind, message);
  lua_error(L);
  throw std::logic_error("lua_error returned");
}

// No metamethods and no conversions here: outside of a protected call an error of Lua would end the process.
ScriptError pop_error(lua_State* L) {
  ErrorKind kind = ErrorKind::input;
  const bool is_object = is_error_object(L, -1);
  if (is_object) {
    lua_pushliteral(L, "kind");
    lua_rawget(L, -2);
    const std::string_view name = lua_isstring(L, -1) ? lua_tostring(L, -1) : "";
    const auto found = std::find(kind_names.begin(), kind_names.end(), name);
    if (found != kind_names.end()) kind = static_cast<ErrorKind>(found - kind_names.begin());
    lua_pop(L, 1);
    lua_pushliteral(L, "message");
    lua_rawget(L, -2);
  }
  const char* text = lua_tostring(L, -1);
  const std::string message = text ? text : std::string("an error without a text: a ") + luaL_typename(L, -1);
  lua_pop(L, is_object ? 2 : 1);
  return {kind, message};
}

Place user_place(lua_State* L) {
  lua_Debug frame;
  for (int level = 0; lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (*frame.what == 'C' || *frame.source != '@' || is_library(L, frame)) continue;
    return {frame.source + 1, frame.currentline};
  }
  return {};
}

void refuse(lua_State* L, const std::string& text) {
  const Place place = user_place(L);
  throw ScriptError(ErrorKind::input, (place.file.empty() ? "" : place.text() + ": ") + text);
}

void note_nothing(lua_State* L, const std::string& text) {
  nothing = {user_place(L), text};
}

void protected_call(lua_State* L, int arguments, int results) {
  const int handler = lua_gettop(L) - arguments;
  lua_pushcfunction(L, message_handler);
  lua_insert(L, handler);
  const int status = lua_pcall(L, arguments, results, handler);
  lua_remove(L, handler);
  if (status == LUA_OK) return;
  const ScriptError error = pop_error(L);
  if (status == LUA_ERRERR)  // no stack was left for the message either
    throw ScriptError(ErrorKind::input, "stack overflow: a function of the script calls itself without end");
  if (status == LUA_ERRMEM) throw ScriptError(ErrorKind::input, out_of_lua_memory());
  throw error;
}

ScriptError current_error() {
  try {
    throw;
  } catch (const ScriptError& error) {
    return error;
  } catch (const InputError& error) {
    return {ErrorKind::input, error.what()};
  } catch (const RunError& error) {
    return {ErrorKind::run, error.what()};
  } catch (const std::bad_alloc&) {
    return {ErrorKind::run, out_of_memory()};
  } catch (const std::exception& error) {
    return {ErrorKind::internal, error.what()};
  }
}

}  // namespace talus
