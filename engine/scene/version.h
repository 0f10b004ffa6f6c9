#pragma once
// Which Talus this is. Generated at each build, from CMakeLists.txt and git; rewritten only when it changes.

namespace talus {

extern const char* const version;  // "0.1.0"
extern const char* const commit;   // "1a2b3c4d5e6f", with "+" when files differed from it; "unknown" outside git

}  // namespace talus
