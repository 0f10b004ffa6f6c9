#pragma once
// Pictures and tables that a script draws of its own numbers: sim:plot and sim:table.
#include <lua.hpp>

namespace talus {

// Into the table on the top: plot(simulation, name, fields) and table(simulation, name, columns).
void add_plots(lua_State* L);

}  // namespace talus
