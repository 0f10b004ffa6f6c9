#include "script/interrupt.h"

#include <csignal>
#include <string>

#include "script/lua_error.h"

namespace talus {
namespace {

volatile std::sig_atomic_t signal_seen = 0;
lua_State* interrupted_state = nullptr;
bool held = false;

std::string signal_text() {
  return signal_seen == SIGTERM ? "stopped by SIGTERM" : "stopped by SIGINT";
}

// Stays set, so that a script cannot swallow the interrupt with pcall.
void interrupt_hook(lua_State* L, lua_Debug*) {
  if (!held) raise_error(L, ErrorKind::interrupt, signal_text());
}

void on_signal(int number) {
  signal_seen = number;
  // lua_sethook may be called from a signal handler (Lua 5.4 manual, 4.7).
  if (interrupted_state)
    lua_sethook(interrupted_state, interrupt_hook, LUA_MASKCALL | LUA_MASKRET | LUA_MASKCOUNT, 1);
}

void set_handler(int number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = handler == SIG_DFL ? 0 : SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

}  // namespace

Interrupts::Interrupts(lua_State* L) {
  signal_seen = 0;
  interrupted_state = L;
  set_handler(SIGINT, on_signal);
  set_handler(SIGTERM, on_signal);
}

Interrupts::~Interrupts() {
  set_handler(SIGINT, SIG_DFL);
  set_handler(SIGTERM, SIG_DFL);
  lua_sethook(interrupted_state, nullptr, 0, 0);
  interrupted_state = nullptr;
}

int interrupt_signal() {
  return signal_seen;
}

InterruptsHeld::InterruptsHeld(bool hold) : before_(held) {
  held = hold;
}
InterruptsHeld::~InterruptsHeld() {
  held = before_;
}

void throw_if_interrupted() {
  if (signal_seen) throw ScriptError(ErrorKind::interrupt, signal_text());
}

}  // namespace talus
