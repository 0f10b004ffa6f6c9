// talus new: a commented scene to start from (lib/talus/templates).
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/command.h"
#include "script/lua_state.h"

namespace talus {
namespace {

constexpr const char* kinds[] = {"slope", "blast", "disc", "wall"};

bool is_kind(const std::string& word) {
  for (const char* kind : kinds)
    if (word == kind) return true;
  return false;
}

std::string read_template(const std::string& kind) {
  const std::string path = library_folder() + "/talus/templates/" + kind + ".lua";
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!(text << file.rdbuf())) throw std::runtime_error("new: cannot read " + path);
  return text.str();
}

// Its own name in run lines and in its folder of results.
std::string renamed(std::string text, const std::string& kind, const std::string& stem, const std::string& file) {
  for (const auto& [from, to] : {std::pair{" " + kind + ".lua", " " + file}, {"out/" + kind, "out/" + stem}})
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  return text;
}

}  // namespace

int new_command(const Arguments& arguments) {
  std::string kind, name;
  for (const std::string& argument : arguments) {
    if (argument.starts_with("-") || (!kind.empty() && !name.empty()))
      throw UsageError{"new: unexpected argument \"" + argument + '"'};
    // The last word that names a kind is one: "talus new wall slope" is a slope called wall.
    if (is_kind(argument) && &argument == &arguments.back())
      kind = argument;
    else if (name.empty())
      name = argument;
    else
      throw UsageError{"new: expected slope, blast, disc or wall, got \"" + argument + '"'};
  }
  if (kind.empty() && name.empty())
    throw UsageError{"new: expected a name for the scene, and what it is to be: slope, blast, disc or wall"};
  if (kind.empty()) kind = "slope";
  if (name.empty()) name = kind;
  if (!name.ends_with(".lua")) name += ".lua";
  const std::string stem = std::filesystem::path(name).stem().string();
  const std::string text = renamed(read_template(kind), kind, stem, name);
  std::error_code unmade;  // then the file cannot be made either, and that says why
  if (const auto folder = std::filesystem::path(name).parent_path(); !folder.empty())
    std::filesystem::create_directories(folder, unmade);
  std::FILE* file = std::fopen(name.c_str(), "wbx");  // never over something that is there
  if (!file) throw std::runtime_error("new: cannot make " + name + ": " + std::strerror(errno));
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (std::fclose(file) != 0 || !written) {
    const std::string reason = std::strerror(errno);
    std::remove(name.c_str());
    throw std::runtime_error("new: cannot write " + name + ": " + reason);
  }
  const char* program = program_invocation_name;
  std::printf(
      "%s: a %s to start from\n  %s check %s    what it would take\n  %s %s          runs it; results in out/%s\n",
      name.c_str(), kind.c_str(), program, name.c_str(), program, name.c_str(), stem.c_str());
  return exit_ok;
}

}  // namespace talus
