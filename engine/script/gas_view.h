#pragma once
// Explosion gas as Lua tables.
#include <lua.hpp>

#include "step/simulation.h"

namespace talus {

// Notes of charges whose gas was out in the step in which they went off: a hole that is cut open without intent.
std::vector<std::string> early_venting(const Simulation& simulation);
int push_gas_events(lua_State* L, const Simulation& simulation);  // one value: the list that on_gas gets
void push_charges(lua_State* L, const Simulation& simulation);    // sim.charges

}  // namespace talus
