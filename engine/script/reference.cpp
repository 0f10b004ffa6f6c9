#include "script/reference.h"

#include "script/lua_error.h"
#include "script/lua_state.h"
#include "script/native.h"

namespace talus {

namespace {

// What a module of the library returns is a function; its text.
std::string text_of(const char* module) {
  const LuaState state;
  lua_State* L = state.get();
  set_search_path(L, "", state.library());
  open_native(L);
  lua_getglobal(L, "require");
  lua_pushstring(L, module);
  protected_call(L, 1, 1);
  protected_call(L, 0, 1);
  return luaL_tolstring(L, -1, nullptr);
}

}  // namespace

std::string scene_reference() {
  return text_of("talus.reference");
}

std::string editor_annotations() {
  return text_of("talus.annotations");
}

}  // namespace talus
