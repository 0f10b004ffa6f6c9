#include <gtest/gtest.h>

#include <cmath>

#include "scene/history_law.h"
#include "script/laws.h"
#include "script/lua_error.h"
#include "script/lua_state.h"

namespace talus {
namespace {

TEST(HistoryLaw, ConstantAtAllTimes) {
  const History history(3.5);
  EXPECT_EQ(history.at(-1), 3.5);
  EXPECT_EQ(history.at(1e9), 3.5);
  EXPECT_EQ(History().at(0), 0);
}

TEST(HistoryLaw, StraightLinesAndHeldEnds) {
  const History history({{1, 10}, {2, 20}, {4, 0}});
  EXPECT_EQ(history.at(0), 10);
  EXPECT_EQ(history.at(1), 10);
  EXPECT_EQ(history.at(1.5), 15);
  EXPECT_EQ(history.at(3), 10);
  EXPECT_EQ(history.at(4), 0);
  EXPECT_EQ(history.at(5), 0);
}

TEST(HistoryLaw, JumpsWhereTwoRowsShareATime) {
  const History history({{0, 1}, {1, 1}, {1, 5}, {2, 5}});
  EXPECT_EQ(history.at(0.999), 1);
  EXPECT_EQ(history.at(1), 5);
}

class Laws : public testing::Test {
 protected:
  LuaFunction compile(const std::string& body) {
    const std::string chunk = "return function(x, y) " + body + " end";
    EXPECT_EQ(luaL_loadstring(state.get(), chunk.c_str()), LUA_OK);
    protected_call(state.get(), 0, 1);
    LuaFunction function(state.get(), -1);
    lua_pop(state.get(), 1);
    return function;
  }

  std::string failure(const std::string& body) {
    try {
      History(history_law(compile(body), {"scene.lua", 7}, "point_load.force[1]")).at(0.5);
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  }

  LuaState state;
};

TEST_F(Laws, ReturnWhatLuaReturns) {
  const History history(history_law(compile("return 2*x"), {"scene.lua", 1}, "force"));
  EXPECT_EQ(history.at(0.25), 0.5);
  EXPECT_EQ(lua_gettop(state.get()), 0);
}

TEST_F(Laws, FailuresNameLawPlaceTimeAndValue) {
  const std::string head = "scene.lua:7: point_load.force[1]: at t = 0.5";
  EXPECT_EQ(failure("return nil"), head + ": expected a finite number, got nothing");
  EXPECT_EQ(failure("return 0/0"), head + ": expected a finite number, got nan");
  EXPECT_EQ(failure("return -1/0"), head + ": expected a finite number, got -inf");
  EXPECT_EQ(failure("return '5'"), head + ": expected a finite number, got \"5\"");
  EXPECT_EQ(failure("return {}"), head + ": expected a finite number, got an empty table");
  EXPECT_TRUE(failure("error 'no law'").starts_with(head + " the function failed: "));
  EXPECT_EQ(lua_gettop(state.get()), 0);
}

TEST_F(Laws, EndlessRecursionIsAFailureLikeAnother) {
  EXPECT_NE(failure("local function f() return 1 + f() end return f()").find("stack overflow"), std::string::npos);
}

TEST_F(Laws, SizesMustBePositive) {
  const auto size = size_law(compile("return 1 - x"), {"scene.lua", 3}, "region.mesh.size");
  EXPECT_EQ(size({0.25, 0}), 0.75);
  EXPECT_THROW(size({1, 0}), InputError);
  EXPECT_THROW(size_law(compile("return"), {}, "size")({0, 0}), ScriptError);
}

TEST_F(Laws, OutliveTheLastLuaReference) {
  std::function<double(double)> law = history_law(compile("return x + 1"), {}, "law");
  lua_gc(state.get(), LUA_GCCOLLECT);
  EXPECT_EQ(law(1), 2);
}

}  // namespace
}  // namespace talus
