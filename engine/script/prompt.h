#pragma once
// -i: lines of Lua at a running simulation.
#include <lua.hpp>
#include <memory>

#include "script/run.h"

namespace talus {

// Reads lines from standard input and runs each, with `sim` and `talus` at hand, until the input ends or a line says
// `continue`. What goes wrong in one is said, and the next is read.
void prompt(lua_State* L, const std::shared_ptr<Run>& run);

}  // namespace talus
