#pragma once
// The nearest known word to a mistyped one.
#include <string>
#include <vector>

namespace talus {

// Empty when none is near: more than a third of the letters (at least 2) would have to change. Letters swapped
// with their neighbour count as one change (optimal string alignment distance).
std::string nearest(const std::string& word, const std::vector<std::string>& known);

// "; did you mean "x"?" or, when none is near, "; known: a, b, c".
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

}  // namespace talus
