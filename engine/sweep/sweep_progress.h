#pragma once
// What a sweep says while it works: one line that is rewritten on a terminal, a line now and then otherwise;
// failures at once.
#include <string>
#include <vector>

namespace talus {

struct SweepCount {
  std::size_t all = 0, before = 0;    // runs; those that were finished already
  std::size_t ended = 0, failed = 0;  // of this sweep
  std::size_t left() const { return all - before - ended; }
};

// Seconds until the end, from the mean time of the runs that have ended and how long those at work are at it
// already. Negative: nothing has ended yet.
double seconds_left(const SweepCount& count, double mean, const std::vector<double>& at_work, int jobs);

// "12 of 40 runs, 2 at work, 1 failed, about 3 min left"
std::string sweep_line(const SweepCount& count, std::size_t at_work, double left);

class SweepProgress {
 public:
  SweepProgress();
  void show(const std::string& line);  // when it is due
  void say(const std::string& line);   // at once, to stay
  void clear();

 private:
  bool terminal_;
  double last_;
  bool shown_ = false;
};

}  // namespace talus
