#include "script/laws.h"

#include <cmath>
#include <cstdio>

#include "script/interrupt.h"
#include "script/lua_error.h"

namespace talus {
namespace {

std::string table_text(lua_State* L, int index) {
  if (const lua_Unsigned length = lua_rawlen(L, index); length > 0) return "a list of " + std::to_string(length);
  lua_pushvalue(L, index);
  lua_pushnil(L);
  const bool empty = !lua_next(L, -2);
  lua_pop(L, empty ? 1 : 3);
  return empty ? "an empty table" : "a table";
}

lua_State* main_thread(lua_State* L) {
  lua_rawgeti(L, LUA_REGISTRYINDEX, LUA_RIDX_MAINTHREAD);
  lua_State* main = lua_tothread(L, -1);
  lua_pop(L, 1);
  return main;
}

}  // namespace

std::string number_text(double value) {
  if (std::isnan(value)) return "nan";  // printf may write "-nan"
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string arguments_text(std::span<const char* const> names, std::span<const double> arguments) {
  std::string text = "at ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += std::string(i ? ", " : "") + names[i] + " = " + number_text(arguments[i]);
  }
  return text;
}

LuaFunction::LuaFunction(lua_State* L, int index) : L_(main_thread(L)) {
  lua_pushvalue(L, index);
  lua_State* main = L_;
  reference_ = std::shared_ptr<int>(new int(luaL_ref(L, LUA_REGISTRYINDEX)), [main](int* reference) {
    luaL_unref(main, LUA_REGISTRYINDEX, *reference);
    delete reference;
  });
}

void LuaFunction::push() const {
  lua_rawgeti(L_, LUA_REGISTRYINDEX, *reference_);
}

std::string describe(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
      return "nothing";
    case LUA_TNUMBER:
      return number_text(lua_tonumber(L, index));
    case LUA_TSTRING:
      return '"' + std::string(lua_tostring(L, index)) + '"';
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) ? "true" : "false";
    default:
      break;
  }
  std::string name = lua_istable(L, index) ? table_text(L, index) : "a " + std::string(luaL_typename(L, index));
  if (const int type = luaL_getmetafield(L, index, "__name"); type != LUA_TNIL) {
    if (type == LUA_TSTRING) name = "a " + std::string(lua_tostring(L, -1));
    lua_pop(L, 1);
  }
  return name;
}

LawResult pop_number(lua_State* L) {
  LawResult result;
  if (lua_type(L, -1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1))) {
    result.value = lua_tonumber(L, -1);
  } else {
    result.problem = "expected a finite number, got " + describe(L, -1);
  }
  lua_pop(L, 1);
  return result;
}

namespace {

// `pop` takes what the function returned from the stack's top.
template <class Pop>
LawResult call(const LuaFunction& law, std::span<const char* const> names, std::span<const double> arguments, Pop pop) {
  lua_State* L = law.state();
  LawResult result;
  const RunningLaw running(L);
  try {
    luaL_checkstack(L, static_cast<int>(arguments.size()) + 3, "a law");
    law.push();
    for (const double argument : arguments) lua_pushnumber(L, argument);
    protected_call(L, static_cast<int>(arguments.size()), 1);
    result = pop(L);
    if (result.problem.empty()) return result;
    result.problem = ": " + result.problem;
  } catch (const ScriptError& error) {
    if (error.kind == ErrorKind::interrupt) throw;
    result.problem = std::string(" the function failed: ") + error.what();
  }
  result.problem = arguments_text(names, arguments) + result.problem;
  return result;
}

}  // namespace

LawResult call_law(const LuaFunction& law, std::span<const char* const> names, std::span<const double> arguments) {
  return call(law, names, arguments, pop_number);
}

std::function<double(double)> history_law(const LuaFunction& law, const Place& place, const std::string& label) {
  return [law, place, label](double t) {
    constexpr const char* names[] = {"t"};
    const double arguments[] = {t};
    const LawResult result = call_law(law, names, arguments);
    if (!result.problem.empty()) throw LawError(place.text() + ": " + label + ": " + result.problem);
    return result.value;
  };
}

std::function<double(double, double)> damping_law(const LuaFunction& law, const Place& place) {
  return [law, place](double speed, double dt) {
    constexpr const char* names[] = {"speed", "dt"};
    const double arguments[] = {speed, dt};
    LawResult result = call_law(law, names, arguments);
    if (result.problem.empty() && !(result.value >= 0 && result.value <= 1))
      result.problem =
          arguments_text(names, arguments) + ": expected a number in [0, 1], got " + number_text(result.value);
    if (!result.problem.empty()) throw LawError(place.text() + ": numerics.damping: " + result.problem);
    return result.value;
  };
}

std::function<double(Vec2)> size_law(const LuaFunction& law, const Place& place, const std::string& label) {
  return [law, place, label](Vec2 point) {
    constexpr const char* names[] = {"x", "y"};
    const double arguments[] = {point.x(), point.y()};
    const LawResult result = call_law(law, names, arguments);
    if (!result.problem.empty())
      throw ScriptError(ErrorKind::input, place.text() + ": " + label + ": " + result.problem);
    if (result.value > 0) return result.value;
    throw InputError(place, label + " " + arguments_text(names, arguments), "a number > 0 (m)",
                     number_text(result.value));
  };
}

std::function<int(Vec2)> choice_law(const LuaFunction& law, const Place& place, const std::string& label,
                                    const std::vector<std::string>& choices) {
  return [law, place, label, choices](Vec2 point) {
    constexpr const char* names[] = {"x", "y"};
    const double arguments[] = {point.x(), point.y()};
    const LawResult result = call(law, names, arguments, [&choices](lua_State* L) {
      const std::string given = describe(L, -1);
      lua_pop(L, 1);
      LawResult chosen;
      const auto found = std::find(choices.begin(), choices.end(), given);
      chosen.value = double(found - choices.begin());
      if (found != choices.end()) return chosen;
      std::string words = choices[0];
      for (size_t k = 1; k < choices.size(); ++k) words += (k + 1 < choices.size() ? ", " : " or ") + choices[k];
      chosen.problem = "expected " + words + ", got " + given;
      return chosen;
    });
    if (result.problem.empty()) return int(result.value);
    throw ScriptError(ErrorKind::input, place.text() + ": " + label + " " + result.problem);
  };
}

}  // namespace talus
