#pragma once
// Explosion gas as Lua tables.
#include <lua.hpp>

#include "step/simulation.h"

namespace talus {

int push_gas_events(lua_State* L, const Simulation& simulation);  // one value: the list that on_gas gets
void push_charges(lua_State* L, const Simulation& simulation);    // sim.charges

}  // namespace talus
