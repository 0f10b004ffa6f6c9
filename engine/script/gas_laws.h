#pragma once
// Charges with their laws, of the script or ready-made.
#include "scene/scene.h"
#include "script/table_reader.h"

namespace talus {

Charge read_charge(const TableReader& t);

}  // namespace talus
