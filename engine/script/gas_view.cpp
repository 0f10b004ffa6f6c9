#include "script/gas_view.h"

#include <algorithm>
#include <cstdio>

#include "gas/gas.h"
#include "script/lua_error.h"
#include "script/lua_fields.h"

namespace talus {
namespace {

const std::string& charge_of(const Simulation& simulation, int wall) {
  return simulation.model.scene.charges[simulation.model.hole_walls[wall].charge].name;
}

// .reached = { { joint, from, to }, … }, .reach: m of joints that the gas has entered.
void push_reached(lua_State* L, const Model& model, const Reach& reach) {
  double length = 0;
  lua_createtable(L, int(reach.joints.size()), 0);
  for (size_t k = 0; k < reach.joints.size(); ++k) {
    const ReachedJoint& r = reach.joints[k];
    length += (r.to - r.from) * model.joints[r.joint].length;
    lua_createtable(L, 0, 3);
    set_integer(L, "joint", r.joint + 1);
    set_number(L, "from", r.from);
    set_number(L, "to", r.to);
    lua_rawseti(L, -2, lua_Integer(k + 1));
  }
  lua_setfield(L, -2, "reached");
  set_number(L, "reach", length);
}

int chamber_set(lua_State* L) {
  refuse(L,
         "sim.charges[…]." + std::string(luaL_tolstring(L, 2, nullptr)) + " cannot be set: a chamber can only be read");
}

int chamber_next(lua_State* L) {
  lua_settop(L, 2);
  if (lua_next(L, 1) != 0) return 2;
  lua_pushnil(L);
  return 1;
}

int chamber_pairs(lua_State* L) {
  lua_pushcfunction(L, chamber_next);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_pushnil(L);
  return 3;
}

// In place of the table on the top: one through which it can be read only, as what is set in a copy would change
// nothing.
void make_read_only(lua_State* L) {
  lua_newtable(L);
  lua_createtable(L, 0, 4);
  lua_pushvalue(L, -3);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, guarded<chamber_set>);
  lua_setfield(L, -2, "__newindex");
  lua_pushvalue(L, -3);
  lua_pushcclosure(L, chamber_pairs, 1);
  lua_setfield(L, -2, "__pairs");
  lua_pushboolean(L, false);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_replace(L, -2);
}

}  // namespace

std::vector<std::string> early_venting(const Simulation& simulation) {
  std::vector<std::string> notes;
  const auto& events = simulation.gas_events();
  for (const GasEvent& e : events) {
    if (e.kind != GasEventKind::venting || e.collar) continue;
    const auto went_off = std::find_if(events.begin(), events.end(), [&](const GasEvent& other) {
      return other.kind == GasEventKind::detonation && simulation.gas()->chamber_of(other.wall) == e.wall;
    });
    if (went_off == events.end()) continue;
    const Vec2 at = e.at + simulation.model.origin;
    char text[200];
    std::snprintf(
        text, sizeof text,
        " vents in the step in which it goes off, at t = %g s: its hole is open to the free surface at (%g, %g)",
        went_off->time, at.x(), at.y());
    notes.push_back("charge \"" + charge_of(simulation, went_off->wall) + '"' + text);
  }
  return notes;
}

int push_gas_events(lua_State* L, const Simulation& simulation) {
  const auto& events = simulation.gas_events();
  lua_createtable(L, int(events.size()), 0);
  for (size_t k = 0; k < events.size(); ++k) {
    const GasEvent& e = events[k];
    lua_createtable(L, 0, 9);
    set_text(L, "kind",
             e.kind == GasEventKind::detonation ? "detonation"
             : e.kind == GasEventKind::venting  ? "venting"
                                                : "merging");
    set_text(L, "charge", charge_of(simulation, e.wall));
    if (e.kind == GasEventKind::venting) {
      set_text(L, "by", e.collar ? "stemming" : "surface");
      set_number(L, "x", e.at.x() + simulation.model.origin.x());
      set_number(L, "y", e.at.y() + simulation.model.origin.y());
    }
    if (e.other >= 0) set_text(L, "other", charge_of(simulation, e.other));
    set_number(L, "time", e.time);
    set_number(L, "volume", e.volume);
    set_number(L, "pressure", e.pressure);
    lua_rawseti(L, -2, lua_Integer(k + 1));
  }
  return 1;
}

// One table a charge, by number and by name: the chamber that holds its gas.
void push_charges(lua_State* L, const Simulation& simulation) {
  const Gas* gas = simulation.gas();
  lua_newtable(L);
  if (!gas) return;
  constexpr const char* states[] = {"waiting", "pressing", "vented", "merged"};
  for (size_t k = 0; k < gas->chambers().size(); ++k) {
    const int holder = gas->chamber_of(int(k));
    const Chamber& chamber = gas->chambers()[holder];
    const HoleWall& wall = simulation.model.hole_walls[k];
    const int charge = wall.charge;
    const Charge& own = simulation.model.scene.charges[charge];
    lua_createtable(L, 0, 20);
    set_number(L, "delay", own.delay);
    if (own.mass > 0) set_number(L, "mass", own.mass);
    set_number(L, "left", gas->left(charge));
    set_number(L, "opening", chamber.opening);
    if (own.stemming) set_number(L, "stemming", gas->stemming_way(charge));
    set_number(L, "x", wall.centre.x() + simulation.model.origin.x());
    set_number(L, "y", wall.centre.y() + simulation.model.origin.y());
    set_number(L, "radius", wall.radius);
    push_reached(L, simulation.model, gas->reach(holder));
    set_text(L, "name", own.name);
    set_text(L, "state", states[int(gas->first_volume(charge) > 0 ? chamber.state : Chamber::State::waiting)]);
    lua_pushboolean(L, chamber.state == Chamber::State::vented);
    lua_setfield(L, -2, "vented");
    set_number(L, "vented_at", chamber.vented_at);
    set_number(L, "volume", chamber.volume);
    set_number(L, "first_volume", gas->first_volume(charge));
    set_number(L, "pressure", chamber.pressure);
    set_number(L, "front", gas->front(int(k)));
    set_number(L, "work", chamber.work);
    set_number(L, "joined", chamber.joined);
    make_read_only(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, own.name.c_str());
    lua_rawseti(L, -2, lua_Integer(k + 1));
  }
}

}  // namespace talus
