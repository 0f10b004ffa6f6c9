#include <gtest/gtest.h>

#include <stdexcept>

#include "script/lua_error.h"
#include "script/lua_state.h"
#include "script/nearest.h"
#include "script/size_grade.h"
#include "script/table_reader.h"

namespace talus {
namespace {

// Runs a chunk; its error, or nothing.
std::string run(const LuaState& state, const std::string& chunk) {
  lua_State* L = state.get();
  if (luaL_loadbufferx(L, chunk.data(), chunk.size(), "@scene.lua", "t") != LUA_OK) return pop_error(L).what();
  try {
    protected_call(L, 0, 0);
  } catch (const ScriptError& error) {
    return error.what();
  }
  return "";
}

TEST(Sandbox, HasNoFilesProcessesOrBytecode) {
  const LuaState state;
  EXPECT_EQ(run(state, "assert(io == nil and debug == nil and dofile == nil and loadfile == nil)"), "");
  EXPECT_EQ(run(state,
                "local there = {time = true, clock = true, date = true} "
                "for name, f in pairs(os) do assert(pcall(f) == (there[name] or false), name) end"),
            "");
  EXPECT_EQ(run(state, "\nos.execute('ls')"), "scene.lua:2: os.execute: a scene starts no programs");
  EXPECT_NE(run(state, "io.open('x')").find("a scene has no files"), std::string::npos);
  EXPECT_EQ(run(state, "assert(require('os') == os and package.loadlib == nil and package.cpath == '')"), "");
  EXPECT_EQ(run(state, "assert(load(string.dump(function() end)) == nil)"), "");
  EXPECT_EQ(run(state, "assert(load(string.dump(function() end), 'x', 'b') == nil)"), "");
  EXPECT_EQ(run(state, "local e = {x = 3}; assert(load('return x', 'x', 't', e)() == 3)"), "");
}

TEST(LuaState, MemoryIsCapped) {
  const LuaState state({.memory_cap = 1 << 20, .library = ""});
  EXPECT_EQ(run(state, "local t = {}\nfor i = 1, 1e9 do t[i] = i end"),
            "scene.lua:2: out of memory: the script may have 1 MB");
  EXPECT_EQ(run(state, "assert(#string.rep('x', 1000) == 1000)"), "");
}

TEST(LuaState, ErrorsOfTheScriptCarryNoTraceback) {
  const LuaState state;
  EXPECT_EQ(run(state, "\nlocal x = nil + 1"), "scene.lua:2: attempt to perform arithmetic on a nil value");
  EXPECT_EQ(run(state, "error({})").find("traceback"), std::string::npos);
  EXPECT_EQ(run(state, "error(setmetatable({}, {__tostring = function() return 'mine' end}))"), "mine");
}

int throws_logic_error(lua_State*) {
  throw std::logic_error("a fault");
}
int throws_run_error(lua_State*) {
  throw RunError("no equilibrium");
}

TEST(Boundary, ExceptionsBecomeErrorsWithAKind) {
  const LuaState state;
  lua_register(state.get(), "fault", guarded<throws_logic_error>);
  lua_register(state.get(), "stop", guarded<throws_run_error>);
  EXPECT_EQ(
      run(state, "local ok, e = pcall(fault); assert(not ok and e.kind == 'internal' and tostring(e) == 'a fault')"),
      "");
  EXPECT_EQ(run(state, "local ok, e = pcall(stop); assert(e.kind == 'run'); assert('x: ' .. e == 'x: no equilibrium')"),
            "");
  lua_getglobal(state.get(), "stop");
  try {
    protected_call(state.get(), 0, 0);
    FAIL();
  } catch (const ScriptError& error) {
    EXPECT_EQ(error.kind, ErrorKind::run);
  }
}

TEST(Boundary, AnErrorObjectBentByTheScriptIsStillAnError) {
  const LuaState state;
  lua_register(state.get(), "stop", guarded<throws_run_error>);
  EXPECT_NE(run(state, "local ok, e = pcall(stop); e.kind, e.message = nil, nil; error(e)"), "");
}

TEST(Nearest, FindsSlipsOfTheKeyboard) {
  const std::vector<std::string> known = {"young", "density", "poisson", "plane"};
  EXPECT_EQ(nearest("yuong", known), "young");
  EXPECT_EQ(nearest("Young", known), "young");
  EXPECT_EQ(nearest("densty", known), "density");
  EXPECT_EQ(nearest("friction", known), "");
  EXPECT_EQ(nearest("Mpa", {"GPa", "kPa", "MPa"}), "MPa");
  EXPECT_EQ(nearest("YUONG", known), "young");
  EXPECT_EQ(nearest("KN", {"MN", "N", "kN"}), "kN");
  EXPECT_EQ(nearest("x", {"y"}), "");
  EXPECT_EQ(suggestion("zz", {"alpha", "beta"}), "; known: alpha, beta");
  EXPECT_EQ(suggestion("zz", {}), "; there are none");
}

TEST(TableReader, ReadsAndRefuses) {
  const LuaState state;
  lua_State* L = state.get();
  ASSERT_EQ(run(state, "t = { a = 1.5, n = 3, p = {1, 2}, line = {{0, 0}, {1, 2}}, list = {{x = 1}, {x = 2}}, i = 4 }"),
            "");
  lua_getglobal(L, "t");
  const TableReader t(L, -1);
  double a = 0, missing = 7;
  int n = 0, index = 0, none = 0;
  Polyline line;
  std::optional<Vec2> point, nothing;
  t.read("a", a);
  t.read("missing", missing);
  t.read("n", n);
  t.read("p", point);
  t.read("q", nothing);
  t.read("line", line);
  t.read_index("i", index);
  t.read_index("missing", none);
  double sum = 0;
  t.each("list", [&](const TableReader& e) {
    double x = 0;
    e.read("x", x);
    sum += x;
  });
  EXPECT_EQ(a, 1.5);
  EXPECT_EQ(missing, 7);
  EXPECT_EQ(n, 3);
  EXPECT_EQ(*point, Vec2(1, 2));
  EXPECT_FALSE(nothing);
  EXPECT_EQ(line[1], Vec2(1, 2));
  EXPECT_EQ(index, 3);
  EXPECT_EQ(none, -1);
  EXPECT_EQ(sum, 3);
  std::string text;
  EXPECT_THROW(t.read("a", text), std::logic_error);
}

TEST(SizeGrade, GrowsLinearlyUpToFar) {
  SizeGrade grade;
  grade.far = 1;
  grade.sources = {{{{0, 0}}, false, 0.1, 2}, {{{10, 0}, {10, 4}}, false, 0.5, 1}};
  EXPECT_DOUBLE_EQ(grade({0, 0}), 0.1);
  EXPECT_DOUBLE_EQ(grade({1, 0}), 0.55);
  EXPECT_DOUBLE_EQ(grade({5, 5}), 1);
  EXPECT_DOUBLE_EQ(grade({10, 2}), 0.5);
  EXPECT_DOUBLE_EQ(grade({10.5, 2}), 0.75);
}

TEST(SizeGrade, MeasuresFromTheBoundaryOfAHole) {
  SizeGrade grade;
  grade.far = 1;
  grade.sources = {{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, true, 0.2, 1}};
  EXPECT_DOUBLE_EQ(grade({0, 1}), 0.2);
  EXPECT_DOUBLE_EQ(grade({-0.5, 1}), 0.6);
}

}  // namespace
}  // namespace talus
