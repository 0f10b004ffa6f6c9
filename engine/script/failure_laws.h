#pragma once
// Failure criteria and reduction laws of a joint: those of the script behind C++ interfaces, and the ready-made ones.
#include "scene/scene.h"
#include "script/table_reader.h"

namespace talus {

// Reads `criterion`, `reduction` and `law` of a flat joint.
void read_failure_laws(const TableReader& t, JointProperty& property);

}  // namespace talus
