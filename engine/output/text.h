#pragma once
// Numbers and strings as files want them; nothing here depends on the locale.
#include <string>
#include <string_view>

namespace talus {

std::string shortest(double value);                 // fewest digits that read back as the same number
std::string fixed(double value, int decimals);      // "-0.25"; never "-0.00"
std::string significant(double value, int digits);  // "1.23e-04" or "12.3", whichever is shorter to read
std::string escape_json(std::string_view text);     // without the quotes around it
std::string escape_xml(std::string_view text);      // for text and for attributes
std::string csv_cell(const std::string& text);      // RFC 4180

}  // namespace talus
