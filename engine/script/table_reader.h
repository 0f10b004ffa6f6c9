#pragma once
// Reads the flat tables that the Lua library has checked. A mismatch here is a fault of the library, not of
// the user's scene: std::logic_error.
#include <lua.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "scene/error.h"

namespace talus {

class TableReader {
 public:
  TableReader(lua_State* L, int index);

  // Each leaves `value` alone where the key is absent.
  void read(const char* key, double& value) const;
  void read(const char* key, int& value) const;
  void read(const char* key, unsigned& value) const;
  void read(const char* key, long& value) const;
  void read(const char* key, bool& value) const;
  void read(const char* key, std::string& value) const;
  void read(const char* key, Vec2& value) const;
  void read(const char* key, Eigen::Vector3d& value) const;
  void read(const char* key, Polyline& value) const;
  void read(const char* key, std::vector<Polyline>& value) const;
  void read(const char* key, Place& value) const;
  template <class T>
  void read(const char* key, std::optional<T>& value) const {
    if (has(key)) read(key, value.emplace());
  }
  // 1-based in Lua, 0-based here; absent: -1.
  void read_index(const char* key, int& value) const;

  bool has(const char* key) const;

  // f(TableReader) for each element of a list, or for one sub-table.
  template <class F>
  void each(const char* key, F&& f) const {
    if (!push(key)) return;
    const auto count = static_cast<lua_Integer>(lua_rawlen(L_, -1));
    for (lua_Integer i = 1; i <= count; ++i) {
      lua_rawgeti(L_, -1, i);
      f(TableReader(L_, -1));
      lua_pop(L_, 1);
    }
    lua_pop(L_, 1);
  }
  template <class F>
  void with(const char* key, F&& f) const {
    if (!push(key)) return;
    f(TableReader(L_, -1));
    lua_pop(L_, 1);
  }

  // Pushes the value and returns true, or pushes nothing.
  bool push(const char* key) const;
  lua_State* state() const { return L_; }

 private:
  lua_State* L_;
  int index_;
};

}  // namespace talus
