#pragma once
// Scenes for build(): one rock, one joint property, regions by outline. Units are small round numbers.
#include "hand_model.h"
#include "scene/build.h"
#include "scene/scene.h"

namespace talus::test {

inline Region region(const std::string& name, const Polyline& outline) {
  Region r;
  r.name = name;
  r.outlines = {outline};
  r.material = 0;
  r.joint = 0;
  return r;
}

inline Region meshed(const std::string& name, const Polyline& outline, double size) {
  Region r = region(name, outline);
  r.mesh.kind = MeshKind::triangles;
  r.mesh.size = size;
  return r;
}

inline Region patterned(const std::string& name, const Polyline& outline, MeshKind kind, int nx, int ny) {
  Region r = region(name, outline);
  r.mesh.kind = kind;
  r.mesh.nx = nx;
  r.mesh.ny = ny;
  return r;
}

// E = 1000 Pa, ν = 0.25, plane stress, ρ = 2 kg/m3; static.
inline Scene scene_of(const std::vector<Region>& regions) {
  Scene scene;
  Material rock;
  rock.name = "rock";
  rock.density = 2;
  rock.young = 1000;
  rock.poisson = 0.25;
  scene.materials = {rock};
  JointProperty bond;
  bond.name = "bond";
  bond.friction = 0.6;
  scene.properties = {bond};
  scene.regions = regions;
  scene.time.mode = Mode::static_;
  scene.time.t_end = 1;
  scene.output.vtk = scene.output.picture = false;
  return scene;
}

inline On on_line(const Vec2& from, const Vec2& to) {
  return {On::line, from, to};
}
inline On on_point(const Vec2& at) {
  return {On::point, at, at};
}

inline Fixity fix(int region, const On& on, bool x = true, bool y = true) {
  Fixity fixity;
  fixity.region = region;
  fixity.on = on;
  fixity.held = {x, y};
  return fixity;
}

inline EdgeLoad traction(int region, const On& on, const Vec2& value) {
  EdgeLoad load;
  load.region = region;
  load.on = on;
  load.traction = {History(value.x()), History(value.y())};
  return load;
}

// A plate of odd shape with a hole, in some hundred triangles; bonds of the given penalty.
inline Scene irregular(double penalty = 1.1) {
  Region plate = meshed("plate", {{0, 0}, {3, 0.2}, {2.6, 2}, {0.4, 1.7}}, 0.4);
  plate.holes.resize(1);
  plate.holes[0].outline = {{1.2, 0.7}, {1.7, 0.8}, {1.5, 1.3}};
  Scene scene = scene_of({plate});
  scene.properties[0].penalty = penalty;
  return scene;
}

}  // namespace talus::test
