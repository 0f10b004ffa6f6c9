#pragma once
// A Lua 5.4 state for one scene: capped memory, text chunks only, no io, os reduced to time, clock and date
// (the rest of it says what to use instead). A scene that is trusted has all of Lua.
#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <string>
#include <vector>

namespace talus {

struct LuaOptions {
  std::size_t memory_cap = std::size_t(1) << 30;  // bytes; a runaway script fails, the machine does not
  bool trust = false;
  std::string library;  // empty: the environment's TALUS_LIB, else the built-in path
};

class LuaState {
 public:
  explicit LuaState(const LuaOptions& options = {});
  ~LuaState();
  LuaState(const LuaState&) = delete;
  LuaState& operator=(const LuaState&) = delete;

  lua_State* get() const { return L_; }
  const std::string& library() const { return library_; }

 private:
  struct Memory {
    std::size_t used = 0, cap = 0;
    lua_State* L = nullptr;
    std::string library;
    void note_refusal() const;
  };
  static void* allocate(void* memory, void* block, std::size_t old_size, std::size_t new_size);

  Memory memory_;
  std::string library_;
  lua_State* L_ = nullptr;
};

// What to say where a script asked for more memory than it may have; with its line.
std::string out_of_lua_memory();

// Where the Lua library lies: the environment's TALUS_LIB, else beside an installed program, else the built-in path.
std::string library_folder();

// `require` looks in the script's folder, then in the library.
void set_search_path(lua_State* L, const std::string& script, const std::string& library);

// What a script was made of: its own file, those it requires, those it reads. With a hash of the text.
struct ScriptFile {
  std::string path;
  std::uint64_t hash = 0;
};
void note_file(lua_State* L, const std::string& path);  // as it is now
std::vector<ScriptFile> noted_files(lua_State* L);

// Loads and runs the script file; throws ScriptError.
void run_file(lua_State* L, const std::string& path);

}  // namespace talus
