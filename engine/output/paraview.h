#pragma once
// <dir>/paraview.py: how ParaView shows the run, as a Python state (File > Load State).
#include <string>

#include "scene/scene.h"

namespace talus {

std::string paraview_state(const Output& output);

}  // namespace talus
