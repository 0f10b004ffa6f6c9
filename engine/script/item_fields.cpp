#include "script/item_fields.h"

#include <algorithm>
#include <array>

#include "fracture/cracks.h"
#include "script/lua_error.h"
#include "script/nearest.h"

namespace talus {
namespace {

void push_text(lua_State* L, const std::string& text) {
  lua_pushlstring(L, text.data(), text.size());
}

const char* state_word(JointState state) {
  return state == JointState::intact ? "intact" : "failed";
}
const char* bond_word(BondKind kind) {
  return kind == BondKind::exact ? "exact" : "spring";
}

const char* state_word(ContactState state) {
  constexpr std::array words = {"open", "stick", "slip"};
  return words[static_cast<std::size_t>(state)];
}

const char* kind_word(ContactKind kind) {
  constexpr std::array words = {"angle-angle", "angle-edge", "edge-edge"};
  return words[static_cast<std::size_t>(kind)];
}

void push_id(lua_State* L, const Model&, int id) {
  lua_pushinteger(L, id + 1);
}

const ShownField block_shown[] = {
    {"id", "number of the block, from 1, in VTK too", push_id},
    {"region", "name of its region",
     [](lua_State* L, const Model& m, int id) { push_text(L, m.scene.regions[m.shapes[id].region].name); }},
    {"material", "name of its material",
     [](lua_State* L, const Model& m, int id) { push_text(L, m.material(id).name); }},
    {"vertices",
     "corners now, list of {x, y} (m); of one of second order, where anything may touch, with the middles of its edges, and more of slender ones",
     [](lua_State* L, const Model& m, int id) {
       lua_createtable(L, m.vertex_count(id), 0);
       for (int k = 0; k < m.vertex_count(id); ++k) {
         const Vec2 p = m.vertex[size_t(m.shapes[id].vertex_begin + k)] + m.origin;
         lua_createtable(L, 2, 0);
         for (int i = 0; i < 2; ++i) {
           lua_pushnumber(L, p[i]);
           lua_rawseti(L, -2, i + 1);
         }
         lua_rawseti(L, -2, k + 1);
       }
     }},
};

const ShownField joint_shown[] = {
    {"id", "number of the joint, from 1, in VTK too", push_id},
    {"block_a", "number of the block on its left, from 1, in VTK too",
     [](lua_State* L, const Model& m, int id) { lua_pushinteger(L, m.joints[id].a + 1); }},
    {"block_b", "number of the block on its right, from 1, in VTK too",
     [](lua_State* L, const Model& m, int id) { lua_pushinteger(L, m.joints[id].b + 1); }},
    {"state", "\"intact\" or \"failed\"",
     [](lua_State* L, const Model& m, int id) { lua_pushstring(L, state_word(m.joints[id].state)); }},
    {"mode", "how it failed: \"none\", \"tension\" or \"shear\"; a real joint never did",
     [](lua_State* L, const Model& m, int id) { lua_pushstring(L, failure_word(m.joints[id].mode)); }},
    {"crack", "what it was when it failed: \"none\", \"initiated\", \"propagated\" or \"coalesced\"",
     [](lua_State* L, const Model& m, int id) { lua_pushstring(L, crack_word(m.joints[id].crack)); }},
    {"kind", "\"exact\" or \"spring\"",
     [](lua_State* L, const Model& m, int id) { lua_pushstring(L, bond_word(m.joints[id].kind)); }},
    {"trace", "joint trace it lies on, from 1; 0 for a joint of the mesh",
     [](lua_State* L, const Model& m, int id) { lua_pushinteger(L, m.joints[id].trace + 1); }},
    {"property", "name of its talus.joint",
     [](lua_State* L, const Model& m, int id) { push_text(L, m.scene.properties[m.joints[id].property].name); }},
};

const ShownField contact_shown[] = {
    {"id", "number of the contact, from 1, in VTK too; valid until the next step", push_id},
    {"block_i", "number of the block of the vertex, from 1; `block_a` in VTK",
     [](lua_State* L, const Model& m, int id) { lua_pushinteger(L, m.contacts[id].i + 1); }},
    {"block_j", "number of the block of the edge, from 1; `block_b` in VTK",
     [](lua_State* L, const Model& m, int id) { lua_pushinteger(L, m.contacts[id].j + 1); }},
    {"vertex", "corner of block_i, from 1",
     [](lua_State* L, const Model& m, int id) { lua_pushinteger(L, m.contacts[id].vertex + 1); }},
    {"edge", "edge of block_j, from 1; it begins at that corner",
     [](lua_State* L, const Model& m, int id) { lua_pushinteger(L, m.contacts[id].edge + 1); }},
    {"state", "\"open\", \"stick\" or \"slip\"",
     [](lua_State* L, const Model& m, int id) { lua_pushstring(L, state_word(m.contacts[id].state)); }},
    {"kind", "\"angle-angle\", \"angle-edge\" or \"edge-edge\"",
     [](lua_State* L, const Model& m, int id) { lua_pushstring(L, kind_word(m.contacts[id].kind)); }},
    {"property", "name of its talus.joint",
     [](lua_State* L, const Model& m, int id) { push_text(L, m.scene.properties[m.contacts[id].property].name); }},
};

const ShownField probe_shown[] = {
    {"name", "its name",
     [](lua_State* L, const Model& m, int id) { push_text(L, m.scene.probes[m.probes[id].probe].name); }},
    {"block", "1-based number of the block it sits on",
     [](lua_State* L, const Model& m, int id) { lua_pushinteger(L, m.probes[id].block + 1); }},
};

}  // namespace

std::span<const ShownField> shown_fields(ViewKind kind) {
  switch (kind) {
    case ViewKind::blocks:
      return block_shown;
    case ViewKind::joints:
      return joint_shown;
    case ViewKind::contacts:
      return contact_shown;
    case ViewKind::probes:
      break;
  }
  return probe_shown;
}

std::span<const Field> registry_fields(ViewKind kind) {
  switch (kind) {
    case ViewKind::blocks:
      return block_fields();
    case ViewKind::joints:
      return joint_fields();
    case ViewKind::contacts:
      return contact_fields();
    case ViewKind::probes:
      break;
  }
  return probe_fields();
}

int item_count(const Model& model, ViewKind kind) {
  const std::array sizes = {model.blocks.size(), model.joints.size(), model.contacts.size(), model.probes.size()};
  return static_cast<int>(sizes[static_cast<std::size_t>(kind)]);
}

const char* item_word(ViewKind kind) {
  constexpr std::array words = {"block", "joint", "contact", "probe"};
  return words[static_cast<std::size_t>(kind)];
}

std::vector<std::string> field_names(ViewKind kind) {
  std::vector<std::string> names;
  for (const ViewField& field : view_fields(kind)) names.push_back(field.name);
  return names;
}

std::vector<ViewField> view_fields(ViewKind kind) {
  std::vector<ViewField> fields;
  for (const ShownField& field : shown_fields(kind)) fields.push_back({field.name, "", field.meaning});
  const std::size_t shown = fields.size();
  for (const Field& field : registry_fields(kind)) {
    const auto same = [&](const ViewField& f) { return f.name == field.name; };
    if (std::any_of(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(shown), same)) continue;
    fields.push_back({field.name, field.unit, field.meaning});
  }
  return fields;
}

namespace {

// What other programs call it, where that is here under another name: nearer than what is spelled alike.
std::string usual_name(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::pair<const char*, const char*> usual[] = {
      {"vx", "velocity"},    {"vy", "velocity"}, {"v", "velocity"}, {"speed", "velocity"}, {"omega", "spin"},
      {"angle", "rotation"}, {"sx", "sxx"},      {"sy", "syy"},     {"x", "centroid"},     {"y", "centroid"}};
  for (const auto& [theirs, ours] : usual)
    if (name == theirs && std::find(known.begin(), known.end(), ours) != known.end()) return ours;
  return name;
}

}  // namespace

ItemField::ItemField(lua_State* L, ViewKind kind, const std::string& name) {
  for (const ShownField& field : shown_fields(kind)) {
    if (name == field.name) shown_ = &field;
  }
  if (!shown_) field_ = find_field(registry_fields(kind), name);
  if (shown_ || field_) return;
  const std::vector<std::string> known = field_names(kind);
  throw ScriptError(ErrorKind::input, user_place(L).text() + ": a " + item_word(kind) + " has no field \"" + name +
                                          '"' + suggestion(usual_name(name, known), known));
}

void ItemField::push(lua_State* L, Run& run, int id) const {
  if (shown_) return shown_->push(L, run.simulation.model, id);
  double value[3] = {};
  field_->get({run.simulation.model, run.simulation.recovery()}, id, value);
  if (field_->components == 1) return lua_pushnumber(L, value[0]);
  lua_createtable(L, field_->components, 0);
  for (int i = 0; i < field_->components; ++i) {
    lua_pushnumber(L, value[i]);
    lua_rawseti(L, -2, i + 1);
  }
}

}  // namespace talus
