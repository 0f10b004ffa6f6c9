#pragma once
// Where a scene may write: below the folder that the program runs in. --trust lets it write anywhere.
#include <string>

namespace talus {

// What a scene is told who names another place.
constexpr const char* allowed_place = "a place in or below the folder the program runs in (else -o or --trust)";

// Whether a name stays there, as it is written: links that lie there were put there by their owner.
bool stays_here(const std::string& name);

}  // namespace talus
