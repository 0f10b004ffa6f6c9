#include "output/json.h"

#include <cmath>

#include "output/text.h"

namespace talus {

void Json::begin_item(std::string_view key) {
  if (nested_.empty()) return;
  if (!nested_.back().empty) out_ += ',';
  nested_.back().empty = false;
  new_line();
  if (nested_.back().close == '}') out_ += '"' + escape_json(key) + "\": ";
}

Json& Json::open(std::string_view key, char bracket) {
  begin_item(key);
  out_ += bracket;
  nested_.push_back({bracket == '{' ? '}' : ']'});
  return *this;
}

Json& Json::end() {
  const Level level = nested_.back();
  nested_.pop_back();
  if (!level.empty) new_line();
  out_ += level.close;
  return *this;
}

Json& Json::number(std::string_view key, double value) {
  begin_item(key);
  out_ += std::isfinite(value) ? shortest(value) : "null";
  return *this;
}

Json& Json::whole(std::string_view key, long value) {
  begin_item(key);
  out_ += std::to_string(value);
  return *this;
}

Json& Json::text(std::string_view key, std::string_view value) {
  begin_item(key);
  out_ += '"' + escape_json(value) + '"';
  return *this;
}

Json& Json::truth(std::string_view key, bool value) {
  begin_item(key);
  out_ += value ? "true" : "false";
  return *this;
}

}  // namespace talus
