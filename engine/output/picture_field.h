#pragma once
// The numbers a picture is coloured by: a scalar block field, the length of a vector field, a field of
// joints, or a user array.
#include <string>
#include <vector>

#include "model/fields.h"

namespace talus {

struct PictureField {
  std::string symbol, unit, meaning;
  bool whole = false, subscripts = false;
  bool categories = false;       // names rather than amounts: fragments, regions
  bool of_lines = false;         // of joints or cracks, not of blocks
  double noise = 0;              // what rounding alone can make of zero
  std::vector<double> values;    // per block
  std::vector<char> grey;        // per block: held, so its value says nothing
  std::vector<double> coloured;  // values of the blocks that are not grey
};

PictureField picture_field(const FieldContext& context, const std::string& name);  // throws as below

// Throws InputError with the nearest name when no picture can be coloured by `name`.
void check_picture_field(const Scene& scene, const std::string& name);

}  // namespace talus
