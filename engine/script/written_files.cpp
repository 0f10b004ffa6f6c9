#include "script/written_files.h"

#include <filesystem>

namespace talus {

bool stays_here(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
  return !path.is_absolute() && !name.empty() && *path.begin() != "..";
}

}  // namespace talus
