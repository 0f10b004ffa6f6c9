#include "script/coroutines.h"

#include "script/interrupt.h"

namespace talus {
namespace {

// Calls the function `original` (an index) with all that is on the stack.
int call_inside(lua_State* L, lua_State* coroutine, int original) {
  const RunningCoroutine inside(coroutine);
  lua_pushvalue(L, original);
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

// coroutine.resume; upvalue: Lua's own, which says what is wrong where there is no coroutine.
int resume_followed(lua_State* L) {
  lua_State* coroutine = lua_tothread(L, 1);
  return call_inside(L, coroutine ? coroutine : L, lua_upvalueindex(1));
}

// What coroutine.wrap returns; upvalues: Lua's own, its coroutine.
int call_wrapped(lua_State* L) {
  return call_inside(L, lua_tothread(L, lua_upvalueindex(2)), lua_upvalueindex(1));
}

int wrap_followed(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, 1);
  if (!lua_getupvalue(L, -1, 1) || !lua_isthread(L, -1)) return luaL_error(L, "coroutine.wrap of another Lua");
  lua_pushcclosure(L, call_wrapped, 2);
  return 1;
}

void replace(lua_State* L, const char* name, lua_CFunction followed) {
  lua_getfield(L, -1, name);
  lua_pushcclosure(L, followed, 1);
  lua_setfield(L, -2, name);
}

}  // namespace

void follow_coroutines(lua_State* L) {
  lua_getglobal(L, LUA_COLIBNAME);
  replace(L, "resume", resume_followed);
  replace(L, "wrap", wrap_followed);
  lua_pop(L, 1);
}

}  // namespace talus
