#pragma once
// Files of a run's directory.
#include <string>

#include "output/output.h"

namespace talus {

// Makes the directory where it is missing; throws InputError (field "output.dir") when it cannot be written.
// Unless `resumed`, files of a former run there are removed: those with the names that RunOutput gives, no others.
void prepare_directory(const Output& output, bool resumed);

void make_directory(const std::string& path);  // where it is missing; throws RunError when it cannot be

// As write_whole, and on disk when it returns.
void write_durably(const std::string& path, const std::string& content);

std::string frame_name(const std::string& stem, int number, const std::string& ending);  // "blocks_00012.vtp"
int frame_number(const std::string& name);  // 12 again; -1 for a name that frame_name does not give

}  // namespace talus
