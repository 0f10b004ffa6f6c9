#include "sweep/pool.h"

#include <sys/wait.h>

#include <algorithm>
#include <filesystem>

#include "output/text.h"
#include "step/clock.h"

namespace talus {

namespace fs = std::filesystem;

namespace {

constexpr double tick = 0.2;  // s between looks at clocks and at folders that others work on
constexpr double grace = 20;  // s for a run to write its results after it was asked to stop
constexpr const char* log_name = "log.txt";
constexpr const char* inputs_name = "run.inputs";

// What an earlier try left in the folder: not even its figures may stay beside new ones.
void clear_folder(const std::string& folder) {
  remove_outcome(folder);  // first: from here on the run is not finished
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != ".lock") fs::remove_all(entry.path());
}

std::vector<std::string> command_of(const Study& study, std::size_t run, const std::string& program) {
  std::vector<std::string> words = {program, "run", fs::absolute(study.scene).lexically_normal().string()};
  for (const Setting& setting : study.runs[run].settings) {
    words.push_back("-p");
    words.push_back(setting.name + "=" + setting.text);
  }
  for (const char* word : {"-o", ".", "--inputs", inputs_name}) words.push_back(word);
  return words;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

bool reusable(const Study& study, Keys& keys, std::size_t run, const Outcome& outcome, bool retry) {
  if (!outcome.final() || !keys.same(run, outcome)) return false;
  if (outcome.time_limit > 0 && (study.time_limit == 0 || study.time_limit > outcome.time_limit)) return false;
  return outcome.good() || !retry;
}

int Pool::work(std::deque<std::size_t> queue) {
  const HeldSignals signals;
  int stopped_by = 0;
  while (!jobs_.empty() || (!queue.empty() && stopped_by == 0)) {
    std::size_t elsewhere = 0;  // runs at the front of the queue that other processes have
    while (stopped_by == 0 && elsewhere < queue.size() && static_cast<int>(jobs_.size()) < options_.jobs) {
      const std::size_t run = queue.front();
      queue.pop_front();
      if (start(run)) continue;
      queue.push_back(run);
      ++elsewhere;
    }
    if (on_tick) on_tick();
    if (jobs_.empty() && queue.empty()) break;
    const int number = signals.wait(tick);
    if (number != 0 && number != SIGCHLD) {
      stop_all(stopped_by == 0 ? SIGTERM : SIGKILL);
      stopped_by = number;
    }
    reap(stopped_by != 0);
    stop_overdue();
  }
  return stopped_by;
}

bool Pool::start(std::size_t run) {
  const std::string folder = study_.folder(run);
  FolderLock lock(folder);
  if (!lock.held()) return false;
  if (const auto outcome = read_outcome(folder); outcome && reusable(study_, keys_, run, *outcome, options_.retry)) {
    on_end(run, *outcome);  // another sweep has made it in the meantime
    return true;
  }
  clear_folder(folder);
  const pid_t process = launch({.arguments = command_of(study_, run, program_),
                                .folder = folder,
                                .log = folder + "/" + log_name,
                                .library = fs::absolute(study_.library).lexically_normal().string(),
                                .lock = lock.file(),
                                .threads = options_.threads});
  jobs_.push_back({run, process, wall_seconds(), std::move(lock)});
  return true;
}

void Pool::reap(bool stopping) {
  for (auto job = jobs_.begin(); job != jobs_.end();) {
    int status = 0;
    rusage usage{};
    if (wait4(job->process, &status, WNOHANG, &usage) != job->process) {
      ++job;
      continue;
    }
    // What a signal to the sweep has ended is not finished: it leaves no mark.
    const bool cut_off = stopping && (WIFSIGNALED(status) || WEXITSTATUS(status) > 128) && !job->over_time;
    if (!cut_off) finish(*job, status, usage);
    job = jobs_.erase(job);
  }
}

void Pool::finish(const Job& job, int status, const rusage& usage) {
  const std::string folder = study_.folder(job.run);
  const bool by_itself = WIFEXITED(status) && WEXITSTATUS(status) <= 3;  // just before it was asked to stop
  const bool over_time = job.over_time && !by_itself;
  Outcome outcome{.key = keys_.of(job.run),
                  .exit_status = WIFSIGNALED(status) ? 0 : WEXITSTATUS(status),
                  .signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0,
                  .time_limit = over_time ? study_.time_limit : 0,
                  .wall = wall_seconds() - job.started,
                  .cpu = seconds(usage.ru_utime) + seconds(usage.ru_stime),
                  .inputs = keys_.read_inputs(folder + "/" + inputs_name)};
  outcome.message = over_time ? "stopped after the study's time_limit of " + shortest(study_.time_limit) + " s"
                              : message_of_log(folder + "/" + log_name, outcome.exit_status, outcome.signal);
  if (outcome.final()) write_outcome(folder, outcome);
  on_end(job.run, outcome);
}

void Pool::stop_overdue() {
  const double now = wall_seconds();
  for (Job& job : jobs_) {
    if (study_.time_limit > 0 && job.killed_at == 0 && now - job.started > study_.time_limit) {
      job.over_time = true;
      job.killed_at = now;
      kill(job.process, SIGTERM);
    }
    if (job.killed_at > 0 && now - job.killed_at > grace) kill(job.process, SIGKILL);
  }
}

void Pool::stop_all(int number) {
  for (Job& job : jobs_) {
    if (job.killed_at == 0) job.killed_at = wall_seconds();
    kill(job.process, number);
  }
}

std::vector<double> Pool::started() const {
  std::vector<double> times;
  for (const Job& job : jobs_) times.push_back(job.started);
  return times;
}

}  // namespace talus
