#include "sweep/outcome.h"

#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

#include "model/saved_state.h"
#include "output/output.h"
#include "output/text.h"

namespace talus {

namespace {

constexpr std::string_view first_line = "talus run 1", last_line = "end";

std::string file_of(const std::string& folder) {
  return folder + "/run.done";
}

template <class Number>
Number read(const std::string& text, int base = 10) {
  Number value = 0;
  if constexpr (std::is_floating_point_v<Number>)
    std::from_chars(text.data(), text.data() + text.size(), value);
  else
    std::from_chars(text.data(), text.data() + text.size(), value, base);
  return value;
}

}  // namespace

std::string Outcome::status() const {
  if (time_limit > 0) return "time limit";
  if (signal != 0 || exit_status > 128) return "killed";
  if (!final()) return "failed";
  constexpr const char* words[] = {"done", "check failed", "bad input", "stopped"};
  return words[exit_status];
}

std::optional<Outcome> read_outcome(const std::string& folder) {
  std::ifstream file(file_of(folder), std::ios::binary);
  std::string line;
  if (!std::getline(file, line) || line != first_line) return {};
  Outcome outcome;
  while (std::getline(file, line)) {
    if (line == last_line) return outcome;
    const std::size_t space = line.find(' ');
    const std::string word = line.substr(0, space), value = space == std::string::npos ? "" : line.substr(space + 1);
    if (word == "key") outcome.key = read<std::uint64_t>(value, 16);
    if (word == "exit") outcome.exit_status = read<int>(value);
    if (word == "signal") outcome.signal = read<int>(value);
    if (word == "time_limit") outcome.time_limit = read<double>(value);
    if (word == "wall") outcome.wall = read<double>(value);
    if (word == "cpu") outcome.cpu = read<double>(value);
    if (word == "message") outcome.message = value;
    if (word == "input" && value.size() > 17)
      outcome.inputs.push_back({value.substr(17), read<std::uint64_t>(value.substr(0, 16), 16)});
  }
  return {};
}

void write_outcome(const std::string& folder, const Outcome& outcome) {
  std::string text = std::string(first_line) + "\nkey " + hex(outcome.key) + "\nexit " +
                     std::to_string(outcome.exit_status) + "\nsignal " + std::to_string(outcome.signal) +
                     "\ntime_limit " + shortest(outcome.time_limit) + "\nwall " + fixed(outcome.wall, 3) + "\ncpu " +
                     fixed(outcome.cpu, 3) + "\n";
  for (const InputFile& input : outcome.inputs) text += "input " + hex(input.hash) + " " + input.path + "\n";
  text += "message " + outcome.message + "\n" + std::string(last_line) + "\n";
  write_whole(file_of(folder), text);
}

void remove_outcome(const std::string& folder) {
  std::error_code ignored;
  std::filesystem::remove(file_of(folder), ignored);
}

std::string message_of_log(const std::string& log, int exit_status, int signal) {
  if (signal != 0) return "ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  if (exit_status == 0) return "";
  if (exit_status == 127) return "could not be started";
  std::ifstream file(log, std::ios::binary);
  std::string line, message, checks;
  while (std::getline(file, line)) {
    if (line.starts_with("talus: ")) message = line.substr(7);
    if (!line.starts_with("FAIL  ")) continue;
    const std::size_t end = line.find("  ", 6);
    checks += (checks.empty() ? "" : ", ") + line.substr(6, end == std::string::npos ? end : end - 6);
  }
  if (exit_status == 1 && !checks.empty()) return checks;
  return message.empty() ? "exit status " + std::to_string(exit_status) : message;
}

}  // namespace talus
