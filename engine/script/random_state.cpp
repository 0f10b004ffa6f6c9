#include "script/random_state.h"

#include <cstring>

#include "model/saved_state.h"

namespace talus {
namespace {

constexpr const char* key = "talus.random";

// Lua 5.4 keeps the generator's state as bytes of a userdata that is the upvalue of math.random (lmathlib.c).
std::pair<char*, std::size_t> generator(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, key);
  const std::pair found(static_cast<char*>(lua_touserdata(L, -1)), std::size_t(lua_rawlen(L, -1)));
  lua_pop(L, 1);
  return found;
}

}  // namespace

void keep_random_state(lua_State* L) {
  lua_getglobal(L, LUA_MATHLIBNAME);
  lua_getfield(L, -1, "random");
  if (lua_getupvalue(L, -1, 1)) lua_setfield(L, LUA_REGISTRYINDEX, key);
  lua_pop(L, 2);
}

std::string random_state(lua_State* L) {
  const auto [bytes, size] = generator(L);
  return bytes ? std::string(bytes, size) : "";
}

void set_random_state(lua_State* L, std::string_view saved) {
  const auto [bytes, size] = generator(L);
  if (saved.size() != (bytes ? size : 0)) throw StateError("has another kind of random generator than this Lua");
  if (bytes) std::memcpy(bytes, saved.data(), size);
}

}  // namespace talus
