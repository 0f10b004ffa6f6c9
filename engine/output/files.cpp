#include "output/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "scene/error.h"

namespace talus {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view unfinished = ".part";  // ending of a file that is being written

bool is_frame(std::string_view name, std::string_view stem, std::string_view ending) {
  if (!name.starts_with(stem) || !name.ends_with(ending) || name.size() < stem.size() + ending.size() + 5) return false;
  const auto number = name.substr(stem.size(), name.size() - stem.size() - ending.size());
  return std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_own(std::string_view name) {
  if (name.ends_with(unfinished)) name.remove_suffix(unfinished.size());
  for (const std::string_view own : {"blocks.pvd", "joints.pvd", "cracks.pvd", "history.csv", "history_before.csv",
                                     "energy.svg", "gas_pressure.svg", "gas_volume.svg", "load_displacement.svg",
                                     "run.json", "report.html", "view.html", "paraview.py", "checkpoint.state"})
    if (name == own) return true;
  return is_frame(name, "blocks_", ".vtp") || is_frame(name, "joints_", ".vtp") || is_frame(name, "cracks_", ".vtp") ||
         is_frame(name, "picture_", ".svg");
}

void remove_former(const fs::path& dir) {
  for (const fs::directory_entry& entry : fs::directory_iterator(dir))
    if (entry.is_regular_file() && is_own(entry.path().filename().string())) fs::remove(entry.path());
}

}  // namespace

void prepare_directory(const Output& output, bool resumed) {
  const auto refuse = [&](const std::string& reason) {
    throw InputError(output.place, "output.dir", "a directory that can be written",
                     "\"" + output.dir + "\" (" + reason + ")");
  };
  std::error_code error;
  fs::create_directories(output.dir, error);
  if (error) refuse(error.message());
  if (!fs::is_directory(output.dir)) refuse("it is a file");
  if (access(output.dir.c_str(), W_OK | X_OK) != 0) refuse(std::strerror(errno));
  if (resumed) return;
  try {
    remove_former(output.dir);
  } catch (const fs::filesystem_error& trouble) {
    refuse(trouble.code().message());
  }
}

void make_directory(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!fs::is_directory(path, error)) throw RunError("cannot make the folder " + path + ": " + error.message());
}

std::string frame_name(const std::string& stem, int number, const std::string& ending) {
  const std::string digits = std::to_string(number);
  return stem + "_" + std::string(5 - std::min<std::size_t>(5, digits.size()), '0') + digits + ending;
}

int frame_number(const std::string& name) {
  const std::size_t begin = name.find_last_of('_') + 1, end = name.find_last_of('.');
  int number = -1;
  const auto [stop, error] = std::from_chars(name.data() + begin, name.data() + std::min(end, name.size()), number);
  return error == std::errc() && stop == name.data() + end ? number : -1;
}

namespace {

// Closes and syncs what `path` names: a rename before the bytes are on disk could leave an empty file.
bool sync(const std::string& path, int flags) {
  const int file = open(path.c_str(), flags);
  if (file < 0) return false;
  const bool good = fsync(file) == 0;
  return close(file) == 0 && good;
}

void write_and_rename(const std::string& path, const std::string& content, bool durable) {
  const std::string part = path + std::string(unfinished);
  errno = 0;
  std::ofstream file(part, std::ios::binary | std::ios::trunc);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (file.fail() || (durable && !sync(part, O_RDONLY)) || std::rename(part.c_str(), path.c_str()) != 0) {
    const std::string reason = errno != 0 ? std::strerror(errno) : "unknown reason";
    std::remove(part.c_str());
    throw RunError("cannot write " + path + ": " + reason);
  }
  if (!durable) return;
  const fs::path folder = fs::path(path).parent_path();
  sync(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);  // the new name; not every file system can
}

}  // namespace

void write_whole(const std::string& path, const std::string& content) {
  write_and_rename(path, content, false);
}

void write_durably(const std::string& path, const std::string& content) {
  write_and_rename(path, content, true);
}

}  // namespace talus
