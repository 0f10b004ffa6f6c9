#pragma once
// The state of Lua's generator (math.random), so that laws that draw numbers go on after a restart as if there had been
// none.
#include <lua.hpp>
#include <string>
#include <string_view>

namespace talus {

// Keeps hold of the generator, whatever the script makes of math.random later.
void keep_random_state(lua_State* L);

std::string random_state(lua_State* L);
// Throws StateError where it is of another kind of generator.
void set_random_state(lua_State* L, std::string_view bytes);

}  // namespace talus
