#include "sweep/key.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "input/file_hash.h"
#include "model/saved_state.h"
#include "scene/version.h"

namespace talus {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view in_library = "<library>/";

std::string absolute(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}

// A commit with changes on top of it is no name of a program: then its own bytes are.
std::string engine_identity() {
  const std::string name = std::string(version) + " " + commit;
  if (!name.ends_with("+") && !name.ends_with("unknown")) return name;
  return name + " " + hex(hash_of_file("/proc/self/exe"));
}

}  // namespace

Keys::Keys(const Study& study)
    : study_(study),
      scene_folder_(fs::path(absolute(study.scene)).parent_path().string()),
      library_(absolute(study.library) + "/"),
      common_(engine_identity() + "\n" + fs::path(study.scene).filename().string() + "\n") {}

std::uint64_t Keys::of(std::size_t run) const {
  std::vector<std::string> settings;
  for (const Setting& setting : study_.runs[run].settings) settings.push_back(setting.name + "=" + setting.text);
  std::sort(settings.begin(), settings.end());
  Fnv hash;
  hash.add(common_);
  for (const std::string& setting : settings) hash.add(setting + "\n");
  return hash.value();
}

bool Keys::same(std::size_t run, const Outcome& outcome) {
  if (outcome.key != of(run) || outcome.inputs.empty()) return false;
  return std::all_of(outcome.inputs.begin(), outcome.inputs.end(), [&](const InputFile& input) {
    const std::string path = input.path.starts_with(in_library) ? library_ + input.path.substr(in_library.size())
                                                                : (fs::path(scene_folder_) / input.path).string();
    const auto [known, is_new] = hashes_.try_emplace(path, 0);
    if (is_new) known->second = hash_of_file(path);
    return known->second == input.hash;
  });
}

std::vector<InputFile> Keys::read_inputs(const std::string& list) const {
  std::ifstream file(list, std::ios::binary);
  std::vector<InputFile> inputs;
  std::string line;
  while (std::getline(file, line)) {
    if (line.size() < 18) continue;
    InputFile input{line.substr(17)};
    std::from_chars(line.data(), line.data() + 16, input.hash, 16);
    const std::string path = absolute(input.path);
    input.path = path.starts_with(library_) ? std::string(in_library) + path.substr(library_.size())
                                            : fs::path(path).lexically_relative(scene_folder_).string();
    inputs.push_back(input);
  }
  return inputs;
}

}  // namespace talus
