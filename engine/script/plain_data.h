#pragma once
// Plain Lua data (numbers, texts, true and false, nested tables of these) as bytes and back.
#include <lua.hpp>
#include <string>
#include <string_view>

namespace talus {

// The value at `index`. Anything that is no plain data is refused with its key path, which begins with `path`, at
// the script's line: ScriptError(input). A table met twice is refused too: it would come back as two.
std::string pack_plain(lua_State* L, int index, const std::string& path);

// Pushes the value again. `bytes` come from pack_plain: anything else is StateError.
void push_plain(lua_State* L, std::string_view bytes);

}  // namespace talus
