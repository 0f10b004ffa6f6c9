#pragma once
// Files of a run's directory.
#include <string>

#include "output/output.h"

namespace talus {

// Makes the directory where it is missing; throws InputError (field "output.dir") when it cannot be written.
// Files of a former run there are removed: those with the names that RunOutput gives, no others.
void prepare_directory(const Output& output);

std::string frame_name(const std::string& stem, int number, const std::string& ending);  // "blocks_00012.vtp"

}  // namespace talus
