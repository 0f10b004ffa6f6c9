#pragma once
// Colours of numbers, in steps of even lightness, so that equal differences look equal.
#include <string>

namespace talus {

// Dark blue–green–yellow; blue–white–red, white at 0.5; round the hues.
enum class ColourMap { sequential, diverging, categories };

std::string colour(ColourMap map, double t);  // "#rrggbb" for t in [0, 1]
// Too dark for a black line on it; for black letters with luma = 130.
bool dark(const std::string& colour, double luma = 70);

}  // namespace talus
