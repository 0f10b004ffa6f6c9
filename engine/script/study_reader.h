#pragma once
// The flat table that lib/talus/study makes of a talus.study.
#include <lua.hpp>
#include <string>

#include "scene/study.h"

namespace talus {

// From the table on the top of the stack. `script` is the study's file, `library` the Lua library's folder. The
// study's collect calls Lua and must not outlive the state.
Study read_study(lua_State* L, const std::string& script, const std::string& library);

}  // namespace talus
