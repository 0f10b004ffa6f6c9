#pragma once
// Scene -> Model: checks geometry, cuts and meshes regions, finds joints, attaches loads, fixities and probes.
#include "model/model.h"
#include "scene/scene.h"

namespace talus {

// Throws InputError naming the script line for: outlines that are no simple polygons, holes outside their
// region, overlapping regions, too many blocks, loads, fixities or probes that touch no block.
Model build(Scene scene);

}  // namespace talus
