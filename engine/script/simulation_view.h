#pragma once
// `sim`: a running simulation as a Lua value.
#include <lua.hpp>
#include <memory>

#include "script/run.h"

namespace talus {

void open_simulation_view(lua_State* L);
void new_simulation(lua_State* L, const std::shared_ptr<Run>& run);   // makes and pushes its Lua value
void push_simulation(lua_State* L, const std::shared_ptr<Run>& run);  // pushes the value made before
void push_simulation_methods(lua_State* L);  // the table of methods; the Lua library adds to it
Run& check_simulation(lua_State* L, int index);
// null when the script has dropped it and its value is only left in a finalizer or weak table
Run* live_simulation(lua_State* L, int index);

}  // namespace talus
