// The schema against the engine: what a scene leaves out must be what scene.h says, everything that it says
// must arrive, and the reference page must be the one generated from it.
#include <gtest/gtest.h>

#include <fstream>
#include <numbers>
#include <sstream>

#include "script/lua_error.h"
#include "script/lua_state.h"
#include "script/native.h"
#include "script/reference.h"
#include "script/scene_reader.h"

namespace talus {
namespace {

class Schema : public testing::Test {
 protected:
  // What a script's talus.simulation hands to the engine, without building it.
  Scene scene_of(const std::string& script) {
    lua_State* L = state_.get();
    set_search_path(L, "", state_.library());
    open_native(L);
    const std::string chunk =
        "local native = require 'talus.native'\n"
        "native.create = function(scene) made = scene; return {} end\n"
        "local talus = require 'talus'\n"
        "local rock = talus.material { density = 2000, young = 1e9, poisson = 0.25 }\n" +
        script;
    if (luaL_loadbufferx(L, chunk.data(), chunk.size(), "@scene.lua", "t") != LUA_OK) throw pop_error(L);
    protected_call(L, 0, 0);
    lua_getglobal(L, "made");
    return read_scene(TableReader(L, -1));
  }

 private:
  LuaState state_;  // outlives the laws of the scene
};

constexpr const char* least = R"(
talus.simulation { regions = { talus.region { outline = talus.rect(2, 1, 0, 0), material = rock,
                   cuts = { talus.joint_set { dip = 1, spacing = 2 } } } }, time = { t_end = 1 },
                   output = { dir = "out" } })";

TEST_F(Schema, DefaultsAreThoseOfTheEngine) {
  const Scene s = scene_of(least);
  const JointProperty joint;
  ASSERT_EQ(s.properties.size(), 1u);
  EXPECT_DOUBLE_EQ(s.properties[0].friction, std::numbers::pi / 6);
  EXPECT_EQ(s.properties[0].bond, joint.bond);
  EXPECT_EQ(s.properties[0].penalty, joint.penalty);
  EXPECT_EQ(s.properties[0].stiffness_kind, joint.stiffness_kind);
  EXPECT_EQ(s.properties[0].stiffness, joint.stiffness);
  EXPECT_EQ(s.properties[0].shear_ratio, joint.shear_ratio);
  const Numerics numerics;
  EXPECT_EQ(s.numerics.profile, numerics.profile);
  EXPECT_EQ(s.numerics.integrator, numerics.integrator);
  EXPECT_EQ(s.numerics.theta, numerics.theta);
  EXPECT_EQ(s.numerics.dynamic_parameter, numerics.dynamic_parameter);
  EXPECT_EQ(s.numerics.contact_tolerance, numerics.contact_tolerance);
  EXPECT_EQ(s.numerics.static_tolerance, numerics.static_tolerance);
  EXPECT_EQ(s.numerics.max_iterations, numerics.max_iterations);
  EXPECT_EQ(s.numerics.threads, numerics.threads);
  EXPECT_EQ(s.numerics.recovery, numerics.recovery);
  const TimeControl time;
  EXPECT_EQ(s.time.mode, time.mode);
  EXPECT_EQ(s.time.steps, time.steps);
  EXPECT_EQ(s.time.displacement_ratio, time.displacement_ratio);
  EXPECT_EQ(s.time.settled_start, time.settled_start);
  EXPECT_EQ(s.time.max_steps, time.max_steps);
  const Output output;
  EXPECT_EQ(s.output.vtk, output.vtk);
  EXPECT_EQ(s.output.picture, output.picture);
  EXPECT_EQ(s.output.picture_field, output.picture_field);
  EXPECT_EQ(s.output.picture_scale, output.picture_scale);
  const JointSet set;
  EXPECT_EQ(s.regions[0].joint_sets[0].persistence, set.persistence);
  EXPECT_EQ(s.regions[0].joint_sets[0].seed, set.seed);
  EXPECT_EQ(s.regions[0].joint_sets[0].bonded, set.bonded);
  EXPECT_EQ(s.max_blocks, Scene().max_blocks);
  EXPECT_EQ(s.materials[0].plane, Material().plane);
}

TEST_F(Schema, EverythingArrives) {
  const Scene s = scene_of(R"(
local bond = talus.joint { name = "bond", friction = 0.5, cohesion = 3, tension = 2, bond = "spring", stiffness = { per = "contact", value = 7 } }
local slab = talus.region { name = "slab", outline = { {0, 0}, {0, 1}, {4, 1}, {4, 0} }, material = rock, joint = bond, order = "rigid", held = true }
local block = talus.region { name = "block", outline = talus.rect(1, 1, 2, 2), material = rock, velocity = {1, 2}, spin = 3,
  spin_centre = {1, 1}, stress = { sxx = -1, syy = -2, sxy = 3, gradient_y = {0, 5, 0} }, body_force = {0, 9},
  holes = { talus.circle { at = {1.5, 1.5}, radius = 0.1, sides = 8, name = "h" } },
  mesh = { size = talus.grade { { at = "h", size = 0.05 }, far = 0.2 } },
  cuts = { talus.trace { points = talus.line(1, 1, 2, 2), joint = bond, bonded = true },
           talus.joint_set { dip = 1, spacing = 2, through = {0, 0}, seed = 9 } } }
talus.simulation {
  title = "all", gravity = {0, -9.81}, regions = { slab, block }, max_blocks = 1000,
  contacts = { talus.contact { between = { "slab", block }, joint = bond } },
  fix = { talus.fix { region = slab, velocity = {0.1, 0} }, talus.fix { region = "block", on = { "left", "top" }, x = true } },
  loads = { talus.point_load { at = {1.5, 2}, force = {0, { {0, 0}, {2, 4} }} },
            talus.pressure { region = block, on = talus.line(1, 2, 2, 2), value = 5 },
            talus.edge_load { region = block, on = "right", traction = {1, function(t) return 2*t end} } },
  probes = { b = {1.2, 1.2}, a = { at = {3, 0.5}, region = "slab" } },
  time = { mode = "static", t_end = 2, steps = 5 },
  numerics = { theta = 0.5 },
  output = { dir = "out", every = 0.5, vtk = false, picture = { field = "uy", scale = 10 } },
})");
  EXPECT_EQ(s.title, "all");
  EXPECT_EQ(s.gravity, Vec2(0, -9.81));
  ASSERT_EQ(s.regions.size(), 2u);
  EXPECT_EQ(s.materials.size(), 1u);
  const Region& slab = s.regions[0];
  EXPECT_EQ(slab.order, BlockOrder::rigid);
  EXPECT_TRUE(slab.held);
  EXPECT_EQ(s.properties[static_cast<std::size_t>(slab.joint)].name, "bond");
  EXPECT_EQ(s.properties[static_cast<std::size_t>(slab.joint)].stiffness, 7);
  const Region& block = s.regions[1];
  EXPECT_EQ(block.spin_centre.value(), Vec2(1, 1));
  EXPECT_EQ(block.stress->value, Eigen::Vector3d(-1, -2, 3));
  EXPECT_EQ(block.stress->gradient_y, Eigen::Vector3d(0, 5, 0));
  EXPECT_EQ(block.body_force[1].at(0), 9);
  EXPECT_EQ(block.holes[0].outline.size(), 8u);
  EXPECT_NEAR(block.mesh.size_at({1.6, 1.5}), 0.05, 1e-12);
  EXPECT_NEAR(block.mesh.size_at({5, 5}), 0.2, 1e-12);
  EXPECT_TRUE(block.traces[0].bonded);
  EXPECT_EQ(block.joint_sets[0].seed, 9u);
  EXPECT_EQ(block.joint_sets[0].property, block.joint);
  EXPECT_EQ(s.contact_rules[0].region_b, 1);
  ASSERT_EQ(s.fixities.size(), 3u);  // the second acts on two sides
  EXPECT_EQ(s.fixities[0].motion, Fixity::velocity);
  EXPECT_EQ(s.fixities[1].on.to, Vec2(1, 2));
  EXPECT_EQ(s.fixities[2].on.from, Vec2(1, 2));
  EXPECT_EQ(s.fixities[2].held, (std::array{true, false}));
  EXPECT_EQ(s.point_loads[0].force[1].at(1), 2);
  EXPECT_TRUE(s.edge_loads[0].is_pressure);
  EXPECT_EQ(s.probes[0].name, "a");
  EXPECT_EQ(s.probes[0].region, 0);
  EXPECT_EQ(s.time.steps, 5);
  EXPECT_EQ(s.output.picture_field, "uy");
  EXPECT_EQ(s.regions[1].place.text(), "scene.lua:8");
}

TEST_F(Schema, ProfileFillsWhatJointsLeaveOut) {
  const Scene s = scene_of(R"(
local soft = talus.material { density = 2000, young = 1e8, poisson = 0.25 }
local bond = talus.joint { name = "bond", cohesion = 1 }
local own = talus.joint { name = "own", bond = "exact", stiffness = { per = "contact", times_young = 90 } }
talus.simulation { regions = {
  talus.region { name = "a", outline = talus.rect(0, 0, 1, 1), material = rock, joint = bond },
  talus.region { name = "b", outline = talus.rect(2, 0, 3, 1), material = soft, joint = bond },
  talus.region { name = "c", outline = talus.rect(4, 0, 5, 1), material = rock, joint = own },
  talus.region { name = "d", outline = talus.rect(6, 0, 7, 1), material = rock, joint = bond } },
  time = { t_end = 1 }, numerics = talus.profile.ning2011 })");
  EXPECT_EQ(s.numerics.integrator, Integrator::newmark);
  const auto property = [&](int region) {
    return s.properties[static_cast<std::size_t>(s.regions[static_cast<std::size_t>(region)].joint)];
  };
  EXPECT_EQ(property(0).bond, BondKind::spring);
  EXPECT_EQ(property(0).stiffness_kind, StiffnessKind::per_contact);
  EXPECT_EQ(property(0).stiffness, 40e9);
  EXPECT_EQ(property(1).stiffness, 40e8);
  EXPECT_EQ(property(2).bond, BondKind::exact);
  EXPECT_EQ(property(2).stiffness, 90e9);
  EXPECT_EQ(s.regions[0].joint, s.regions[3].joint);
  EXPECT_EQ(s.properties[static_cast<std::size_t>(s.contact)].stiffness, 40e8);  // between regions: the softest
}

TEST_F(Schema, ReferencePageIsUpToDate) {
  const std::string path = LuaState().library() + "/../docs/scene_reference.md";
  std::stringstream committed;
  committed << std::ifstream(path).rdbuf();
  EXPECT_EQ(committed.str(), scene_reference()) << "run: build/talus --reference > docs/scene_reference.md";
}

TEST_F(Schema, EditorAnnotationsAreUpToDateAndLua) {
  const LuaState state;
  const std::string path = state.library() + "/meta/talus.lua";
  std::stringstream committed;
  committed << std::ifstream(path).rdbuf();
  EXPECT_EQ(committed.str(), editor_annotations()) << "run: build/talus --annotations > lib/meta/talus.lua";
  EXPECT_EQ(luaL_loadfilex(state.get(), path.c_str(), "t"), LUA_OK);
  protected_call(state.get(), 0, 1);
  lua_getfield(state.get(), -1, "material");
  EXPECT_TRUE(lua_isfunction(state.get(), -1));
}

}  // namespace
}  // namespace talus
