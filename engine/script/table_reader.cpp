#include "script/table_reader.h"

#include <stdexcept>

namespace talus {
namespace {

[[noreturn]] void mismatch(const std::string& key, const char* expected) {
  throw std::logic_error("scene table: " + key + " is no " + expected);
}

double number_at(lua_State* L, int index, lua_Integer i, const char* key) {
  lua_rawgeti(L, index, i);
  if (lua_type(L, -1) != LUA_TNUMBER) mismatch(key, "list of numbers");
  const double value = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return value;
}

Polyline polyline_at(lua_State* L, int index, const char* key) {
  index = lua_absindex(L, index);
  Polyline points(lua_rawlen(L, index));
  for (std::size_t i = 0; i < points.size(); ++i) {
    lua_rawgeti(L, index, static_cast<lua_Integer>(i + 1));
    points[i] = {number_at(L, lua_gettop(L), 1, key), number_at(L, lua_gettop(L), 2, key)};
    lua_pop(L, 1);
  }
  return points;
}

}  // namespace

TableReader::TableReader(lua_State* L, int index) : L_(L), index_(lua_absindex(L, index)) {
  if (!lua_istable(L, index_)) mismatch("an entry", "table");
  luaL_checkstack(L, 8, "reading the scene");
}

bool TableReader::push(const char* key) const {
  if (lua_getfield(L_, index_, key) != LUA_TNIL) return true;
  lua_pop(L_, 1);
  return false;
}

bool TableReader::has(const char* key) const {
  if (!push(key)) return false;
  lua_pop(L_, 1);
  return true;
}

void TableReader::read(const char* key, double& value) const {
  if (!push(key)) return;
  if (lua_type(L_, -1) != LUA_TNUMBER) mismatch(key, "number");
  value = lua_tonumber(L_, -1);
  lua_pop(L_, 1);
}

void TableReader::read(const char* key, long& value) const {
  if (!push(key)) return;
  int exact = 0;
  value = static_cast<long>(lua_tointegerx(L_, -1, &exact));
  if (!exact) mismatch(key, "integer");
  lua_pop(L_, 1);
}

void TableReader::read(const char* key, int& value) const {
  long wide = value;
  read(key, wide);
  value = static_cast<int>(wide);
}

void TableReader::read(const char* key, unsigned& value) const {
  long wide = value;
  read(key, wide);
  value = static_cast<unsigned>(wide);
}

void TableReader::read(const char* key, bool& value) const {
  if (!push(key)) return;
  if (!lua_isboolean(L_, -1)) mismatch(key, "boolean");
  value = lua_toboolean(L_, -1);
  lua_pop(L_, 1);
}

void TableReader::read(const char* key, std::string& value) const {
  if (!push(key)) return;
  if (lua_type(L_, -1) != LUA_TSTRING) mismatch(key, "string");
  value = lua_tostring(L_, -1);
  lua_pop(L_, 1);
}

void TableReader::read(const char* key, Vec2& value) const {
  if (!push(key)) return;
  if (!lua_istable(L_, -1)) mismatch(key, "point");
  const int index = lua_gettop(L_);
  value = {number_at(L_, index, 1, key), number_at(L_, index, 2, key)};
  lua_pop(L_, 1);
}

void TableReader::read(const char* key, Eigen::Vector3d& value) const {
  if (!push(key)) return;
  if (!lua_istable(L_, -1)) mismatch(key, "triple");
  const int index = lua_gettop(L_);
  for (int i = 0; i < 3; ++i) value[i] = number_at(L_, index, i + 1, key);
  lua_pop(L_, 1);
}

void TableReader::read(const char* key, Polyline& value) const {
  if (!push(key)) return;
  value = polyline_at(L_, -1, key);
  lua_pop(L_, 1);
}

void TableReader::read(const char* key, std::vector<Polyline>& value) const {
  if (!push(key)) return;
  value.resize(lua_rawlen(L_, -1));
  for (std::size_t i = 0; i < value.size(); ++i) {
    lua_rawgeti(L_, -1, static_cast<lua_Integer>(i + 1));
    value[i] = polyline_at(L_, -1, key);
    lua_pop(L_, 1);
  }
  lua_pop(L_, 1);
}

void TableReader::read(const char* key, Place& value) const {
  with(key, [&](const TableReader& place) {
    place.read("file", value.file);
    place.read("line", value.line);
  });
}

void TableReader::read_index(const char* key, int& value) const {
  value = 0;
  read(key, value);
  --value;
}

}  // namespace talus
