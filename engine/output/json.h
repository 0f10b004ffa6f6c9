#pragma once
// Writes JSON (RFC 8259), indented, in the order of the calls.
#include <string>
#include <string_view>
#include <vector>

namespace talus {

class Json {
 public:
  Json& object(std::string_view key = "") { return open(key, '{'); }  // the key only inside an object
  Json& array(std::string_view key = "") { return open(key, '['); }
  Json& end();  // of the innermost object or array

  Json& number(std::string_view key, double value);  // null where it is not finite
  Json& whole(std::string_view key, long value);
  Json& text(std::string_view key, std::string_view value);
  Json& truth(std::string_view key, bool value);
  Json& text(std::string_view value) { return text("", value); }  // inside an array

  std::string file() const { return out_ + "\n"; }

 private:
  Json& open(std::string_view key, char bracket);
  void begin_item(std::string_view key);
  void new_line() { out_ += "\n" + std::string(2 * nested_.size(), ' '); }
  struct Level {
    char close;
    bool empty = true;
  };
  std::vector<Level> nested_;
  std::string out_;
};

}  // namespace talus
