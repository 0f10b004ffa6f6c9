#include "script/scene_reader.h"

#include <cmath>
#include <stdexcept>

#include "script/failure_laws.h"
#include "script/gas_laws.h"
#include "script/laws.h"
#include "script/size_grade.h"

namespace talus {
namespace {

// Words of the Lua face for the values of an enum.
template <class E>
void read_enum(const TableReader& t, const char* key, std::initializer_list<std::pair<const char*, E>> words,
               E& value) {
  std::string word;
  t.read(key, word);
  if (word.empty()) return;
  for (const auto& [name, meaning] : words) {
    if (word == name) {
      value = meaning;
      return;
    }
  }
  throw std::logic_error("scene table: " + std::string(key) + " is no known word: " + word);
}

template <class T>
void read_head(const TableReader& t, T& entry) {
  t.read("place", entry.place);
  if constexpr (requires { entry.name; }) t.read("name", entry.name);
}

// A number, a list of {t, value} or a function, on the top of the stack.
History history_on_top(lua_State* L, const Place& place, const std::string& label) {
  if (lua_isfunction(L, -1)) return History(history_law(LuaFunction(L, -1), place, label));
  if (!lua_istable(L, -1)) return History(lua_tonumber(L, -1));
  std::vector<std::pair<double, double>> rows(lua_rawlen(L, -1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    lua_rawgeti(L, -1, static_cast<lua_Integer>(i + 1));
    lua_rawgeti(L, -1, 1);
    lua_rawgeti(L, -2, 2);
    rows[i] = {lua_tonumber(L, -2), lua_tonumber(L, -1)};
    lua_pop(L, 3);
  }
  return History(std::move(rows));
}

void read_histories(const TableReader& t, const char* key, const Place& place, const std::string& kind,
                    std::array<History, 2>& value) {
  if (!t.push(key)) return;
  lua_State* L = t.state();
  for (int i = 0; i < 2; ++i) {
    lua_rawgeti(L, -1, i + 1);
    value[i] = history_on_top(L, place, kind + "." + key + "[" + std::to_string(i + 1) + "]");
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
}

void read_on(const TableReader& t, On& on) {
  t.with("on", [&](const TableReader& o) {
    read_enum(o, "kind", {{"region", On::region}, {"point", On::point}, {"line", On::line}}, on.kind);
    o.read("from", on.from);
    o.read("to", on.to);
  });
}

Material read_material(const TableReader& t) {
  Material m;
  read_head(t, m);
  t.read("density", m.density);
  t.read("young", m.young);
  t.read("poisson", m.poisson);
  read_enum(t, "plane", {{"stress", Plane::stress}, {"strain", Plane::strain}}, m.plane);
  return m;
}

JointProperty read_property(const TableReader& t) {
  JointProperty p;
  read_head(t, p);
  t.read("friction", p.friction);
  t.read("cohesion", p.cohesion);
  t.read("tension", p.tension);
  read_enum(t, "bond", {{"exact", BondKind::exact}, {"spring", BondKind::spring}}, p.bond);
  t.read("penalty", p.penalty);
  read_enum(t, "stiffness_kind",
            {{"length", StiffnessKind::per_length},
             {"area", StiffnessKind::per_area},
             {"contact", StiffnessKind::per_contact}},
            p.stiffness_kind);
  t.read("stiffness", p.stiffness);
  t.read("shear_ratio", p.shear_ratio);
  t.read("restitution", p.restitution);
  t.read("breaks", p.breaks);
  p.residual.friction = p.friction;
  t.read("residual_friction", p.residual.friction);
  t.read("residual_cohesion", p.residual.cohesion);
  t.read("residual_tension", p.residual.tension);
  t.read("weibull", p.weibull);
  t.read("seed", p.seed);
  read_failure_laws(t, p);
  // Contacts carry no tension: what is left of it is for bridges, which have it from a law.
  if (!p.reduction && p.residual.tension > 0)
    p.reduction = [left = p.residual](const Strength&, const JointWear&) { return left; };
  return p;
}

Trace read_trace(const TableReader& t) {
  Trace trace;
  read_head(t, trace);
  t.read("points", trace.points);
  t.read_index("property", trace.property);
  t.read("bonded", trace.bonded);
  t.read("drawn", trace.drawn);
  return trace;
}

JointSet read_joint_set(const TableReader& t) {
  JointSet set;
  read_head(t, set);
  t.read("dip", set.dip);
  t.read("spacing", set.spacing);
  t.read("persistence", set.persistence);
  t.read("trace_length", set.trace_length);
  t.read("trace_length_scatter", set.trace_length_scatter);
  t.read("gap_scatter", set.gap_scatter);
  t.read("spacing_scatter", set.spacing_scatter);
  t.read("dip_scatter", set.dip_scatter);
  t.read("through", set.through);
  t.read("seed", set.seed);
  t.read_index("property", set.property);
  t.read("bonded", set.bonded);
  return set;
}

Mesh read_mesh(const TableReader& t, const std::vector<Hole>& holes) {
  Mesh mesh;
  read_head(t, mesh);
  read_enum(t, "kind",
            {{"triangles", MeshKind::triangles},
             {"voronoi", MeshKind::voronoi},
             {"cross", MeshKind::cross},
             {"diagonal", MeshKind::diagonal},
             {"alternating", MeshKind::alternating},
             {"given", MeshKind::given}},
            mesh.kind);
  t.read("nx", mesh.nx);
  t.read("ny", mesh.ny);
  t.read("size", mesh.size);
  t.read("seed", mesh.seed);
  if (t.push("size_law")) {
    mesh.size_at = size_law(LuaFunction(t.state(), -1), mesh.place, "region.mesh.size");
    lua_pop(t.state(), 1);
  }
  t.with("grade", [&](const TableReader& grade) { mesh.size_at = read_grade(grade, holes); });
  return mesh;
}

Region read_region(const TableReader& t) {
  Region r;
  read_head(t, r);
  t.read("outlines", r.outlines);
  t.each("holes", [&](const TableReader& h) {
    Hole& hole = r.holes.emplace_back();
    read_head(h, hole);
    h.read("outline", hole.outline);
  });
  t.read_index("material", r.material);
  t.read_index("joint", r.joint);
  read_enum(t, "order", {{"rigid", BlockOrder::rigid}, {"first", BlockOrder::first}, {"second", BlockOrder::second}},
            r.order);
  if (t.push("order_law")) {
    const auto choice = choice_law(LuaFunction(t.state(), -1), r.place, "region.order", {"1", "2", "\"rigid\""});
    r.order_at = [choice](Vec2 p) {
      return std::array{BlockOrder::first, BlockOrder::second, BlockOrder::rigid}[size_t(choice(p))];
    };
    lua_pop(t.state(), 1);
  }
  t.read("held", r.held);
  t.with("mesh", [&](const TableReader& m) { r.mesh = read_mesh(m, r.holes); });
  t.each("traces", [&](const TableReader& e) { r.traces.push_back(read_trace(e)); });
  t.each("joint_sets", [&](const TableReader& e) { r.joint_sets.push_back(read_joint_set(e)); });
  read_enum(t, "slivers", {{"merge", Slivers::merge}, {"refuse", Slivers::refuse}, {"keep", Slivers::keep}}, r.slivers);
  t.read("sliver_part", r.sliver_part);
  t.read("velocity", r.velocity);
  t.read("spin", r.spin);
  t.read("spin_centre", r.spin_centre);
  t.with("stress", [&](const TableReader& s) {
    StressField& stress = r.stress.emplace();
    s.read("value", stress.value);
    s.read("gradient_x", stress.gradient_x);
    s.read("gradient_y", stress.gradient_y);
  });
  read_histories(t, "body_force", r.place, "region", r.body_force);
  return r;
}

Fixity read_fixity(const TableReader& t) {
  Fixity f;
  read_head(t, f);
  t.read_index("region", f.region);
  read_on(t, f.on);
  t.read("x", f.held[0]);
  t.read("y", f.held[1]);
  if (t.has("displacement")) f.motion = Fixity::displacement;
  if (t.has("velocity")) f.motion = Fixity::velocity;
  read_histories(t, "displacement", f.place, "fix", f.value);
  read_histories(t, "velocity", f.place, "fix", f.value);
  t.read("spin", f.spin);
  return f;
}

PointLoad read_point_load(const TableReader& t) {
  PointLoad l;
  read_head(t, l);
  t.read("at", l.at);
  t.read_index("region", l.region);
  read_histories(t, "force", l.place, "point_load", l.force);
  return l;
}

EdgeLoad read_edge_load(const TableReader& t) {
  EdgeLoad l;
  read_head(t, l);
  t.read_index("region", l.region);
  read_on(t, l.on);
  read_histories(t, "traction", l.place, "edge_load", l.traction);
  if (t.push("pressure")) {
    l.is_pressure = true;
    l.traction[0] = history_on_top(t.state(), l.place, "pressure.value");
    lua_pop(t.state(), 1);
  }
  return l;
}

ViscousBoundary read_viscous(const TableReader& t) {
  ViscousBoundary v;
  read_head(t, v);
  t.read_index("region", v.region);
  read_on(t, v.on);
  return v;
}

TimeControl read_time(const TableReader& t) {
  TimeControl c;
  read_head(t, c);
  read_enum(t, "mode", {{"static", Mode::static_}, {"dynamic", Mode::dynamic}}, c.mode);
  t.read("t_end", c.t_end);
  t.read("steps", c.steps);
  t.read("dt", c.dt);
  t.read("dt_min", c.dt_min);
  t.read("dt_max", c.dt_max);
  t.read("tolerance", c.tolerance);
  t.read("displacement_ratio", c.displacement_ratio);
  t.read("settled_start", c.settled_start);
  t.read("max_steps", c.max_steps);
  return c;
}

void read_damping(const TableReader& t, Numerics& numerics) {
  Place place;
  t.read("place", place);
  if (t.push("damping")) {
    numerics.damping = damping_law(LuaFunction(t.state(), -1), place);
    lua_pop(t.state(), 1);
  }
  if (double rate = 0; t.has("damping_rate")) {
    t.read("damping_rate", rate);
    numerics.damping = [rate](double, double dt) { return std::exp(-rate * dt); };
  }
}

Numerics read_numerics(const TableReader& t) {
  Numerics n;
  t.read("profile", n.profile);
  read_enum(t, "integrator", {{"theta", Integrator::theta}, {"newmark", Integrator::newmark}}, n.integrator);
  t.read("theta", n.theta);
  t.read("dynamic_parameter", n.dynamic_parameter);
  read_damping(t, n);
  t.read("contact_tolerance", n.contact_tolerance);
  t.read("static_tolerance", n.static_tolerance);
  t.read("max_iterations", n.max_iterations);
  t.read("threads", n.threads);
  t.read("islands", n.islands);
  t.read("sleeping", n.sleeping);
  read_enum(t, "solver",
            {{"auto", ContactSolver::automatic},
             {"factor", ContactSolver::factor},
             {"sweeps", ContactSolver::sweeps},
             {"splitting", ContactSolver::splitting}},
            n.solver);
  t.read("recovery", n.recovery);
  return n;
}

Output read_output(const TableReader& t) {
  Output o;
  read_head(t, o);
  t.read("dir", o.dir);
  t.read("every", o.every);
  t.read("vtk", o.vtk);
  t.read("error", o.error);
  t.read("picture", o.picture);
  t.read("picture_field", o.picture_field);
  t.read("picture_scale", o.picture_scale);
  return o;
}

}  // namespace

Scene read_scene(const TableReader& t) {
  Scene s;
  t.read("title", s.title);
  t.read("file", s.file);
  t.read("gravity", s.gravity);
  t.read("max_blocks", s.max_blocks);
  t.each("materials", [&](const TableReader& e) { s.materials.push_back(read_material(e)); });
  t.each("properties", [&](const TableReader& e) { s.properties.push_back(read_property(e)); });
  t.each("regions", [&](const TableReader& e) { s.regions.push_back(read_region(e)); });
  t.read_index("contact", s.contact);
  t.each("contact_rules", [&](const TableReader& e) {
    ContactRule& rule = s.contact_rules.emplace_back();
    read_head(e, rule);
    e.read_index("region_a", rule.region_a);
    e.read_index("region_b", rule.region_b);
    e.read_index("property", rule.property);
  });
  t.each("fixities", [&](const TableReader& e) { s.fixities.push_back(read_fixity(e)); });
  t.each("point_loads", [&](const TableReader& e) { s.point_loads.push_back(read_point_load(e)); });
  t.each("edge_loads", [&](const TableReader& e) { s.edge_loads.push_back(read_edge_load(e)); });
  t.each("viscous", [&](const TableReader& e) { s.viscous_boundaries.push_back(read_viscous(e)); });
  t.each("charges", [&](const TableReader& e) { s.charges.push_back(read_charge(e)); });
  t.each("probes", [&](const TableReader& e) {
    Probe& probe = s.probes.emplace_back();
    read_head(e, probe);
    e.read("at", probe.at);
    e.read_index("region", probe.region);
  });
  t.with("time", [&](const TableReader& e) { s.time = read_time(e); });
  t.with("numerics", [&](const TableReader& e) { s.numerics = read_numerics(e); });
  t.with("fracture", [&](const TableReader& e) {
    read_enum(e, "order",
              {{"critical", FailureOrder::critical}, {"all", FailureOrder::all}, {"one", FailureOrder::one}},
              s.fracture.order);
    e.read("band", s.fracture.band);
    e.read("overshoot", s.fracture.overshoot);
    read_enum(e, "path", {{"mesh", CrackPath::mesh}, {"tracked", CrackPath::tracked}}, s.fracture.path);
  });
  t.with("output", [&](const TableReader& e) { s.output = read_output(e); });
  return s;
}

namespace {

void come_from(const std::array<History, 2>& before, std::array<History, 2>& now, double time, double until) {
  if (until <= time) return;
  for (const size_t k : {0, 1}) now[k].come_from(before[k].at(time), time, until);
}

}  // namespace

void update_scene(Scene& scene, const std::string& list, int index, const TableReader& entry, double time,
                  double until) {
  const auto i = static_cast<std::size_t>(index);
  if (list == "materials") {
    scene.materials.at(i) = read_material(entry);
  } else if (list == "properties") {
    scene.properties.at(i) = read_property(entry);
  } else if (list == "fixities") {
    Fixity changed = read_fixity(entry);
    changed.gone = scene.fixities.at(i).moved(time);
    changed.since = time;
    if (changed.motion == Fixity::displacement)
      come_from({changed.gone.x(), changed.gone.y()}, changed.value, time, until);
    scene.fixities.at(i) = std::move(changed);
  } else if (list == "point_loads") {
    PointLoad changed = read_point_load(entry);
    come_from(scene.point_loads.at(i).force, changed.force, time, until);
    scene.point_loads.at(i) = std::move(changed);
  } else if (list == "edge_loads") {
    EdgeLoad changed = read_edge_load(entry);
    come_from(scene.edge_loads.at(i).traction, changed.traction, time, until);
    scene.edge_loads.at(i) = std::move(changed);
  } else {
    throw std::logic_error("scene table: no list " + list);
  }
}

}  // namespace talus
