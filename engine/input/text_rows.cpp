#include "input/text_rows.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "input/drawing.h"

namespace talus {

std::optional<std::string_view> TextRows::next() {
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = rest_.find_first_of("\r\n");
  const std::string_view row = rest_.substr(0, end);
  if (end == std::string_view::npos)
    rest_ = {};
  else
    rest_.remove_prefix(end + (rest_.substr(end, 2) == "\r\n" ? 2 : 1));
  ++line_;
  return trimmed(row);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string quoted(std::string_view text) {
  std::string shown = "\"";
  for (char c : text.substr(0, 40)) shown += static_cast<unsigned char>(c) < ' ' ? '?' : c;
  return shown + (text.size() > 40 ? "…\"" : "\"");
}

std::string read_text(const std::string& path, const std::string& shown) {
  std::error_code problem;
  if (!std::filesystem::exists(path, problem))
    throw FileError(shown, 0, "a file beside the scene", "none of this name");
  if (!std::filesystem::is_regular_file(path, problem)) throw FileError(shown, 0, "a file", "something else");
  constexpr std::uintmax_t most_bytes = 256 << 20;
  if (std::filesystem::file_size(path, problem) > most_bytes) throw FileError(shown, 0, "at most 256 MB", "more");
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  if (!file) throw FileError(shown, 0, "a file that can be read", "none or an empty one");
  return std::move(text).str();
}

}  // namespace talus
