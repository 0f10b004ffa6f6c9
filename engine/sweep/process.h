#pragma once
// Runs as processes of their own: started, stopped, waited for.
#include <sys/types.h>

#include <csignal>
#include <string>
#include <vector>

namespace talus {

// A run's folder is worked on by one process at a time, whoever started it: the lock is the kernel's, and the run
// inherits it, so that it ends with the last of them. Held by a file `.lock` in the folder.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);  // makes the folder; RunError where that cannot be
  FolderLock(FolderLock&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();
  bool held() const { return file_ >= 0; }
  int file() const { return file_; }

 private:
  int file_ = -1;
};

struct Launch {
  std::vector<std::string> arguments;  // for this program, its name first
  std::string folder;                  // to work in
  std::string log;                     // for what it prints
  std::string library;                 // TALUS_LIB
  int lock = -1;                       // file that it inherits
  int threads = 1;
};
// In a process group of its own, so that Ctrl-C is ours to pass on; it is killed when this process dies. RunError.
pid_t launch(const Launch& launch);

struct Captured {
  int exit_status = 0;  // 128 + n for a signal
  std::string text;     // what it printed
};
Captured capture(const std::vector<std::string>& arguments);  // to its end; RunError where it cannot be started

std::string program_path();  // of this very program
std::string shell_quoted(const std::string& text);

// Signals come when they are asked for: no handler runs.
class HeldSignals {
 public:
  HeldSignals();
  ~HeldSignals();
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  int wait(double seconds) const;  // SIGINT, SIGTERM, SIGHUP or SIGCHLD; 0: none came
  static bool stop_asked();        // one of the first three was taken, here or by one before, or waits to be

 private:
  sigset_t set_, before_;
};

}  // namespace talus
