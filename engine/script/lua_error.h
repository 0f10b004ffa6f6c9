#pragma once
// The one place where C++ exceptions become Lua errors and Lua errors become C++ exceptions. An error
// raised by the engine or the Lua library is an object with `kind` and `message`; tostring gives the message.
#include <lua.hpp>
#include <stdexcept>
#include <string>

#include "scene/error.h"

namespace talus {

enum class ErrorKind {
  input,      // the scene cannot be worked with
  run,        // the run cannot go on
  internal,   // a fault of Talus: the message carries a traceback
  interrupt,  // a signal asked to stop
  planned     // `talus plan` has seen all it wants
};

class ScriptError : public std::runtime_error {
 public:
  ScriptError(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind(kind) {}
  ErrorKind kind;
};

// A run that a function of the script has stopped: its message names the line already.
class LawError : public RunError {
 public:
  using RunError::RunError;
};

// Registers the metatable of error objects; `library` is the folder whose frames are not the user's.
void open_errors(lua_State* L, const std::string& library);

void push_error(lua_State* L, ErrorKind kind, const std::string& message);
[[noreturn]] void raise_error(lua_State* L, ErrorKind kind, const std::string& message);
ScriptError pop_error(lua_State* L);  // the error value on the top of the stack

// The nearest line of the user's own script on the call stack; empty where there is none.
Place user_place(lua_State* L);

// ScriptError(input) with that line before it, where there is one.
[[noreturn]] void refuse(lua_State* L, const std::string& text);

// nil was read here, where `text` tells why; an error of Lua that follows from it in the same line is told with that.
void note_nothing(lua_State* L, const std::string& text);

// lua_pcall that throws ScriptError. A traceback is added only where the library itself is at fault.
void protected_call(lua_State* L, int arguments, int results);

// The exception in flight as an error of Lua. To be called from a catch block.
ScriptError current_error();

// Wraps a binding: what it throws becomes a Lua error. Lua's own errors, also C++ exceptions in this
// build of Lua but no std::exception, pass through.
template <int (*function)(lua_State*)>
int guarded(lua_State* L) {
  ErrorKind kind;
  std::string message;
  try {
    return function(L);
  } catch (const std::exception&) {
    const ScriptError error = current_error();
    kind = error.kind;
    message = error.what();
  }
  raise_error(L, kind, message);
}

}  // namespace talus
