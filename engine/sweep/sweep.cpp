#include "sweep/sweep.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <thread>

#include "output/output.h"
#include "output/progress.h"
#include "scene/error.h"
#include "step/clock.h"
#include "sweep/page.h"
#include "sweep/pool.h"
#include "sweep/scene_parameters.h"
#include "sweep/slurm.h"
#include "sweep/sweep_progress.h"
#include "sweep/table.h"

namespace talus {

namespace {

constexpr std::size_t most_said = 10;  // failures that are told when they come; what many runs fail of is told once
constexpr double table_every = 5;      // s between tables while runs end

std::string plural(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

class Sweep {
 public:
  Sweep(const Study& study, const SweepOptions& options)
      : study_(study), options_(options), keys_(study), rows_(study.runs.size()) {
    options_.jobs =
        options.jobs > 0 ? options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  }

  int execute();

 private:
  void look_at_what_is_there();
  void take(std::size_t run, const Outcome& outcome);
  void ended(std::size_t run, const Outcome& outcome);
  int run_here(const std::deque<std::size_t>& queue);
  int run_on_cluster();
  int run_only();
  int list() const;
  std::vector<std::size_t> missing() const;
  void write_table();
  int write_results(int signal);
  void warn_of_changes();

  const Study& study_;
  SweepOptions options_;
  Keys keys_;
  std::vector<StudyRow> rows_;
  SweepProgress progress_;
  std::set<std::string> said_;
  SweepCount count_;
  double run_seconds_ = 0;  // wall time of the runs that have ended in this sweep
  double table_written_ = 0;
};

// A run's results as its study wants them.
void Sweep::take(std::size_t run, const Outcome& outcome) {
  rows_[run].outcome = outcome;
  rows_[run].collected = outcome.has_results() && study_.collect
                             ? study_.collect(run, study_.folder(run), HeldSignals::stop_asked)
                             : Collected{};
}

void Sweep::look_at_what_is_there() {
  std::size_t stale = 0;
  for (std::size_t run = 0; run < rows_.size(); ++run) {
    const auto outcome = read_outcome(study_.folder(run));
    if (!outcome) continue;
    if (reusable(study_, keys_, run, *outcome, options_.retry)) {
      take(run, *outcome);
    } else if (outcome->final() && !keys_.same(run, *outcome)) {
      ++stale;
    }
  }
  count_.all = rows_.size();
  count_.before = count_.all - missing().size();
  if (stale > 0)
    progress_.say(plural(stale, "finished run") + (stale == 1 ? " is" : " are") +
                  " of another scene, library or Talus: not taken");
}

std::vector<std::size_t> Sweep::missing() const {
  std::vector<std::size_t> runs;
  for (std::size_t run = 0; run < rows_.size(); ++run)
    if (!rows_[run].outcome) runs.push_back(run);
  return runs;
}

void Sweep::ended(std::size_t run, const Outcome& outcome) {
  take(run, outcome);
  ++count_.ended;
  run_seconds_ += outcome.wall;
  if (rows_[run].good()) return;
  ++count_.failed;
  const std::string what = rows_[run].status() + ": " + rows_[run].message();
  if (said_.size() < most_said && said_.insert(what).second) progress_.say(study_.runs[run].name + ": " + what);
}

int Sweep::run_here(const std::deque<std::size_t>& queue) {
  Pool pool(study_, keys_, {.jobs = options_.jobs, .threads = 1, .retry = options_.retry});
  pool.on_end = [&](std::size_t run, const Outcome& outcome) { ended(run, outcome); };
  pool.on_tick = [&] {
    const double now = wall_seconds();
    std::vector<double> at_work = pool.started();
    for (double& time : at_work) time = now - time;
    const double mean = count_.ended > 0 ? run_seconds_ / static_cast<double>(count_.ended) : 0;
    progress_.show(sweep_line(count_, at_work.size(), seconds_left(count_, mean, at_work, options_.jobs)));
    if (now - table_written_ > table_every && count_.ended > 0) write_table();
  };
  return pool.work(queue);
}

// What a scheduler calls for each run: no table, as many of these may work at the same time.
int Sweep::run_only() {
  std::deque<std::size_t> queue;
  for (const std::string& wanted : options_.only) {
    std::size_t number = 0;
    std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    const auto found = std::ranges::find(study_.runs, wanted, &StudyRun::name);
    if (found != study_.runs.end()) {
      queue.push_back(static_cast<std::size_t>(found - study_.runs.begin()));
    } else if (std::to_string(number) == wanted && number >= 1 && number <= study_.runs.size()) {
      queue.push_back(number - 1);
    } else {
      throw InputError(
          {}, "--only",
          "the name of a run of " + study_.file + ", or its number from 1 to " + std::to_string(study_.runs.size()),
          '"' + wanted + '"');
    }
  }
  int status = 0;
  Pool pool(study_, keys_, {.jobs = 1, .threads = study_.slurm.cpus, .retry = options_.retry});
  pool.on_end = [&](std::size_t run, const Outcome& outcome) {
    if (outcome.good()) return;
    progress_.say(study_.runs[run].name + ": " + outcome.status() + ": " + outcome.message);
    status = std::max(status, outcome.signal != 0 ? 128 + outcome.signal : std::max(1, outcome.exit_status));
  };
  const int signal = pool.work(queue);
  return signal != 0 ? 128 + signal : status;
}

int Sweep::list() const {
  if (missing().empty()) std::fprintf(stderr, "all %zu runs are finished\n", rows_.size());
  for (const std::size_t run : missing()) {
    std::string line = "cd " + shell_quoted(std::filesystem::current_path().string()) + " && ";
    for (const std::string& word : options_.command) line += shell_quoted(word) + " ";
    std::printf("%s--only %s\n", line.c_str(), shell_quoted(study_.runs[run].name).c_str());
  }
  return 0;
}

int Sweep::run_on_cluster() {
  SlurmJob job(study_, options_.command);
  const std::vector<std::size_t> runs = missing();
  if (!job.running()) {
    if (runs.empty()) return 0;
    job.submit(runs);
    progress_.say(plural(runs.size(), "run") + " submitted as Slurm job " + job.name());
  } else {
    progress_.say("Slurm job " + job.name() + " of this study is there already");
  }
  if (!options_.wait) return 0;
  const HeldSignals signals;
  while (true) {
    const bool running = job.running();  // before the last look at the folders
    for (const std::size_t run : missing()) {
      const auto outcome = read_outcome(study_.folder(run));
      if (outcome && reusable(study_, keys_, run, *outcome, options_.retry)) ended(run, *outcome);
    }
    if (!running) break;
    progress_.show(sweep_line(count_, 0, -1) + ", Slurm job " + job.name() + ": " + job.states());
    const int number = signals.wait(job.pause());
    if (number == 0 || number == SIGCHLD) continue;
    progress_.say("Slurm job " + job.name() + " goes on; the same command waits for it again, scancel ends it");
    return number;
  }
  for (const auto& [run, state] : job.ends(missing())) rows_[run].note = "Slurm: " + state;
  return 0;
}

void Sweep::write_table() {
  write_whole(study_.dir + "/results.csv", results_table(study_, rows_));
  table_written_ = wall_seconds();
}

// A scene that was edited while its runs were made: the table mixes both.
void Sweep::warn_of_changes() {
  Keys now(study_);
  std::size_t old = 0;
  for (std::size_t run = 0; run < rows_.size(); ++run)
    if (rows_[run].outcome && rows_[run].outcome->final() && !now.same(run, *rows_[run].outcome)) ++old;
  if (old > 0)
    progress_.say(plural(old, "run") + (old == 1 ? " is" : " are") +
                  " of files that have changed meanwhile: the next sweep makes " + (old == 1 ? "it" : "them") +
                  " again");
}

int Sweep::write_results(int signal) {
  warn_of_changes();
  write_table();
  write_whole(study_.dir + "/index.html", results_page(study_, rows_));
  progress_.clear();
  std::map<std::string, std::size_t> counts;
  bool all_good = true;
  for (const StudyRow& row : rows_) {
    ++counts[row.status()];
    all_good = all_good && row.good();
  }
  std::string line = plural(rows_.size(), "run") + ":";
  for (const auto& [status, count] : counts) line += " " + std::to_string(count) + " " + status + ",";
  if (count_.before > 0 && count_.ended > 0) line += " " + std::to_string(count_.before) + " of them before,";
  line.back() = ';';
  std::printf("%s %s/results.csv, %s/index.html\n", line.c_str(), study_.dir.c_str(), study_.dir.c_str());
  if (signal != 0) std::fprintf(stderr, "talus: stopped by a signal; the same command goes on from here\n");
  return signal != 0 ? 128 + signal : all_good ? 0 : 1;
}

int Sweep::execute() {
  if (options_.resume && !std::filesystem::exists(study_.dir + "/runs"))
    throw InputError({}, "--resume", "a study that was begun in " + study_.dir, "nothing there");
  if (!options_.only.empty()) return run_only();
  if (!options_.collect) check_parameters(study_);
  look_at_what_is_there();
  if (options_.list) return list();
  std::error_code error;
  std::filesystem::create_directories(study_.dir, error);
  if (error) throw RunError("cannot make the folder " + study_.dir + ": " + error.message());
  int signal = 0;
  if (options_.slurm) {
    signal = run_on_cluster();
    if (signal == 0 && !options_.wait) return 0;
  } else if (!options_.collect) {
    const std::vector<std::size_t> runs = missing();
    if (!runs.empty()) signal = run_here({runs.begin(), runs.end()});
  }
  return write_results(signal);
}

}  // namespace

int sweep(const Study& study, const SweepOptions& options) {
  return Sweep(study, options).execute();
}

}  // namespace talus
