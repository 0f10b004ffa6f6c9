#pragma once
// sim:save, sim:restore and sim:hash, and the way of a saved state into a simulation that is restarted.
#include <lua.hpp>
#include <memory>

#include "script/run.h"

namespace talus {

void open_saved_view(lua_State* L);
// The engine's half of save and restore, set as functions of the table on the stack's top (lib/talus/saving.lua).
void add_saving(lua_State* L);
void push_saving(lua_State* L);  // that table of functions

// A simulation that is to be restarted: its sim.state is there from the start, ...
void fill_restart_state(lua_State* L, const std::shared_ptr<Run>& run);
// ... the rest comes before its first step.
void resume(lua_State* L, const std::shared_ptr<Run>& run);

}  // namespace talus
