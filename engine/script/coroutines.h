#pragma once
// Coroutines that an interrupt reaches.
#include <lua.hpp>

namespace talus {

// Has coroutine.resume and coroutine.wrap tell which coroutine runs (script/interrupt.h).
void follow_coroutines(lua_State* L);

}  // namespace talus
