#include "script/interrupt.h"

#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <string>

#include "script/lua_error.h"
#include "step/clock.h"

namespace talus {
namespace {

constexpr int patience = 30;              // s, from the end of the time to that of the process
constexpr double patience_with_laws = 2;  // s

volatile std::sig_atomic_t signal_seen = 0;
lua_State* volatile running = nullptr;
bool held = false, law_left = false;
double law_ends = 0;               // s, of the clock, for a law that goes on after a signal; 0: none did yet
double grace = 0, grace_ends = 0;  // s; of the clock, 0: nothing came yet
std::string time_reason, last_words;
int time_status = 0;
bool time_limited = false;
volatile std::sig_atomic_t rung = 0;                     // the clock
struct sigaction before_int, before_term, before_alarm;  // handlers of the program that the run is in

std::string signal_text() {
  if (signal_seen == SIGALRM) return time_reason;
  return signal_seen == SIGTERM ? "stopped by SIGTERM" : "stopped by SIGINT";
}

// Stays set, so that a script cannot swallow the interrupt with pcall.
void interrupt_hook(lua_State* L, lua_Debug*) {
  if (held) {
    if (law_ends == 0) law_ends = wall_seconds() + patience_with_laws;
    if (wall_seconds() < law_ends) return;
    law_left = true;
    raise_error(L, ErrorKind::interrupt, signal_text() + ", in a function that the step waited for: that step is lost");
  }
  if (grace > 0) {
    if (grace_ends == 0) grace_ends = wall_seconds() + grace;
    if (wall_seconds() < grace_ends) return;
  }
  raise_error(L, ErrorKind::interrupt, signal_text());
}

// lua_sethook may be called from a signal handler (Lua 5.4 manual, 4.7).
void set_hook(lua_State* L) {
  if (L) lua_sethook(L, interrupt_hook, LUA_MASKCALL | LUA_MASKRET | LUA_MASKCOUNT, 1);
}

void on_signal(int number) {
  signal_seen = number;
  set_hook(running);
}

// The clock rings again after `patience`.
void on_alarm(int) {
  if (rung) {
    if (write(STDERR_FILENO, last_words.data(), last_words.size()) < 0) _exit(time_status);
    _exit(time_status);
  }
  rung = 1;
  if (!signal_seen) on_signal(SIGALRM);
}

void set_handler(int number, void (*handler)(int), int flags, struct sigaction& before) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, &before);
}

timeval time_of(double seconds) {
  return {.tv_sec = time_t(seconds), .tv_usec = suseconds_t(std::fmod(seconds, 1) * 1e6)};
}

}  // namespace

Interrupts::Interrupts(lua_State* L, double seconds) {
  signal_seen = 0;
  running = L;
  grace = seconds;
  grace_ends = 0;
  law_left = false;
  set_handler(SIGINT, on_signal, SA_RESETHAND, before_int);
  set_handler(SIGTERM, on_signal, SA_RESETHAND, before_term);
}

void Interrupts::limit_time(double seconds, const std::string& reason, int status) {
  time_reason = reason;
  last_words = "talus: " + reason + "; after " + std::to_string(patience) +
               " s more the step is not done, and is left: results are those written before it\n";
  time_status = status;
  time_limited = true;
  rung = 0;
  set_handler(SIGALRM, on_alarm, SA_RESTART, before_alarm);
  const itimerval timer = {.it_interval = time_of(patience), .it_value = time_of(std::max(seconds, 1e-3))};
  setitimer(ITIMER_REAL, &timer, nullptr);
}

Interrupts::~Interrupts() {
  sigaction(SIGINT, &before_int, nullptr);
  sigaction(SIGTERM, &before_term, nullptr);
  lua_sethook(running, nullptr, 0, 0);
  running = nullptr;
}

void end_time_limit() {
  if (!time_limited) return;
  const itimerval none = {};
  setitimer(ITIMER_REAL, &none, nullptr);
  sigaction(SIGALRM, &before_alarm, nullptr);
  time_limited = false;
}

int interrupt_signal() {
  return signal_seen;
}

bool law_was_left() {
  return law_left;
}

InterruptsHeld::InterruptsHeld(bool hold) : before_(held) {
  held = hold;
}
InterruptsHeld::~InterruptsHeld() {
  held = before_;
}

RunningCoroutine::RunningCoroutine(lua_State* coroutine) : before_(running) {
  if (!before_) return;  // nothing listens to signals
  running = coroutine;
  if (signal_seen) set_hook(coroutine);
}
RunningCoroutine::~RunningCoroutine() {
  if (!before_) return;
  running = before_;
  if (signal_seen) set_hook(before_);
}

RunningLaw::RunningLaw(lua_State* L) : in_(L) {
  law_ends = 0;
}

void throw_if_interrupted() {
  if (signal_seen) throw ScriptError(ErrorKind::interrupt, signal_text());
}

}  // namespace talus
