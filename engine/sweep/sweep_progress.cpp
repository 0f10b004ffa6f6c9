#include "sweep/sweep_progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "output/progress.h"
#include "step/clock.h"

namespace talus {

namespace {

constexpr double terminal_every = 0.2, plain_every = 15;  // s between lines
constexpr const char* clear_line = "\r\x1b[K";

}  // namespace

double seconds_left(const SweepCount& count, double mean, const std::vector<double>& at_work, int jobs) {
  if (count.ended == 0) return -1;
  double work = mean * static_cast<double>(count.left());
  for (const double seconds : at_work) work -= std::min(seconds, mean);
  return std::max(work, 0.0) / std::max(1, std::min(jobs, static_cast<int>(count.left())));
}

std::string sweep_line(const SweepCount& count, std::size_t at_work, double left) {
  std::string line = std::to_string(count.before + count.ended) + " of " + std::to_string(count.all) + " runs";
  if (at_work > 0) line += ", " + std::to_string(at_work) + " at work";
  if (count.failed > 0) line += ", " + std::to_string(count.failed) + " failed";
  if (left >= 0 && count.left() > 0) line += ", about " + duration(left) + " left";
  return line;
}

SweepProgress::SweepProgress() : terminal_(isatty(STDERR_FILENO) != 0), last_(terminal_ ? 0 : wall_seconds()) {}

void SweepProgress::show(const std::string& line) {
  const double now = wall_seconds();
  if (now - last_ < (terminal_ ? terminal_every : plain_every)) return;
  last_ = now;
  std::cerr << (terminal_ ? clear_line : "") << line << (terminal_ ? "" : "\n") << std::flush;
  shown_ = terminal_;
}

void SweepProgress::say(const std::string& line) {
  clear();
  std::cerr << line << std::endl;
}

void SweepProgress::clear() {
  if (shown_) std::cerr << clear_line << std::flush;
  shown_ = false;
}

}  // namespace talus
