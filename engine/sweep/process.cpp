#include "sweep/process.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "scene/error.h"

namespace talus {

namespace {

constexpr int not_started = 127;
constexpr int stops[] = {SIGINT, SIGTERM, SIGHUP};
bool stop_taken = false;

[[noreturn]] void fail(const std::string& what) {
  throw RunError(what + ": " + std::strerror(errno));
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> list;
  for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
  list.push_back(nullptr);
  return list;
}

// Between fork and exec: system calls only.
void redirect(int from, int to) {
  if (from < 0 || dup2(from, to) < 0) _exit(not_started);
}

void unblock_all() {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : stops) std::signal(number, SIG_DFL);
}

// This process's environment with some variables set.
std::vector<std::string> environment(const std::vector<std::pair<std::string, std::string>>& set) {
  std::vector<std::string> list;
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry;
    const bool replaced =
        std::any_of(set.begin(), set.end(), [&](const auto& one) { return text.starts_with(one.first + "="); });
    if (!replaced) list.push_back(text);
  }
  for (const auto& [name, value] : set) list.push_back(name + "=" + value);
  return list;
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunError("cannot make the folder " + folder + ": " + error.message());
  file_ = open((folder + "/.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) fail("cannot write " + folder + "/.lock");
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  if (errno != EWOULDBLOCK) fail("cannot lock " + folder + "/.lock");
  close(file_);
  file_ = -1;
}

FolderLock::~FolderLock() {
  if (file_ >= 0) close(file_);
}

pid_t launch(const Launch& launch) {
  const std::string threads = std::to_string(launch.threads);
  const std::vector<std::string> variables = environment({{"OMP_NUM_THREADS", threads},
                                                          {"OMP_THREAD_LIMIT", threads},
                                                          {"OPENBLAS_NUM_THREADS", threads},
                                                          {"TALUS_LIB", launch.library}});
  const std::vector<char*> arguments = pointers(launch.arguments), names = pointers(variables);
  // This very program, also where another has been built in its place since.
  static const int program = open("/proc/self/exe", O_RDONLY | O_CLOEXEC);
  if (program < 0) fail("cannot open this program");
  const pid_t parent = getpid(), child = fork();
  if (child < 0) fail("cannot start a process");
  if (child > 0) {
    setpgid(child, child);  // here too: whichever comes first
    return child;
  }
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(not_started);  // died before it could be noticed
  unblock_all();
  redirect(open("/dev/null", O_RDONLY), STDIN_FILENO);
  redirect(open(launch.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDOUT_FILENO);
  redirect(STDOUT_FILENO, STDERR_FILENO);
  if (launch.lock >= 0) fcntl(launch.lock, F_SETFD, 0);
  if (chdir(launch.folder.c_str()) != 0) _exit(not_started);
  fexecve(program, arguments.data(), names.data());
  _exit(not_started);
}

Captured capture(const std::vector<std::string>& arguments) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail("cannot make a pipe");
  const std::vector<char*> words = pointers(arguments);
  const pid_t child = fork();
  if (child < 0) fail("cannot start a process");
  if (child == 0) {
    unblock_all();
    redirect(open("/dev/null", O_RDONLY), STDIN_FILENO);
    redirect(ends[1], STDOUT_FILENO);
    redirect(ends[1], STDERR_FILENO);
    execvp(words[0], words.data());
    _exit(not_started);
  }
  close(ends[1]);
  Captured captured;
  char buffer[4096];
  for (ssize_t count; (count = ::read(ends[0], buffer, sizeof buffer)) != 0;) {
    if (count > 0) captured.text.append(buffer, static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) break;
  }
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  captured.exit_status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return captured;
}

std::string program_path() {
  std::error_code error;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw RunError("cannot find this program: " + error.message());
  return path.string();
}

std::string shell_quoted(const std::string& text) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || std::strchr("_-./=+,:@%", c); };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

HeldSignals::HeldSignals() {
  sigemptyset(&set_);
  for (const int number : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&set_, number);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaddset(&set_, SIGHUP);  // nohup
  sigprocmask(SIG_BLOCK, &set_, &before_);
}

HeldSignals::~HeldSignals() {
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

int HeldSignals::wait(double seconds) const {
  timespec time{};
  time.tv_sec = static_cast<time_t>(seconds);
  time.tv_nsec = static_cast<long>(1e9 * (seconds - std::floor(seconds)));
  const int number = std::max(0, sigtimedwait(&set_, nullptr, &time));
  if (number != 0 && number != SIGCHLD) stop_taken = true;
  return number;
}

bool HeldSignals::stop_asked() {
  sigset_t waiting;
  sigemptyset(&waiting);
  sigpending(&waiting);
  return stop_taken || std::ranges::any_of(stops, [&](int number) { return sigismember(&waiting, number) == 1; });
}

}  // namespace talus
