#include "script/table_view.h"

#include <cmath>
#include <new>

#include "script/item_fields.h"
#include "script/lua_error.h"
#include "script/nearest.h"

namespace talus {
namespace {

constexpr const char* view_metatable = "talus.view";
constexpr const char* item_metatable = "talus.item";

struct TableView {
  std::shared_ptr<Run> run;
  ViewKind kind;
  int count() const { return item_count(run->simulation.model, kind); }
};

struct ItemView {
  std::shared_ptr<Run> run;
  ViewKind kind;
  int id;
};

template <class T>
void push_userdata(lua_State* L, T value, const char* metatable) {
  void* memory = lua_newuserdatauv(L, sizeof(T), 0);
  new (memory) T(std::move(value));
  luaL_setmetatable(L, metatable);
}

template <class T>
int collect(lua_State* L) {
  static_cast<T*>(lua_touserdata(L, 1))->~T();
  return 0;
}

TableView& check_view(lua_State* L) {
  return *static_cast<TableView*>(luaL_checkudata(L, 1, view_metatable));
}

ItemView& check_item(lua_State* L) {
  ItemView& item = *static_cast<ItemView*>(luaL_checkudata(L, 1, item_metatable));
  if (item.id >= item_count(item.run->simulation.model, item.kind)) {
    refuse(L, std::string(item_word(item.kind)) + " " + std::to_string(item.id + 1) + " is no more");
  }
  return item;
}

std::string check_name(lua_State* L, int index, const char* what) {
  if (lua_type(L, index) != LUA_TSTRING) {
    refuse(L, std::string(what) + ": expected a field's name, got " + describe(L, index));
  }
  return lua_tostring(L, index);
}

// view:field("sxx") -> {value of item 1, value of item 2, …}
int view_field(lua_State* L) {
  TableView& view = check_view(L);
  const ItemField field(L, view.kind, check_name(L, 2, "field"));
  const int count = view.count();
  lua_createtable(L, count, 0);
  for (int id = 0; id < count; ++id) {
    field.push(L, *view.run, id);
    lua_rawseti(L, -2, id + 1);
  }
  return 1;
}

// view:select(function(item) … end) -> list of the items for which it returned true
int view_select(lua_State* L) {
  const TableView view = check_view(L);
  if (!lua_isfunction(L, 2)) refuse(L, "select: expected a function, got " + describe(L, 2));
  lua_newtable(L);
  lua_Integer found = 0;
  for (int id = 0; id < view.count(); ++id) {
    push_item(L, view.run, view.kind, id);
    lua_pushvalue(L, 2);
    lua_pushvalue(L, -2);
    lua_call(L, 1, 1);
    const bool wanted = lua_toboolean(L, -1);
    lua_pop(L, 1);
    if (wanted) {
      lua_rawseti(L, 3, ++found);
    } else {
      lua_pop(L, 1);
    }
  }
  return 1;
}

// view:where{ region = "beam", state = "slip" } -> list of the items whose fields equal the given values
int view_where(lua_State* L) {
  TableView& view = check_view(L);
  if (!lua_istable(L, 2)) refuse(L, "where: expected a table of fields and values, got " + describe(L, 2));
  std::vector<std::pair<std::string, ItemField>> wanted;
  for (lua_pushnil(L); lua_next(L, 2); lua_pop(L, 1)) {
    const std::string name = check_name(L, -2, "where");
    wanted.emplace_back(name, ItemField(L, view.kind, name));
  }
  lua_newtable(L);
  lua_Integer found = 0;
  for (int id = 0; id < view.count(); ++id) {
    bool all = true;
    for (std::size_t k = 0; all && k < wanted.size(); ++k) {
      wanted[k].second.push(L, *view.run, id);
      lua_getfield(L, 2, wanted[k].first.c_str());
      all = lua_compare(L, -1, -2, LUA_OPEQ);
      lua_pop(L, 2);
    }
    if (!all) continue;
    push_item(L, view.run, view.kind, id);
    lua_rawseti(L, 3, ++found);
  }
  return 1;
}

constexpr luaL_Reg view_methods[] = {
    {"field", guarded<view_field>}, {"select", guarded<view_select>}, {"where", guarded<view_where>}};

int probe_named(const Model& model, const std::string& name) {
  for (std::size_t i = 0; i < model.probes.size(); ++i) {
    if (model.scene.probes[model.probes[i].probe].name == name) return static_cast<int>(i);
  }
  return -1;
}

int view_index_by_name(lua_State* L, const TableView& view, const std::string& name) {
  const Model& model = view.run->simulation.model;
  if (view.kind == ViewKind::probes) {
    if (const int id = probe_named(model, name); id >= 0) {
      push_item(L, view.run, view.kind, id);
      return 1;
    }
  }
  std::vector<std::string> known;
  for (const auto& [method, function] : view_methods) {
    if (name == method) {
      lua_pushcfunction(L, function);
      return 1;
    }
    known.emplace_back(method);
  }
  if (view.kind != ViewKind::probes) {
    const std::string list = std::string("sim.") + item_word(view.kind) + "s", near = nearest(name, known);
    const std::string hint =
        near.empty() ? "; they go by number, " + list + "[1], or by " + list + ":where { … }" : suggestion(name, known);
    refuse(L, list + " has no \"" + name + '"' + hint);
  }
  known.clear();
  for (const Probe& probe : model.scene.probes) known.push_back(probe.name);
  refuse(L, "there is no probe \"" + name + '"' + suggestion(name, known));
}

int view_index(lua_State* L) {
  const TableView& view = check_view(L);
  if (lua_type(L, 2) == LUA_TSTRING) return view_index_by_name(L, view, lua_tostring(L, 2));
  int exact = 0;
  const lua_Integer id = lua_tointegerx(L, 2, &exact), count = view.count();
  const bool inside = exact && id >= 1 && id <= count;
  if (inside) return push_item(L, view.run, view.kind, static_cast<int>(id - 1)), 1;
  const std::string text =
      std::string("sim.") + item_word(view.kind) + "s: expected a number " +
      (count > 0 ? "from 1 to " + std::to_string(count) : std::string("of one that is there, there is none")) +
      ", got " + describe(L, 2);
  if (!exact || id != count + 1) refuse(L, text);
  note_nothing(L, text);
  lua_pushnil(L);  // where ipairs stops
  return 1;
}

int view_length(lua_State* L) {
  lua_pushinteger(L, check_view(L).count());
  return 1;
}

int view_next(lua_State* L) {
  const lua_Integer id = lua_tointeger(L, 2) + 1;
  if (id > check_view(L).count()) return 0;
  lua_pushinteger(L, id);
  lua_geti(L, 1, id);
  return 2;
}

int view_pairs(lua_State* L) {
  lua_pushcfunction(L, guarded<view_next>);
  lua_pushvalue(L, 1);
  lua_pushinteger(L, 0);
  return 3;
}

int view_text(lua_State* L) {
  const TableView& view = check_view(L);
  lua_pushstring(L, (std::to_string(view.count()) + " " + item_word(view.kind) + "s").c_str());
  return 1;
}

int item_index(lua_State* L) {
  ItemView& item = check_item(L);
  ItemField(L, item.kind, check_name(L, 2, item_word(item.kind))).push(L, *item.run, item.id);
  return 1;
}

double check_finite(lua_State* L, int index, const std::string& what) {
  const double value = lua_tonumber(L, index);
  if (lua_type(L, index) != LUA_TNUMBER || !std::isfinite(value)) {
    refuse(L, what + ": expected a finite number, got " + describe(L, index));
  }
  return value;
}

// block.velocity = {vx, vy} (m/s), block.spin = w (rad/s): the rates of the unknowns of model.h.
int item_set(lua_State* L) {
  ItemView& item = check_item(L);
  const std::string name = check_name(L, 2, item_word(item.kind));
  const std::string label = std::string(item_word(item.kind)) + "." + name;
  if (item.kind != ViewKind::blocks || (name != "velocity" && name != "spin")) {
    refuse(L, label + " cannot be set; a block's velocity and spin can");
  }
  item.run->refuse_inside_step(L, label + " = …");
  Model& model = item.run->simulation.model;
  BlockState& block = model.blocks[item.id];
  if (model.shapes[item.id].dofs == 0)
    refuse(L, label + ": expected a block that can move, got one that is held; a talus.fix moves it");
  if (name == "velocity" && !lua_istable(L, 3)) refuse(L, label + ": expected {vx, vy}, got " + describe(L, 3));
  auto velocity = block.velocity;
  if (name == "spin") {
    velocity[2] = check_finite(L, 3, label) * model.shapes[item.id].length;
  } else {
    for (int i = 0; i < 2; ++i) {
      lua_rawgeti(L, 3, i + 1);
      velocity[i] = check_finite(L, -1, label);
      lua_pop(L, 1);
    }
  }
  if (velocity == block.velocity) return 0;
  item.run->simulation.before_change();
  block.velocity = velocity;
  model.changed();
  return 0;
}

int item_equal(lua_State* L) {
  const auto* a = static_cast<ItemView*>(luaL_testudata(L, 1, item_metatable));
  const auto* b = static_cast<ItemView*>(luaL_testudata(L, 2, item_metatable));
  lua_pushboolean(L, a && b && a->run == b->run && a->kind == b->kind && a->id == b->id);
  return 1;
}

int item_text(lua_State* L) {
  const auto& item = *static_cast<ItemView*>(luaL_checkudata(L, 1, item_metatable));
  lua_pushstring(L, (std::string(item_word(item.kind)) + " " + std::to_string(item.id + 1)).c_str());
  return 1;
}

void register_metatable(lua_State* L, const char* name, const luaL_Reg* functions) {
  luaL_newmetatable(L, name);
  luaL_setfuncs(L, functions, 0);
  lua_pushboolean(L, false);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

}  // namespace

void open_table_views(lua_State* L) {
  constexpr luaL_Reg view[] = {{"__index", guarded<view_index>}, {"__len", guarded<view_length>},
                               {"__pairs", guarded<view_pairs>}, {"__tostring", guarded<view_text>},
                               {"__gc", collect<TableView>},     {nullptr, nullptr}};
  constexpr luaL_Reg item[] = {{"__index", guarded<item_index>}, {"__newindex", guarded<item_set>},
                               {"__eq", guarded<item_equal>},    {"__tostring", guarded<item_text>},
                               {"__gc", collect<ItemView>},      {nullptr, nullptr}};
  register_metatable(L, view_metatable, view);
  register_metatable(L, item_metatable, item);
}

void push_table_view(lua_State* L, const std::shared_ptr<Run>& run, ViewKind kind) {
  push_userdata(L, TableView{run, kind}, view_metatable);
}

void push_item(lua_State* L, const std::shared_ptr<Run>& run, ViewKind kind, int id) {
  push_userdata(L, ItemView{run, kind, id}, item_metatable);
}

int item_id(lua_State* L, int index, const Run& run, ViewKind kind) {
  const auto* item = static_cast<ItemView*>(luaL_testudata(L, index, item_metatable));
  return item && item->run.get() == &run && item->kind == kind ? item->id + 1 : 0;
}

std::string describe_item(lua_State* L, int index, const Run& run) {
  const auto* item = static_cast<ItemView*>(luaL_testudata(L, index, item_metatable));
  if (!item) return describe(L, index);
  return std::string(item_word(item->kind)) + " " + std::to_string(item->id + 1) +
         (item->run.get() == &run ? "" : " of another simulation");
}

}  // namespace talus
