#pragma once
// The runs of a study, so many at once, each a process in a folder of its own.
#include <sys/resource.h>
#include <sys/types.h>

#include <deque>
#include <functional>
#include <list>
#include <vector>

#include "scene/study.h"
#include "sweep/key.h"
#include "sweep/process.h"

namespace talus {

struct PoolOptions {
  int jobs = 1;
  int threads = 1;     // of a run
  bool retry = false;  // runs that failed are not taken as finished
};

// Whether a run that ended so need not be made again.
bool reusable(const Study& study, Keys& keys, std::size_t run, const Outcome& outcome, bool retry);

class Pool {
 public:
  Pool(const Study& study, Keys& keys, const PoolOptions& options)
      : study_(study), keys_(keys), options_(options), program_(program_path()) {}

  // Called for each run that has ended, here or in another sweep that has the same folder.
  std::function<void(std::size_t run, const Outcome& outcome)> on_end;
  std::function<void()> on_tick;  // now and then

  // To the end of the queue. A signal stops what runs and leaves the rest: its number, else 0.
  int work(std::deque<std::size_t> queue);
  std::vector<double> started() const;  // wall clock, of what runs now

 private:
  struct Job {
    std::size_t run = 0;
    pid_t process = 0;
    double started = 0;
    FolderLock lock;
    bool over_time = false;
    double killed_at = 0;  // s; 0: nobody has asked it to stop
  };
  bool start(std::size_t run);  // false: another process works on it
  void reap(bool stopping);
  void finish(const Job& job, int status, const rusage& usage);
  void stop_overdue();
  void stop_all(int number);

  const Study& study_;
  Keys& keys_;
  PoolOptions options_;
  std::string program_;
  std::list<Job> jobs_;
};

}  // namespace talus
