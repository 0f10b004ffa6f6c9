#pragma once
// sim.blocks, sim.joints, sim.contacts and sim.probes: what the field registries know, item by item or as
// whole fields. Ids are 1-based in Lua.
#include <lua.hpp>
#include <memory>
#include <string>
#include <vector>

#include "script/run.h"

namespace talus {

enum class ViewKind { blocks, joints, contacts, probes };

void open_table_views(lua_State* L);
void push_table_view(lua_State* L, const std::shared_ptr<Run>& run, ViewKind kind);
void push_item(lua_State* L, const std::shared_ptr<Run>& run, ViewKind kind, int id);

// What a view offers, for the reference page.
struct ViewField {
  std::string name, unit, meaning;
};
std::vector<ViewField> view_fields(ViewKind kind);

}  // namespace talus
