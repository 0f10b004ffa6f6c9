#pragma once
// The flat scene table, put together and checked by lib/talus/assemble.lua, -> Scene.
#include <string>

#include "scene/scene.h"
#include "script/table_reader.h"

namespace talus {

Scene read_scene(const TableReader& scene);

// Reads one changed entry of a list of the scene again: `list` is "materials", "properties", "fixities",
// "point_loads" or "edge_loads".
// A changed load or support comes from what it was at `time` to what it is at `until` (s), if that is later; else at
// once.
void update_scene(Scene& scene, const std::string& list, int index, const TableReader& entry, double time,
                  double until);

}  // namespace talus
