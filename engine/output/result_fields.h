#pragma once
// What the blocks or lines of a frame that was read back can be coloured by.
#include "output/picture_field.h"
#include "output/results_folder.h"

namespace talus {

struct ResultField {
  PictureField picture;
  std::string lines;  // "joints" or "cracks" where the field is of one of them
};

// Throws InputError with the nearest name.
ResultField result_field(const ResultsFolder& run, std::size_t frame, const ResultFrame& blocks,
                         const std::string& name);

// Scalars made of the components of arrays of vectors: "ux", "speed", …
std::optional<std::vector<double>> values_of(const ResultFrame& frame, const std::string& name);

// The array that a field is made of: "velocity" for "speed"; else itself.
std::string array_of(const std::string& field);

}  // namespace talus
