#pragma once
// Lua functions behind C++ interfaces. Laws are pure; each call is protected and its result checked.
#include <functional>
#include <lua.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "scene/error.h"

namespace talus {

// A Lua function kept alive by the registry. Calls run on the main thread of its state.
class LuaFunction {
 public:
  LuaFunction(lua_State* L, int index);
  void push() const;
  lua_State* state() const { return L_; }

 private:
  lua_State* L_;
  std::shared_ptr<int> reference_;
};

// How a message shows a value: 35, "35", nothing, a function, a table, a talus.material.
std::string describe(lua_State* L, int index);

std::string number_text(double value);  // as messages show it
// "at t = 0.5, x = 2"
std::string arguments_text(std::span<const char* const> names, std::span<const double> arguments);

// A finite number, or in words what went wrong ("at t = 0.5: expected a finite number, got nothing").
struct LawResult {
  double value = 0;
  std::string problem;
};
LawResult call_law(const LuaFunction& law, std::span<const char* const> names, std::span<const double> arguments);

// Histories: f(t). Throws RunError naming the law, its place, t and what it returned.
std::function<double(double)> history_law(const LuaFunction& law, const Place& place, const std::string& label);

// Damping laws: k(speed, dt) in [0, 1]. Throws LawError.
std::function<double(double, double)> damping_law(const LuaFunction& law, const Place& place);

// Mesh size fields: f(x, y) > 0. Throws InputError.
std::function<double(Vec2)> size_law(const LuaFunction& law, const Place& place, const std::string& label);

// f(x, y), one of a few values as messages show them (1, "rigid"): the place of the value in that list. Throws
// InputError.
std::function<int(Vec2)> choice_law(const LuaFunction& law, const Place& place, const std::string& label,
                                    const std::vector<std::string>& choices);

// Reads a finite number from the stack's top and pops it; for calls whose arguments are no plain numbers.
LawResult pop_number(lua_State* L);

}  // namespace talus
