#include "script/plain_data.h"

#include <algorithm>
#include <map>
#include <vector>

#include "model/saved_state.h"
#include "script/laws.h"
#include "script/lua_error.h"

namespace talus {
namespace {

enum Tag : std::uint64_t { no, yes, whole, number, text, table };
constexpr int deepest = 100;  // tables in tables; Lua's own stack would end near 200

class Packer {
 public:
  explicit Packer(lua_State* L) : L_(L) {}

  std::string pack(int index, const std::string& path, int depth) {
    index = lua_absindex(L_, index);
    std::string bytes;
    switch (lua_type(L_, index)) {
      case LUA_TBOOLEAN:
        append(bytes, std::uint64_t(lua_toboolean(L_, index) ? yes : no));
        return bytes;
      case LUA_TNUMBER:
        append(bytes, std::uint64_t(lua_isinteger(L_, index) ? whole : number));
        if (lua_isinteger(L_, index))
          append(bytes, static_cast<std::uint64_t>(lua_tointeger(L_, index)));
        else
          append(bytes, lua_tonumber(L_, index));
        return bytes;
      case LUA_TSTRING: {
        std::size_t size = 0;
        const char* letters = lua_tolstring(L_, index, &size);
        append(bytes, std::uint64_t(text));
        append(bytes, std::string_view(letters, size));
        return bytes;
      }
      case LUA_TTABLE:
        return pack_table(index, path, depth);
      default:
        refuse(path, describe(L_, index));
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& path, const std::string& given) {
    const Place place = user_place(L_);  // none where the program itself saves
    throw ScriptError(ErrorKind::input, (place.file.empty() ? "" : place.text() + ": ") + path +
                                            ": expected plain data to save (a number, a text, true, false or a table "
                                            "of these), got " +
                                            given);
  }

  // ".name", "[3]", as one would write it.
  std::string step_to(int index) {
    if (lua_type(L_, index) != LUA_TSTRING) return "[" + describe(L_, index) + "]";
    return std::string(".") + lua_tostring(L_, index);
  }

  // Entries are sorted by the bytes of their keys: the order of a Lua table differs from run to run.
  std::string pack_table(int index, const std::string& path, int depth) {
    const auto [known, is_new] = met_.emplace(lua_topointer(L_, index), path);
    if (!is_new) refuse(path, "the table that is " + known->second + " too");
    if (lua_getmetatable(L_, index)) refuse(path, describe(L_, index) + " with a metatable");
    if (depth == deepest) refuse(path, "tables nested more than " + std::to_string(deepest) + " deep");
    luaL_checkstack(L_, 4, "saving");
    std::vector<std::pair<std::string, std::string>> entries;
    for (lua_pushnil(L_); lua_next(L_, index); lua_pop(L_, 1)) {
      const std::string where = path + step_to(-2);
      if (const int type = lua_type(L_, -2); type != LUA_TSTRING && type != LUA_TNUMBER && type != LUA_TBOOLEAN)
        refuse(path, "a key that is " + describe(L_, -2));
      entries.emplace_back(pack(-2, where, depth + 1), pack(-1, where, depth + 1));
    }
    std::sort(entries.begin(), entries.end());
    std::string bytes;
    append(bytes, std::uint64_t(table));
    append(bytes, std::uint64_t(entries.size()));
    for (const auto& [key, value] : entries) bytes += key + value;
    return bytes;
  }

  lua_State* L_;
  std::map<const void*, std::string> met_;
};

void push_value(lua_State* L, ByteReader& reader, int depth) {
  if (depth > deepest) throw StateError("is damaged");
  luaL_checkstack(L, 4, "a saved state");
  switch (reader.whole()) {
    case no:
      return lua_pushboolean(L, 0);
    case yes:
      return lua_pushboolean(L, 1);
    case whole:
      return lua_pushinteger(L, static_cast<lua_Integer>(reader.whole()));
    case number:
      return lua_pushnumber(L, reader.number());
    case text: {
      const std::string letters = reader.text();
      lua_pushlstring(L, letters.data(), letters.size());
      return;
    }
    case table:
      break;
    default:
      throw StateError("is damaged");
  }
  lua_newtable(L);
  for (std::uint64_t left = reader.whole(); left > 0; --left) {
    push_value(L, reader, depth + 1);
    push_value(L, reader, depth + 1);
    lua_rawset(L, -3);
  }
}

}  // namespace

std::string pack_plain(lua_State* L, int index, const std::string& path) {
  return Packer(L).pack(index, path, 0);
}

void push_plain(lua_State* L, std::string_view bytes) {
  ByteReader reader(bytes);
  push_value(L, reader, 0);
}

}  // namespace talus
