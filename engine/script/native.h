#pragma once
// require "talus.native": what the Lua library needs of the engine.
#include <lua.hpp>

namespace talus {

void open_native(lua_State* L);

}  // namespace talus
