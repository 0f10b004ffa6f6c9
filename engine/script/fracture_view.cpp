#include "script/fracture_view.h"

#include <algorithm>
#include <array>

#include "fracture/cracks.h"
#include "script/lua_fields.h"
#include "step/step_parts.h"

namespace talus {
namespace {

Vec2 middle(const Model& model, const Joint& joint) {
  return model.place(joint.a, (joint.in_a[0] + joint.in_a[1]) / 2) + model.origin;
}

}  // namespace

int push_fractures(lua_State* L, const Simulation& simulation) {
  const Model& model = simulation.model;
  const std::vector<int>& failed = simulation.fractures();
  lua_createtable(L, int(failed.size()), 0);
  for (size_t k = 0; k < failed.size(); ++k) {
    const Joint& joint = model.joints[failed[k]];
    const Vec2 at = middle(model, joint);
    lua_createtable(L, 0, 10);
    set_integer(L, "joint", failed[k] + 1);
    set_text(L, "mode", failure_word(joint.mode));
    set_text(L, "kind", crack_word(joint.crack));
    set_number(L, "x", at.x());
    set_number(L, "y", at.y());
    set_number(L, "length", joint.length);
    set_number(L, "time", joint.failed_at);
    set_number(L, "normal", joint.failed_with.normal);
    set_number(L, "shear", joint.failed_with.shear);
    set_number(L, "utilisation", joint.utilisation);
    lua_rawseti(L, -2, lua_Integer(k + 1));
  }
  return 1;
}

// { { joints = {…}, length, tension, shear }, …; tension, shear: lengths of them all }; bonds that failed, by cracks
// that hang together, the first joint's first.
void push_cracks(lua_State* L, const Model& model) {
  const std::vector<int> crack_at_node = cracks_at_nodes(model);
  std::vector<std::vector<int>> joints(crack_at_node.size());
  for (size_t j = 0; j < model.joints.size(); ++j)
    if (model.joints[j].mode != FailureMode::none) joints[crack_at_node[model.joints[j].node[0]]].push_back(int(j));
  std::erase_if(joints, [](const auto& list) { return list.empty(); });
  std::sort(joints.begin(), joints.end());
  lua_createtable(L, int(joints.size()), 2);
  std::array<double, 2> all{};
  for (size_t c = 0; c < joints.size(); ++c) {
    std::array<double, 2> length{};
    lua_createtable(L, 0, 4);
    lua_createtable(L, int(joints[c].size()), 0);
    for (size_t k = 0; k < joints[c].size(); ++k) {
      const Joint& joint = model.joints[joints[c][k]];
      length[joint.mode == FailureMode::shear] += joint.length;
      lua_pushinteger(L, joints[c][k] + 1);
      lua_rawseti(L, -2, lua_Integer(k + 1));
    }
    lua_setfield(L, -2, "joints");
    set_number(L, "length", length[0] + length[1]);
    set_number(L, "tension", length[0]);
    set_number(L, "shear", length[1]);
    lua_rawseti(L, -2, lua_Integer(c + 1));
    for (int mode : {0, 1}) all[mode] += length[mode];
  }
  set_number(L, "tension", all[0]);
  set_number(L, "shear", all[1]);
}

void push_fragments(lua_State* L, const Model& model) {
  const std::vector<Fragment> found = fragments(model);
  lua_createtable(L, int(found.size()), 0);
  for (size_t f = 0; f < found.size(); ++f) {
    lua_createtable(L, 0, 13);
    set_integer(L, "blocks", found[f].blocks);
    set_integer(L, "first", found[f].first + 1);
    set_text(L, "region", model.scene.regions[model.shapes[found[f].first].region].name);
    lua_pushboolean(L, found[f].held);
    lua_setfield(L, -2, "held");
    set_number(L, "area", found[f].area);
    set_number(L, "mass", found[f].mass);
    set_number(L, "size", found[f].size());
    set_number(L, "x", found[f].centroid.x() + model.origin.x());
    set_number(L, "y", found[f].centroid.y() + model.origin.y());
    set_number(L, "ux", found[f].shift.x());
    set_number(L, "uy", found[f].shift.y());
    set_number(L, "vx", found[f].velocity.x());
    set_number(L, "vy", found[f].velocity.y());
    lua_rawseti(L, -2, lua_Integer(f + 1));
  }
}

// { name of a fix = { x, y } }, N/m: of all entries of that name.
void push_reactions(lua_State* L, Simulation& simulation) {
  const std::vector<Vec2> reactions = simulation.step_parts().reactions();
  lua_newtable(L);
  for (size_t f = 0; f < reactions.size(); ++f) {
    const char* name = simulation.model.scene.fixities[f].name.c_str();
    Vec2 sum = reactions[f];
    if (lua_getfield(L, -1, name) == LUA_TTABLE)
      for (int i = 0; i < 2; ++i) {
        lua_rawgeti(L, -1, i + 1);
        sum[i] += lua_tonumber(L, -1);
        lua_pop(L, 1);
      }
    lua_pop(L, 1);
    lua_createtable(L, 2, 0);
    for (int i = 0; i < 2; ++i) {
      lua_pushnumber(L, sum[i]);
      lua_rawseti(L, -2, i + 1);
    }
    lua_setfield(L, -2, name);
  }
}

}  // namespace talus
