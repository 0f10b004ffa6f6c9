#pragma once
// What a run may take: --limit. What it reaches stops it as a signal does: the step ends or is undone, results are
// kept.
#include <cstddef>
#include <string>

namespace talus {

struct Limits {
  double seconds = 0;                              // of the clock; 0: no limit, as with the others
  std::size_t memory = 0;                          // bytes of data of the process
  long steps = 0;                                  // of all simulations of the script together
  std::string time_text, memory_text, steps_text;  // as they were given: "--limit time=60s"
};

// Bounds what the process may ask for, for good. Throws std::runtime_error where that cannot be.
void bound_memory(std::size_t bytes, const std::string& reason);

// What to say where memory was asked for and not given.
std::string out_of_memory();

}  // namespace talus
