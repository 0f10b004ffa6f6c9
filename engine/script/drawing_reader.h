#pragma once
// read_drawing(call, file, chord): what scenes get of a CSV or DXF file beside them.
#include <lua.hpp>

namespace talus {

// -> { lines = { { layer, line, closed, points = {{x, y}, …} }, … }, unit, unit_name, skipped }, by the file's
// ending. skipped: a text such as "3 TEXT, 1 HATCH", or nil. `call` is what messages begin with.
int native_read_drawing(lua_State* L);
// read_gmsh(file, scale): { surfaces = { name = { outline, … } }, curves = { name = { { from, to }, … } }, curved =
// count }
int native_read_gmsh(lua_State* L);

}  // namespace talus
