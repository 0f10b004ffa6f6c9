#pragma once
// What stops a run from outside: SIGINT, SIGTERM, the end of its time (--limit time=…). The step in progress is
// finished, or, where it looks for equilibrium, left at the next solve and undone; then the script is left wherever it
// is. A second signal ends the process at once, and so does the clock where half a minute later neither step nor script
// has come to an end.
#include <lua.hpp>
#include <string>

namespace talus {

class Interrupts {
 public:
  // One at a time; the handlers that were there before come back with its end. With `grace`, s, the script has so long
  // to come to its next step by itself: what it notes down of the last one is then complete when the state is saved.
  explicit Interrupts(lua_State* L, double grace = 0);
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;

  // Interrupts after so many seconds, with this reason; the process exits with `status` where that does not help.
  void limit_time(double seconds, const std::string& reason, int status);
};

// The time is no longer looked at; for a program that goes on when the results are written.
void end_time_limit();

int interrupt_signal();  // what came: a signal's number, SIGALRM for the end of the time, or 0

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

// The coroutine that runs meanwhile: interrupts go to it, for each has hooks of its own.
class RunningCoroutine {
 public:
  explicit RunningCoroutine(lua_State* coroutine);
  ~RunningCoroutine();
  RunningCoroutine(const RunningCoroutine&) = delete;
  RunningCoroutine& operator=(const RunningCoroutine&) = delete;

 private:
  lua_State* before_;
};

// A function of the script that is called from inside a step. After a signal it has two seconds; one that goes on is
// left, and the step with it, of which nothing can be saved.
class RunningLaw {
 public:
  explicit RunningLaw(lua_State* L);

 private:
  RunningCoroutine in_;
};
bool law_was_left();

// Throws ScriptError(interrupt) when something of these came.
void throw_if_interrupted();

}  // namespace talus
