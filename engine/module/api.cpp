// The engine's side of the Lua module: every entry catches everything.
#include "module/api.h"

#include <atomic>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "app/command.h"
#include "scene/version.h"
#include "script/interrupt.h"
#include "script/lua_error.h"
#include "script/lua_state.h"
#include "script/session.h"

struct talus_outcome {
  int status = talus::exit_bad_input;
  std::string message;
  std::vector<std::pair<std::string, std::string>> runs;  // run.json, folder
};

namespace talus {
namespace {

// Signals and the bounds of memory are the process's: one run at a time.
class Turn {
 public:
  Turn() : mine_(!taken_.exchange(true)) {}
  ~Turn() {
    if (mine_) taken_ = false;
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;
  bool mine() const { return mine_; }

 private:
  static inline std::atomic<bool> taken_ = false;
  bool mine_;
};

void ask_host(const talus_job& job, int number, Simulation& simulation) {
  const StepReport& last = simulation.last;
  const talus_step step = {.simulation = number,
                           .number = last.step,
                           .time = simulation.model.time,
                           .dt = last.dt,
                           .displacement = last.displacement,
                           .iterations = last.iterations,
                           .contacts = last.closed_contacts,
                           .failures = last.failures};
  char message[1024] = "";
  switch (job.on_step(job.host, &step, message, sizeof message)) {
    case talus_go_on:
      return;
    case talus_stop:
      return simulation.stop();
    case talus_fail:
      throw_if_interrupted();  // Ctrl-C has ended the function
      throw LawError(message);
  }
}

SessionOptions options_of(const talus_job& job, talus_outcome& outcome) {
  SessionOptions options;
  options.script = job.scene;
  for (const char* const* text = job.parameters; *text; text += 2) options.parameters.emplace_back(text[0], text[1]);
  options.output_dir = job.output ? job.output : "";
  options.command_line = job.command_line;
  options.trust = job.trust;
  options.progress = job.progress;
  options.on_failure = [&outcome](const std::string& message) { outcome.message = message; };
  options.on_end = [&outcome](const Run& run, const std::string& report) {
    outcome.runs.emplace_back(report, run.simulation.model.scene.output.dir);
  };
  if (job.on_step) {
    options.on_run = [&job, number = 0](Run& run) mutable {
      ++number;
      run.simulation.on_step.emplace_back(
          [&job, number](Simulation& simulation) { ask_host(job, number, simulation); });
    };
  }
  return options;
}

template <class Function>
int caught(std::string& message, Function function) {
  try {
    return function();
  } catch (const UsageError& problem) {
    message = problem.message;
  } catch (const std::exception& error) {
    message = error.what();
  } catch (...) {
    message = "an error of an unknown kind";
  }
  return exit_bad_input;
}

}  // namespace
}  // namespace talus

#pragma GCC visibility push(default)

talus_outcome* talus_run(const talus_job* job) {
  auto* outcome = new (std::nothrow) talus_outcome;
  if (!outcome) return nullptr;
  outcome->status = talus::caught(outcome->message, [&] {
    const talus::Turn turn;
    if (!turn.mine()) {
      outcome->message = "talus.run: expected one run at a time, got a second while one goes on in this process";
      return int(talus::exit_bad_input);
    }
    return talus::Session(talus::options_of(*job, *outcome)).execute();
  });
  return outcome;
}

int talus_status(const talus_outcome* outcome) {
  return outcome->status;
}
const char* talus_message(const talus_outcome* outcome) {
  return outcome->message.c_str();
}
long talus_simulations(const talus_outcome* outcome) {
  return long(outcome->runs.size());
}
const char* talus_report(const talus_outcome* outcome, long i) {
  return outcome->runs[std::size_t(i)].first.c_str();
}
const char* talus_folder(const talus_outcome* outcome, long i) {
  return outcome->runs[std::size_t(i)].second.c_str();
}
void talus_free(talus_outcome* outcome) {
  delete outcome;
}

int talus_main(int count, const char* const* arguments) {
  std::string message;
  const int status = talus::caught(message, [&] { return talus::run_command({arguments, arguments + count}); });
  if (!message.empty()) std::fprintf(stderr, "talus: %s\n", message.c_str());
  return status;
}

int talus_interrupted(void) {
  return talus::interrupt_signal() != 0;
}

const char* talus_library(void) {
  static std::string folder;
  std::string ignored;
  talus::caught(ignored, [] { return folder = talus::library_folder(), 0; });
  return folder.c_str();
}

const char* talus_version_text(void) {
  return talus::version;
}

#pragma GCC visibility pop
