#pragma once
// Softening in blocks too large for it: they give back more energy, as the bond between them unloads them, than
// its crack takes, so that load and opening would both have to go back. A step cannot follow that; it becomes a
// jump.
#include <string>

#include "model/model.h"

namespace talus {

// Throws InputError where every bond of a joint is between blocks that snap back; a note, or nothing, where some
// are.
std::string check_snap_back(const Model& model);

}  // namespace talus
