#include "script/drawing_reader.h"

#include <filesystem>

#include "input/drawing.h"
#include "script/lua_error.h"
#include "script/lua_state.h"
#include "script/session.h"

namespace talus {
namespace {

void push_points(lua_State* L, const Polyline& points) {
  lua_createtable(L, static_cast<int>(points.size()), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    lua_createtable(L, 2, 0);
    for (int k = 0; k < 2; ++k) {
      lua_pushnumber(L, points[i][k]);
      lua_rawseti(L, -2, k + 1);
    }
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
}

void push_line(lua_State* L, const DrawnLine& line) {
  lua_createtable(L, 0, 4);
  push_points(L, line.points);
  lua_setfield(L, -2, "points");
  lua_pushstring(L, line.layer.c_str());
  lua_setfield(L, -2, "layer");
  lua_pushboolean(L, line.closed);
  lua_setfield(L, -2, "closed");
  lua_pushinteger(L, line.line);
  lua_setfield(L, -2, "line");
}

void push_drawing(lua_State* L, const Drawing& drawing) {
  lua_createtable(L, 0, 4);
  lua_createtable(L, static_cast<int>(drawing.lines.size()), 0);
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    push_line(L, drawing.lines[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(L, -2, "lines");
  lua_pushnumber(L, drawing.unit);
  lua_setfield(L, -2, "unit");
  lua_pushstring(L, drawing.unit_name.c_str());
  lua_setfield(L, -2, "unit_name");
  std::string skipped;
  for (const auto& [kind, count] : drawing.skipped)
    skipped += (skipped.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
  if (skipped.empty()) return;
  lua_pushstring(L, skipped.c_str());
  lua_setfield(L, -2, "skipped");
}

}  // namespace

int native_read_drawing(lua_State* L) {
  const std::string call = luaL_checkstring(L, 1), file = luaL_checkstring(L, 2);
  const double chord = luaL_checknumber(L, 3);
  const std::filesystem::path path = std::filesystem::path(Session::of(L).folder()) / file;
  Drawing drawing;
  try {
    const std::string text = read_text(path.string(), file);
    note_file(L, path.string());
    drawing = call.ends_with("csv") ? read_csv(text, file) : read_dxf(text, file, chord);
  } catch (const FileError& error) {
    throw ScriptError(ErrorKind::input, user_place(L).text() + ": " + call + ": " + error.what());
  }
  push_drawing(L, drawing);
  return 1;
}

}  // namespace talus
