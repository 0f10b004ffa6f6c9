#include "script/drawing_reader.h"

#include <filesystem>

#include "input/drawing.h"
#include "input/gmsh.h"
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

namespace {

void push_surfaces(lua_State* L, const GmshMesh& mesh, double scale) {
  lua_newtable(L);
  for (const auto& [name, group] : mesh.surfaces) {
    lua_createtable(L, static_cast<int>(group.cells.size()), 0);
    for (std::size_t c = 0; c < group.cells.size(); ++c) {
      Polyline outline;
      for (const int p : group.cells[c]) outline.push_back(scale * mesh.points[p]);
      push_points(L, outline);
      lua_rawseti(L, -2, static_cast<lua_Integer>(c + 1));
    }
    lua_setfield(L, -2, name.c_str());
  }
}

void push_curves(lua_State* L, const GmshMesh& mesh, double scale) {
  lua_newtable(L);
  for (const auto& [name, group] : mesh.curves) {
    const auto runs = straight_runs(mesh, group.lines);
    lua_createtable(L, static_cast<int>(runs.size()), 0);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      push_points(L, {scale * runs[r][0], scale * runs[r][1]});
      lua_rawseti(L, -2, static_cast<lua_Integer>(r + 1));
    }
    lua_setfield(L, -2, name.c_str());
  }
}

}  // namespace

int native_read_gmsh(lua_State* L) {
  const std::string file = luaL_checkstring(L, 1);
  const double scale = luaL_checknumber(L, 2);
  const std::filesystem::path path = std::filesystem::path(Session::of(L).folder()) / file;
  GmshMesh mesh;
  try {
    const std::string text = read_text(path.string(), file);
    note_file(L, path.string());
    mesh = read_gmsh(text, file);
  } catch (const FileError& error) {
    throw ScriptError(ErrorKind::input, user_place(L).text() + ": gmsh: " + error.what());
  }
  lua_createtable(L, 0, 3);
  push_surfaces(L, mesh, scale);
  lua_setfield(L, -2, "surfaces");
  push_curves(L, mesh, scale);
  lua_setfield(L, -2, "curves");
  lua_pushinteger(L, mesh.curved);
  lua_setfield(L, -2, "curved");
  return 1;
}

}  // namespace talus
