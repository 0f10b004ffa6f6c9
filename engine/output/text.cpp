#include "output/text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace talus {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

// Bytes of the UTF-8 character that `text` begins with; 0 when it is none (overlong forms, surrogates too).
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if (length < 3) return length;
  const unsigned char second = byte(1);
  const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                     (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return wrong ? 0 : length;
}

// Copies `text`, with `escaped(c)` in place of an ASCII character wherever that is not null, and invalid bytes
// replaced: file names and command lines may hold anything.
template <class Escaped>
std::string escape(std::string_view text, Escaped escaped) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    std::string ascii;
    if (length == 0) {
      out += replacement;
    } else if (length == 1 && !(ascii = escaped(text[0])).empty()) {
      out += ascii;
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

std::string json_escape_of(char c) {
  switch (c) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    default:
      break;
  }
  constexpr std::string_view hex = "0123456789abcdef";
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20 ? std::string("\\u00") + hex[code >> 4] + hex[code & 15] : "";
}

std::string xml_escape_of(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\n':
    case '\t':
      return " ";
    default:
      return static_cast<unsigned char>(c) < 0x20 ? std::string(replacement) : "";
  }
}

template <class... Format>
std::string printed(double value, Format... format) {
  std::array<char, 400> buffer;  // 1e308 in fixed form has 309 digits
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...).ptr;
  return {buffer.data(), end};
}

}  // namespace

std::string shortest(double value) {
  return printed(value);
}

std::string fixed(double value, int decimals) {
  const std::string text = printed(value, std::chars_format::fixed, decimals);
  return text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1) : text;
}

std::string significant(double value, int digits) {
  if (value == 0) return "0";
  return printed(value, std::chars_format::general, digits);
}

std::string escape_json(std::string_view text) {
  return escape(text, json_escape_of);
}
std::string escape_xml(std::string_view text) {
  return escape(text, xml_escape_of);
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace talus
