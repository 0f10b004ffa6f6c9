#pragma once
// One item of a view: its fields from the registries of model/fields.h, and the words and 1-based ids that
// Lua shows in place of the registries' codes.
#include <lua.hpp>
#include <span>
#include <string>
#include <vector>

#include "model/fields.h"
#include "script/run.h"
#include "script/table_view.h"

namespace talus {

// A field that Lua shows in its own way.
struct ShownField {
  const char* name;
  const char* meaning;
  void (*push)(lua_State* L, const Model& model, int id);
};

std::span<const ShownField> shown_fields(ViewKind kind);
std::span<const Field> registry_fields(ViewKind kind);
int item_count(const Model& model, ViewKind kind);
const char* item_word(ViewKind kind);  // "block"
std::vector<std::string> field_names(ViewKind kind);

// A field looked up once, for reading many items.
class ItemField {
 public:
  // Throws ScriptError(input) naming the script line when there is no such field.
  ItemField(lua_State* L, ViewKind kind, const std::string& name);
  void push(lua_State* L, Run& run, int id) const;

 private:
  const ShownField* shown_ = nullptr;
  const Field* field_ = nullptr;
};

}  // namespace talus
