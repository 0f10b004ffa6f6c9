#include "script/reference.h"

#include "script/lua_error.h"
#include "script/lua_state.h"
#include "script/native.h"

namespace talus {

std::string scene_reference() {
  const LuaState state;
  lua_State* L = state.get();
  set_search_path(L, "", state.library());
  open_native(L);
  lua_getglobal(L, "require");
  lua_pushliteral(L, "talus.reference");
  protected_call(L, 1, 1);
  protected_call(L, 0, 1);
  return luaL_tolstring(L, -1, nullptr);
}

}  // namespace talus
