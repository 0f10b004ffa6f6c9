#include "script/failure_laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string_view>

#include "fracture/reduction.h"
#include "script/interrupt.h"
#include "script/laws.h"
#include "script/lua_error.h"

namespace talus {
namespace {

[[noreturn]] void fail(const Place& place, const char* law, const std::string& given, const std::string& problem) {
  throw LawError(place.text() + ": joint." + law + ": " + given + ": " + problem);
}

// `given()`: what the law was asked, in words; only for messages.
template <class Given>
void call(lua_State* L, int arguments, int results, const Place& place, const char* law, const Given& given) {
  const RunningLaw running(L);
  try {
    protected_call(L, arguments, results);
  } catch (const ScriptError& error) {
    if (error.kind == ErrorKind::interrupt) throw;
    fail(place, law, given(), std::string("the function failed: ") + error.what());
  }
}

// What a criterion is asked just now.
struct Question {
  std::span<JudgedBond> bonds;
  const BondPlaces* places = nullptr;
  std::size_t at = 0;  // the bond that it judges
  const JudgedBond& bond() const { return bonds[at]; }
  BondPlace place() const { return (*places)(bond().joint); }
};

// Of the bond, for criteria that ask.
struct BondField {
  const char* name;
  void (*push)(lua_State* L, const Question& question);
};
constexpr BondField bond_fields[] = {
    {"id", [](lua_State* L, const Question& q) { lua_pushinteger(L, q.bond().joint + 1); }},
    {"length", [](lua_State* L, const Question& q) { lua_pushnumber(L, q.place().length); }},
    {"x", [](lua_State* L, const Question& q) { lua_pushnumber(L, q.place().middle.x()); }},
    {"y", [](lua_State* L, const Question& q) { lua_pushnumber(L, q.place().middle.y()); }},
    {"dip", [](lua_State* L, const Question& q) { lua_pushnumber(L, q.place().dip); }},
};

// Upvalues: the place of the question, which is none between judgements, and the property's name.
int bond_field(lua_State* L) {
  const Question* question = *static_cast<Question**>(lua_touserdata(L, lua_upvalueindex(1)));
  const std::string_view name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
  for (const BondField& field : bond_fields)
    if (question && name == field.name) return field.push(L, *question), 1;
  lua_pushnil(L);
  if (name == "property") lua_copy(L, lua_upvalueindex(2), -1);
  return 1;
}

constexpr std::array strength_names = {"friction", "cohesion", "tension"};

// (law, its table, question) -> what it returned that is no utilisation, or the name of a strength that it changed, or
// nothing. Lua takes longer to be given a number than to add two: strengths, which bonds mostly share, are given again
// only where they are others. Fields are set raw, whatever the law has made of its table.
int judge_all(lua_State* L) {
  Question& question = *static_cast<Question*>(lua_touserdata(L, 3));
  for (const char* key : {"normal", "shear"}) lua_pushstring(L, key);
  for (const char* key : strength_names) lua_pushstring(L, key);
  const auto set = [L](int key, double value) {
    lua_pushvalue(L, key);
    lua_pushnumber(L, value);
    lua_rawset(L, 2);
  };
  const Strength* given = nullptr;
  for (; question.at < question.bonds.size(); ++question.at) {
    JudgedBond& bond = question.bonds[question.at];
    set(4, bond.traction.normal);
    set(5, bond.traction.shear);
    if (!given || bond.intact != *given) {
      given = &bond.intact;
      set(6, given->friction);
      set(7, given->cohesion);
      set(8, given->tension);
    }
    lua_pushvalue(L, 1);
    lua_pushvalue(L, 2);
    lua_call(L, 1, 1);
    bond.used = lua_tonumber(L, -1);
    if (lua_type(L, -1) != LUA_TNUMBER || !(bond.used >= 0) || std::isinf(bond.used)) return 1;
    lua_pop(L, 1);
  }
  const double strengths[] = {given->friction, given->cohesion, given->tension};
  for (int k = 0; k < 3; ++k) {
    lua_pushvalue(L, 6 + k);
    lua_rawget(L, 2);
    if (lua_type(L, -1) != LUA_TNUMBER || lua_tonumber(L, -1) != strengths[k]) return lua_pushvalue(L, 6 + k), 1;
  }
  return 0;
}

// A criterion of the script, with the table that it is called with: one for all calls, as a new one each time would
// cost more than the law.
class Criterion {
 public:
  Criterion(const LuaFunction& law, const JointProperty& property)
      : law_(law), table_(table(property.name)), place_(property.place) {}

  void judge(std::span<JudgedBond> bonds, const BondPlaces& places) const {
    if (*now_)
      throw InputError(place_, "joint.criterion", "a function that has no bond explained that it is asked about itself",
                       "one that does");
    Question question = {bonds, &places};
    const struct Asked {
      Question** now;
      ~Asked() { *now = nullptr; }
    } asked = {now_};
    *now_ = &question;
    ask(question);
  }

