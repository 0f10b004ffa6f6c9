#pragma once
// Whether a file is the one that it was.
#include <cstdint>
#include <string>

namespace talus {

std::uint64_t hash_of_file(const std::string& path);  // of its bytes; 0 where it cannot be read

}  // namespace talus
