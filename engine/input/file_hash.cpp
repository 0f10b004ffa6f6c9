#include "input/file_hash.h"

#include <array>
#include <fstream>
#include <string_view>

#include "model/saved_state.h"

namespace talus {

std::uint64_t hash_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return 0;
  Fnv hash;
  std::array<char, 1 << 16> buffer;
  do {
    file.read(buffer.data(), buffer.size());
    hash.add(std::string_view(buffer.data(), static_cast<std::size_t>(file.gcount())));
  } while (file);
  return file.bad() ? 0 : hash.value();
}

}  // namespace talus