 private:
  void ask(Question& question) const {
    lua_State* L = law_.state();
    luaL_checkstack(L, 5, "a law");
    lua_pushcfunction(L, judge_all);
    law_.push();
    table_.push();
    lua_pushlightuserdata(L, &question);
    const auto given = [&] {
      const BondTraction& traction = question.bond().traction;
      return arguments_text(std::array{"normal", "shear"}, std::array{traction.normal, traction.shear});
    };
    call(L, 3, 1, place_, "criterion", given);
    if (question.at < question.bonds.size())
      fail(place_, "criterion", given(), "expected a finite number >= 0, got " + describe(L, -1));
    if (!lua_isnil(L, -1))
      throw LawError(
          place_.text() +
          ": joint.criterion: expected a function that leaves what it is given as it is, got one that sets t." +
          lua_tostring(L, -1));
    lua_pop(L, 1);
  }

  LuaFunction table(const std::string& name) {
    lua_State* L = law_.state();
    lua_newtable(L);
    lua_createtable(L, 0, 2);
    now_ = static_cast<Question**>(lua_newuserdatauv(L, sizeof(Question*), 0));
    *now_ = nullptr;
    lua_pushlstring(L, name.data(), name.size());
    lua_pushcclosure(L, bond_field, 2);
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, false);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
    LuaFunction made(L, -1);
    lua_pop(L, 1);
    return made;
  }

  LuaFunction law_;
  Question** now_ = nullptr;  // in Lua, as long as the table
  LuaFunction table_;
  Place place_;
};

FailureCriterion criterion_of(const LuaFunction& law, const JointProperty& property) {
  return [criterion = Criterion(law, property)](std::span<JudgedBond> bonds, const BondPlaces& places) {
    criterion.judge(bonds, places);
  };
}

// (law, intact, slip, opening, normal; friction, cohesion, tension of `intact`) -> what it returned, a key in it that
// there is not or nil, and where it is a table friction, cohesion and tension.
int reduce(lua_State* L) {
  for (int k = 0; k < 3; ++k) {
    lua_pushstring(L, strength_names[k]);
    lua_pushvalue(L, 6 + k);
    lua_rawset(L, 2);
  }
  lua_settop(L, 5);
  lua_call(L, 4, 1);
  if (!lua_istable(L, 1)) return 1;
  lua_settop(L, 5);
  for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1)) {
    const char* key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
    if (std::none_of(strength_names.begin(), strength_names.end(),
                     [key](const char* known) { return std::strcmp(known, key) == 0; })) {
      lua_pushvalue(L, -2);
      lua_replace(L, 2);
    }
  }
  for (int k = 0; k < 3; ++k) {
    lua_getfield(L, 1, strength_names[k]);
    lua_replace(L, 3 + k);
  }
  return 5;
}

ReductionLaw reduction_of(const LuaFunction& law, const JointProperty& property) {
  lua_newtable(law.state());
  const LuaFunction arguments(law.state(), -1);  // one table for all calls
  lua_pop(law.state(), 1);
  return [law, arguments, place = property.place, scattered = property.weibull > 0](const Strength& intact,
                                                                                    const JointWear& wear) {
    lua_State* L = law.state();
    const auto given = [&] {
      return arguments_text(std::array{"slip", "opening", "normal"}, std::array{wear.slip, wear.opening, wear.normal});
    };
    luaL_checkstack(L, 10, "a law");
    lua_pushcfunction(L, reduce);
    law.push();
    arguments.push();
    for (const double value : {wear.slip, wear.opening, wear.normal, intact.friction, intact.cohesion, intact.tension})
      lua_pushnumber(L, value);
    call(L, 8, 5, place, "reduction", given);
    const int answer = lua_gettop(L) - 4;
    if (!lua_istable(L, answer)) fail(place, "reduction", given(), "expected a table, got " + describe(L, answer));
    if (!lua_isnil(L, answer + 1))
      fail(place, "reduction", given(),
           "expected friction, cohesion and tension in the table, got " + describe(L, answer + 1));
    const auto read = [&](int k, double missing, double most, const char* hint) {
      const int at = answer + 2 + k;
      const double value = lua_isnil(L, at) ? missing : lua_tonumber(L, at);
      if (!(lua_isnil(L, at) || lua_type(L, at) == LUA_TNUMBER) || !(value >= 0) || value > most * (1 + 1e-12))
        fail(place, "reduction", given(),
             std::string("expected a ") + strength_names[k] + " from 0 to " + number_text(most) + hint + ", got " +
                 describe(L, at));
      return value;
    };
    constexpr double right_angle = 1.5707963267948966;
    const char* own = scattered
                          ? " (Pa), the intact one of this bond, as its strength is scattered (take it from `intact`)"
                          : " (Pa), the intact one";
    const Strength left = {read(0, intact.friction, right_angle, " (rad)"), read(1, 0, intact.cohesion, own),
                           read(2, 0, intact.tension, own)};
    lua_settop(L, answer - 1);
    return left;
  };
}

ReductionLaw ready_made(const TableReader& t, JointProperty& property) {
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
    const Softening law = {shape == "exponential", energy_opening, energy_slip > 0 ? energy_slip : energy_opening,
                           residual};
    property.softening_compliance = softening_compliance(law, property.tension);
    if (energy_slip > 0) property.shear_compliance = shear_compliance(law, property.cohesion);
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
    property.criterion = criterion_of(LuaFunction(L, -1), property);
    lua_pop(L, 1);
  }
  if (t.push("reduction")) {
    property.reduction = reduction_of(LuaFunction(L, -1), property);
    lua_pop(L, 1);
  }
  t.with("law", [&](const TableReader& law) { property.reduction = ready_made(law, property); });
}

}  // namespace talus
