// talus sweep: the runs of a study.
#include "sweep/sweep.h"

#include <charconv>

#include "app/command.h"
#include "script/study_reader.h"
#include "sweep/process.h"

namespace talus {
namespace {

int read_jobs(const std::string& text) {
  int jobs = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), jobs);
  if (error != std::errc() || end != text.data() + text.size() || jobs < 1)
    throw UsageError{"-j: expected how many runs at once, 1 or more, got \"" + text + "\""};
  return jobs;
}

// Whether it was one of the sweep's own options.
bool read_sweep_option(const Arguments& arguments, std::size_t& i, SweepOptions& options) {
  const std::string& argument = arguments[i];
  if (argument == "-j") {
    options.jobs = read_jobs(value_after(arguments, i));
  } else if (argument == "--only") {
    options.only.push_back(value_after(arguments, i));
  } else if (argument == "--resume") {
    options.resume = true;
  } else if (argument == "--retry") {
    options.retry = true;
  } else if (argument == "--list") {
    options.list = true;
  } else if (argument == "--collect") {
    options.collect = true;
  } else if (argument == "--slurm") {
    options.slurm = true;
  } else if (argument == "--no-wait") {
    options.wait = false;
  } else {
    return false;
  }
  return true;
}

void check_together(const SweepOptions& options) {
  const int ways = options.list + options.collect + options.slurm + !options.only.empty();
  if (ways > 1) throw UsageError{"sweep: expected one of --list, --collect, --slurm and --only, got more"};
  if (!options.wait && !options.slurm) throw UsageError{"--no-wait: expected --slurm beside it"};
  if (options.jobs > 0 && ways > 0)
    throw UsageError{"-j: expected runs on this machine, got --list, --collect, --slurm or --only"};
}

}  // namespace

int sweep_command(const Arguments& arguments) {
  SweepOptions options;
  Arguments rest;  // what every command on a script takes
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (!read_sweep_option(arguments, i, options)) rest.push_back(arguments[i]);
  check_together(options);
  SessionOptions session = read_scene_arguments(rest, "talus sweep");
  options.command = {program_path(), "sweep"};
  options.command.insert(options.command.end(), rest.begin(), rest.end());
  if (options.retry) options.command.emplace_back("--retry");
  int status = exit_ok;
  session.on_study = [&, dir = session.output_dir, script = session.script](lua_State* L, const std::string& library) {
    Study study = read_study(L, script, library);
    if (!dir.empty()) study.dir = dir;
    status = sweep(study, options);
  };
  const int session_status = Session(std::move(session)).execute();
  return session_status != exit_ok ? session_status : status;
}

}  // namespace talus
