#include "script/failure_laws.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "fracture/reduction.h"
#include "script/laws.h"
#include "script/lua_error.h"
#include "script/lua_fields.h"

namespace talus {
namespace {

// A table that a law is called with again and again: it is asked for each bond at each step, and a new one each time would
// cost more than the law.
class Arguments {
 public:
  explicit Arguments(lua_State* L) : table_(make(L)) {}
  void push() const { table_.push(); }
 private:
  static LuaFunction make(lua_State* L) {
    lua_newtable(L);
    LuaFunction kept(L, -1);
    lua_pop(L, 1);
    return kept;
  }
  LuaFunction table_;  // any value that the registry keeps
};

[[noreturn]] void fail(const Place& place, const char* law, const std::string& given, const std::string& problem) {
  throw LawError(place.text() + ": joint." + law + ": " + given + ": " + problem);
}

void set_strength(lua_State* L, const Strength& strength) {
  set_number(L, "friction", strength.friction);
  set_number(L, "cohesion", strength.cohesion);
  set_number(L, "tension", strength.tension);
}

// The law's one result, on the top of the stack. `given()`: what it was asked, in words; only for messages.
template <class Given>
void call(lua_State* L, int arguments, const Place& place, const char* law, const Given& given) {
  try {
    protected_call(L, arguments, 1);
  } catch (const ScriptError& error) {
    if (error.kind == ErrorKind::interrupt) throw;
    fail(place, law, given(), std::string("the function failed: ") + error.what());
  }
}

FailureCriterion criterion_of(const LuaFunction& law, const Place& place) {
  const Arguments arguments(law.state());
  return [=](const BondTraction& traction, const Strength& intact) {
    lua_State* L = law.state();
    luaL_checkstack(L, 4, "a law");
    law.push();
    arguments.push();
    set_number(L, "normal", traction.normal);
    set_number(L, "shear", traction.shear);
    set_strength(L, intact);
    const auto given = [&] { 
      return arguments_text(std::array{"normal", "shear"}, std::array{traction.normal, traction.shear});
    };
    call(L, 1, place, "criterion", given);
    const bool number = lua_type(L, -1) == LUA_TNUMBER && !std::isnan(lua_tonumber(L, -1));
    const double used = lua_tonumber(L, -1);
    if (!number) fail(place, "criterion", given(), "expected a number, got " + describe(L, -1));
    lua_pop(L, 1);
    return used;
  };
}

ReductionLaw reduction_of(const LuaFunction& law, const Place& place) {
  const Arguments arguments(law.state());
  return [=](const Strength& intact, const JointWear& wear) {
    lua_State* L = law.state();
    const auto given = [&] {
      return arguments_text(std::array{"slip", "opening", "normal"}, std::array{wear.slip, wear.opening, wear.normal});
    };
    luaL_checkstack(L, 8, "a law");
    law.push();
    arguments.push();
    set_strength(L, intact);
    lua_pushnumber(L, wear.slip);
    lua_pushnumber(L, wear.opening);
    lua_pushnumber(L, wear.normal);
    call(L, 4, place, "reduction", given);
    if (!lua_istable(L, -1)) fail(place, "reduction", given(), "expected a table, got " + describe(L, -1));
    const auto read = [&](const char* name, double missing, double most) {
      lua_getfield(L, -1, name);
      const double value = lua_isnil(L, -1) ? missing : lua_tonumber(L, -1);
      if (!(lua_isnil(L, -1) || lua_type(L, -1) == LUA_TNUMBER) || !(value >= 0) || value > most * (1 + 1e-12))
        fail(place, "reduction", given(), std::string("expected a ") + name + " from 0 to " + "the intact one = " + number_text(most) +
                                            ", got " + describe(L, -1));
      lua_pop(L, 1);
      return value;
    };
    constexpr double right_angle = 1.5707963267948966;
    const Strength left = {read("friction", intact.friction, right_angle), read("cohesion", 0, intact.cohesion),
                           read("tension", 0, intact.tension)};
    lua_pop(L, 1);
    return left;
  };
}

ReductionLaw ready_made(const TableReader& t, const JointProperty& property, double& compliance) {
  const Strength& residual = property.residual;
  std::string kind, shape;
  double energy_opening = 0, energy_slip = 0, distance = 0, jrc = 0, jcs = 0;
  t.read("kind", kind);
  t.read("shape", shape);
  t.read("G_I", energy_opening);
  t.read("G_II", energy_slip);
  t.read("distance", distance);
  t.read("jrc", jrc);
  t.read("jcs", jcs);
  if (kind == "softening") {
    const Softening law = {shape == "exponential", energy_opening, energy_slip, residual};
    compliance = softening_compliance(law, property.tension);
    return softening(law);
  }
  if (kind == "slip_weakening") return slip_weakening(distance, residual);
  if (kind == "barton_bandis") return barton_bandis(jrc, jcs, residual.friction);
  throw std::logic_error("scene table: no law " + kind);
}

}  // namespace

void read_failure_laws(const TableReader& t, JointProperty& property) {
  lua_State* L = t.state();
  if (t.push("criterion")) {
    property.criterion = criterion_of(LuaFunction(L, -1), property.place);
    lua_pop(L, 1);
  }
  if (t.push("reduction")) {
    property.reduction = reduction_of(LuaFunction(L, -1), property.place);
    lua_pop(L, 1);
  }
  t.with("law", [&](const TableReader& law) { property.reduction = ready_made(law, property, property.softening_compliance); });
}

}  // namespace talus
