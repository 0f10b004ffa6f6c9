#pragma once
// A text line by line, whatever ends its lines, and the numbers in it. Internal to engine/input.
#include <optional>
#include <string>
#include <string_view>

namespace talus {

class TextRows {
 public:
  explicit TextRows(std::string_view text) : rest_(text) {}
  // The next line without its end and without spaces around it; nothing after the last.
  std::optional<std::string_view> next();
  int line() const { return line_; }  // of the latest, from 1

 private:
  std::string_view rest_;
  int line_ = 0;
};

std::string_view trimmed(std::string_view text);
// A finite number with a decimal point that fills the text, whatever the locale.
std::optional<double> finite_number(std::string_view text);
// As messages show it: in quotes, cut where it is long, without control characters.
std::string quoted(std::string_view text);

constexpr std::size_t most_points = 1000000;  // of a drawing: more is no trace map, and cutting by it would not end

}  // namespace talus
