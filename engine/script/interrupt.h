#pragma once
// SIGINT and SIGTERM: the step in progress is finished, then the script is left wherever it is. A second
// signal ends the process at once.
#include <lua.hpp>

namespace talus {

class Interrupts {
 public:
  explicit Interrupts(lua_State* L);  // one at a time
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;
};

int interrupt_signal();  // the signal that came, or 0

// Holds interrupts of Lua code back (laws called from inside a step), or lets them through again (handlers).
class InterruptsHeld {
 public:
  explicit InterruptsHeld(bool held = true);
  ~InterruptsHeld();
  InterruptsHeld(const InterruptsHeld&) = delete;
  InterruptsHeld& operator=(const InterruptsHeld&) = delete;

 private:
  bool before_;
};

// Throws ScriptError(interrupt) when a signal came.
void throw_if_interrupted();

}  // namespace talus
