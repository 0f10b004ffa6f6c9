#pragma once
// What has broken, as Lua tables.
#include <lua.hpp>

#include "step/simulation.h"

namespace talus {

int push_fractures(lua_State* L, const Simulation& simulation);  // one value: the list that on_fracture gets
void push_cracks(lua_State* L, const Model& model);              // sim.cracks
void push_fragments(lua_State* L, const Model& model);           // sim.fragments
void push_reactions(lua_State* L, Simulation& simulation);       // sim.reactions

}  // namespace talus
