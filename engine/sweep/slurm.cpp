#include "sweep/slurm.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "output/output.h"
#include "scene/error.h"
#include "sweep/process.h"

namespace talus {

namespace fs = std::filesystem;

namespace {

constexpr double longest_pause = 10;         // s
constexpr std::size_t default_array = 1000;  // tasks, where Slurm's MaxArraySize is 1001

// States that a task does not leave any more (squeue's manual page, job state codes).
bool has_ended(const std::string& state) {
  static const std::set<std::string> ended = {"BOOT_FAIL", "CANCELLED",     "COMPLETED", "DEADLINE", "FAILED",
                                              "NODE_FAIL", "OUT_OF_MEMORY", "PREEMPTED", "REVOKED",  "TIMEOUT"};
  return ended.contains(state);
}

std::string last_line_of(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

std::size_t largest_array() {
  const Captured config = capture({"scontrol", "show", "config"});
  const std::size_t at = config.text.find("MaxArraySize");
  if (config.exit_status != 0 || at == std::string::npos) return default_array;
  const std::size_t digits = config.text.find_first_of("0123456789", at);
  std::size_t size = 0;
  std::from_chars(config.text.data() + std::min(digits, config.text.size()), config.text.data() + config.text.size(),
                  size);
  return size > 1 ? size - 1 : default_array;
}

std::vector<std::string> resources(const SlurmResources& slurm) {
  std::vector<std::string> words = {"--cpus-per-task=" + std::to_string(slurm.cpus)};
  if (slurm.seconds > 0) words.push_back("--time=" + std::to_string(static_cast<long>(std::ceil(slurm.seconds / 60))));
  if (slurm.megabytes > 0)
    words.push_back("--mem=" + std::to_string(static_cast<long>(std::ceil(slurm.megabytes))) + "M");
  if (!slurm.partition.empty()) words.push_back("--partition=" + slurm.partition);
  if (!slurm.account.empty()) words.push_back("--account=" + slurm.account);
  words.insert(words.end(), slurm.extra.begin(), slurm.extra.end());
  return words;
}

}  // namespace

SlurmJob::SlurmJob(const Study& study, std::vector<std::string> command) : study_(study), command_(std::move(command)) {
  read();
}

// slurm.job: "job 123", then the names of its runs, in the order of its tasks.
void SlurmJob::read() {
  std::ifstream file(study_.dir + "/slurm.job", std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("job ")) {
      arrays_.push_back({line.substr(4), {}});
    } else if (!arrays_.empty()) {
      arrays_.back().runs.push_back(line);
    }
  }
}

void SlurmJob::write() const {
  std::string text;
  for (const Array& array : arrays_) {
    text += "job " + array.id + "\n";
    for (const std::string& run : array.runs) text += run + "\n";
  }
  write_whole(study_.dir + "/slurm.job", text);
}

void SlurmJob::submit(const std::vector<std::size_t>& runs) {
  arrays_.clear();
  const std::size_t most = largest_array();
  for (std::size_t from = 0; from < runs.size(); from += most) {
    std::vector<std::string> names;
    for (std::size_t i = from; i < std::min(runs.size(), from + most); ++i) names.push_back(study_.runs[runs[i]].name);
    submit_array(names);
    write();  // after each: what is submitted must not be forgotten
  }
}

void SlurmJob::submit_array(const std::vector<std::string>& names) {
  const std::string dir = fs::absolute(study_.dir).lexically_normal().string();
  fs::create_directories(dir + "/slurm");
  std::string script = "#!/bin/bash\n# The tasks of a job array, written by talus sweep --slurm.\nruns=(\n";
  for (const std::string& name : names) script += "  " + shell_quoted(name) + "\n";
  script += ")\nexec";
  for (const std::string& word : command_) script += " " + shell_quoted(word);
  script += " --only \"${runs[SLURM_ARRAY_TASK_ID - 1]}\"\n";
  const std::string file = dir + "/slurm.sh";
  write_whole(file, script);
  std::vector<std::string> words = {"sbatch",
                                    "--parsable",
                                    "--job-name=" + study_.title,
                                    "--array=1-" + std::to_string(names.size()) +
                                        (study_.slurm.at_once > 0 ? "%" + std::to_string(study_.slurm.at_once) : ""),
                                    "--output=" + dir + "/slurm/%A_%a.out",
                                    "--chdir=" + fs::current_path().string()};
  const std::vector<std::string> wanted = resources(study_.slurm);
  words.insert(words.end(), wanted.begin(), wanted.end());
  words.push_back(file);
  const Captured sbatch = capture(words);
  if (sbatch.exit_status == 127) throw RunError("--slurm: there is no sbatch on this machine");
  if (sbatch.exit_status != 0) throw RunError("--slurm: " + last_line_of(sbatch.text));
  std::string id = last_line_of(sbatch.text);
  arrays_.push_back({id.substr(0, id.find(';')), names});
}

std::string SlurmJob::ids() const {
  std::string list;
  for (const Array& array : arrays_) list += (list.empty() ? "" : ",") + array.id;
  return list;
}

std::string SlurmJob::name() const {
  std::string list;
  for (const Array& array : arrays_) list += (list.empty() ? "" : ", ") + array.id;
  return list;
}

bool SlurmJob::running() {
  states_.clear();
  if (arrays_.empty()) return false;
  const Captured squeue = capture({"squeue", "--noheader", "--array", "--jobs=" + ids(), "--format=%T"});
  if (squeue.exit_status == 127) throw RunError("--slurm: there is no squeue on this machine");
  // A job that is over is forgotten after a while; a controller that does not answer tells nothing.
  if (squeue.exit_status != 0) return squeue.text.find("Invalid job id") == std::string::npos;
  std::istringstream lines(squeue.text);
  bool any = false;
  for (std::string state; std::getline(lines, state);) {
    if (has_ended(state)) continue;
    any = true;
    std::ranges::transform(state, state.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    ++states_[state];
  }
  return any;
}

std::string SlurmJob::states() const {
  std::string text;
  for (const auto& [state, count] : states_) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + state;
  return text.empty() ? "no answer" : text;
}

double SlurmJob::pause() {
  const double now = pause_;
  pause_ = std::min(longest_pause, 1.3 * pause_);
  return now;
}

std::map<std::size_t, std::string> SlurmJob::ends(const std::vector<std::size_t>& runs) const {
  std::map<std::size_t, std::string> found;
  if (arrays_.empty() || runs.empty()) return found;
  std::map<std::string, std::size_t> numbers;
  for (const std::size_t run : runs) numbers[study_.runs[run].name] = run;
  const Captured squeue =
      capture({"squeue", "--noheader", "--array", "--states=all", "--jobs=" + ids(), "--format=%F %K %T"});
  std::istringstream lines(squeue.exit_status == 0 ? squeue.text : "");
  std::string id, state;
  for (std::size_t task = 0; lines >> id >> task >> state;)
    for (const Array& array : arrays_)
      if (array.id == id && task >= 1 && task <= array.runs.size())
        if (const auto run = numbers.find(array.runs[task - 1]); run != numbers.end()) found[run->second] = state;
  return found;
}

}  // namespace talus
