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

// The number of an item of this kind and run, from 1; 0 where the value is another.
int item_id(lua_State* L, int index, const Run& run, ViewKind kind);
// As messages show it: "block 7", "joint 3 of another simulation", else as any value.
std::string describe_item(lua_State* L, int index, const Run& run);

// What a view offers, for the reference page.
struct ViewField {
  std::string name, unit, meaning;
};
std::vector<ViewField> view_fields(ViewKind kind);

}  // namespace talus
