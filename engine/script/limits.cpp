#include "script/limits.h"

#include <sys/resource.h>

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
  const std::size_t now = data_of_process(), margin = std::size_t(32) << 20;
  if (bytes < now + margin)
    throw std::runtime_error(reason + ": expected at least " + std::to_string((now + margin) / 1000000 + 1) +
                             "MB, which the program needs itself");
  const rlimit limit = {.rlim_cur = bytes, .rlim_max = bytes};
  if (setrlimit(RLIMIT_DATA, &limit) != 0) throw std::runtime_error(reason + ": " + std::strerror(errno));
  memory_reason = reason;
}

std::string out_of_memory() {
  return memory_reason.empty() ? "out of memory" : "stopped by " + memory_reason;
}

}  // namespace talus
