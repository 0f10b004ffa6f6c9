#include "script/limits.h"

#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace talus {
namespace {

std::string memory_reason;

std::size_t data_of_process() {  // bytes
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmData:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

}  // namespace

void bound_memory(std::size_t bytes, const std::string& reason) {
  // What the libraries take of themselves comes a moment after the start: the solver's buffers, for each core.
  constexpr std::size_t margin = 20'000'000, own = 200'000'000;
  const std::size_t least = std::max(data_of_process() + margin, own);
  if (bytes < least)
    throw std::runtime_error(reason + ": expected at least " + std::to_string((least + 999'999) / 1'000'000) +
                             "MB, as the program itself takes most of that");
  const rlimit limit = {.rlim_cur = bytes, .rlim_max = bytes};
  if (setrlimit(RLIMIT_DATA, &limit) != 0) throw std::runtime_error(reason + ": " + std::strerror(errno));
  memory_reason = reason;
}

std::string out_of_memory() {
  return memory_reason.empty() ? "out of memory" : "stopped by " + memory_reason;
}

}  // namespace talus
