#pragma once
// What was asked, as plain structs: no Lua, no CGAL, no numerics. `build` turns it into a Model and a Plan.
// SI units, 1 m thickness, angles in radians, x to the right, y up, counter-clockwise positive,
// tension positive. Indices refer to the vectors of Scene.
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vec2.h"
#include "scene/error.h"
#include "scene/history_law.h"
#include "scene/strength.h"

namespace talus {

enum class Plane { stress, strain };
enum class BlockOrder { rigid = 0, first = 1, second = 2 };  // 3, 6 and 12 unknowns
enum class BondKind { exact, spring };                       // Nitsche; springs at the edge's ends (the paper)
enum class StiffnessKind { per_length, per_area, per_contact };

struct Material {
  Place place;
  std::string name;
  double density = 0;  // kg/m3
  double young = 0;    // Pa
  double poisson = 0;  // [0, 0.5)
  Plane plane = Plane::stress;
};

// Properties of an interface: of artificial joints (bonds) and of contacts.
struct JointProperty {
  Place place;
  std::string name;
  double friction = 0;  // angle, rad, [0, pi/2)
  double cohesion = 0;  // Pa
  double tension = 0;   // Pa
  BondKind bond = BondKind::exact;
  double penalty = 1.1;  // exact bonds: multiple (> 1) of the stiffness that is provably positive definite
  StiffnessKind stiffness_kind = StiffnessKind::per_length;
  // contacts and spring bonds. per_length: alpha in alpha E/h; per_area: Pa/m; per_contact: N/m
  double stiffness = 100;
  double shear_ratio = 0.4;    // shear stiffness / normal stiffness of contacts and spring bonds
  double restitution = 1;      // the most of the speed at which faces met with which they part
  bool breaks = false;         // its bonds have a strength: the three above; without one they hold for ever
  Strength residual;           // of a failed bond, where there is no `reduction`
  FailureCriterion criterion;  // empty: Mohr–Coulomb with tension cut-off
  ReductionLaw reduction;      // empty: at once to `residual`
  // m/Pa, of `reduction` where it softens: opening over tension lost, at its steepest; else 0
  double softening_compliance = 0;
  double shear_compliance = 0;  // m/Pa, likewise slip over cohesion lost, where G_II is given; else 0
  double weibull = 0;           // modulus of the bonds' scattered strength; 0: all alike
  unsigned seed = 1;            // of the scatter

  Strength strength() const { return {friction, cohesion, tension}; }
};

// A straight or bent joint trace that cuts its region. Where two blocks meet on it they touch by contact
// (bonded = false: a real joint) or are glued with the strength of `property` (bonded = true).
struct Trace {
  Place place;
  Polyline points;  // two or more
  int property = -1;
  bool bonded = false;
  bool drawn = false;  // from a file: some of many may lie outside or end in the rock
};

// Parallel joints. Turned into traces by geometry/joint_set, clipped to the region's bounding box.
struct JointSet {
  Place place;
  double dip = 0;                   // rad, angle of the joints against +x, counter-clockwise
  double spacing = 0;               // m, > 0, normal distance between joints
  double persistence = 1;           // (0, 1], jointed part of a line's length
  double trace_length = 0;          // m, length of one jointed part when persistence < 1
  double trace_length_scatter = 0;  // [0, 1), uniform relative scatter of trace_length
  double gap_scatter = 0;           // [0, 1), of the bridge's length trace_length·(1/persistence - 1)
  double spacing_scatter = 0;       // [0, 1), uniform relative scatter of the spacing
  double dip_scatter = 0;           // rad, uniform scatter of the dip
  std::optional<Vec2> through;      // a point on one of the joints; else the centre of the region's box
  unsigned seed = 1;
  int property = -1;
  bool bonded = false;
};

// given: the outlines are its cells
enum class MeshKind { none, triangles, voronoi, cross, diagonal, alternating, given };
struct Mesh {
  Place place;
  MeshKind kind = MeshKind::none;
  double size = 0;                      // m, wanted edge length (triangles; patterns when nx, ny are 0), of grains
                                        // the square root of the mean area (voronoi)
  std::function<double(Vec2)> size_at;  // optional size field, m, > 0
  int nx = 0, ny = 0;                   // rectangles along x and y (patterns)
  unsigned seed = 1;                    // voronoi
};

// What becomes of blocks and edges that a cut leaves too small.
enum class Slivers { merge, refuse, keep };

struct Hole {
  Place place;
  std::string name;
  Polyline outline;  // counter-clockwise
};

// value(x) = value + gradient_x * x + gradient_y * y, for (sxx, syy, sxy), Pa, tension positive.
struct StressField {
  Eigen::Vector3d value = Eigen::Vector3d::Zero(), gradient_x = Eigen::Vector3d::Zero(),
                  gradient_y = Eigen::Vector3d::Zero();
};

struct Region {
  Place place;
  std::string name;
  std::vector<Polyline> outlines;  // one for a region that is cut or meshed; several for a set of ready blocks
  std::vector<Hole> holes;
  int material = -1;
  int joint = -1;  // property of its bonds and of contacts among its own blocks; -1: Scene::contact
  BlockOrder order = BlockOrder::first;
  std::function<BlockOrder(Vec2)> order_at;  // optional, of each block by its centroid
  bool held = false;                         // wholly fixed: no unknowns; moves only by a prescribed motion
  Mesh mesh;
  std::vector<Trace> traces;
  std::vector<JointSet> joint_sets;
  Slivers slivers = Slivers::merge;
  double sliver_part = 0.02;     // of the wanted or mean block size: thickness below which a block is a sliver
  Vec2 velocity = Vec2::Zero();  // m/s, initial
  double spin = 0;               // rad/s, initial, about `spin_centre` or the region's centroid
  std::optional<Vec2> spin_centre;
  std::optional<StressField> stress;  // initial
  std::array<History, 2> body_force;  // N/m3, beside gravity
};

// Which boundary a fixity or load acts on: everything of the region, its point nearest to `from` (where
// kind = point), or the boundary edges that lie on the segment from–to.
struct On {
  enum Kind { region, point, line } kind = region;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

struct Fixity {
  Place place;
  std::string name;
  int region = -1;
  On on;
  std::array<bool, 2> held = {true, true};  // x, y (global directions)
  enum Motion { none, displacement, velocity } motion = none;
  std::array<History, 2> value;  // m or m/s
  double spin = 0;               // rad/s, about the centroid: only for On::region

  double since = 0;          // s; a motion by velocity goes on from there,
  Vec2 gone = Vec2::Zero();  // m, where it was

  Vec2 moved(double t) const {  // m, since the start, as it asks for; of a region its centroid
    if (motion == none || t <= 0) return Vec2::Zero();
    if (motion == displacement) return {value[0].at(t), value[1].at(t)};
    return gone + Vec2(value[0].integral(since, t), value[1].integral(since, t));
  }
  // m/s, as a step of `span` s ends at t: by the last of it, so that what jumps then has not jumped yet.
  Vec2 speed(double t, double span) const {
    if (motion == none || span == 0) return Vec2::Zero();
    const double last = span / 64;
    if (motion == velocity) return {value[0].at(t - last), value[1].at(t - last)};
    return (moved(t) - moved(t - last)) / last;
  }
  void go_on(double t) {  // after a step
    if (motion != velocity || (!value[0].is_function() && !value[1].is_function())) return;
    gone = moved(t);
    since = t;
  }
};

struct PointLoad {
  Place place;
  std::string name;
  Vec2 at = Vec2::Zero();        // initial position of the loaded material point
  int region = -1;               // -1: whichever region holds the point
  std::array<History, 2> force;  // N per m thickness
};

struct EdgeLoad {
  Place place;
  std::string name;
  int region = -1;
  On on;  // line only
  bool is_pressure = false;
  std::array<History, 2> traction;  // Pa (global); pressure in [0], positive towards the rock, follows the edge
};

// Edges that absorb waves; held in equilibrium.
struct ViscousBoundary {
  Place place;
  int region = -1;
  On on;  // line only
};

// What the laws of explosion gas may ask of a chamber, as it was after the step before.
struct GasMoment {
  double t = 0;  // s, since the charge went off; for venting since the gas reached a free surface
  double volume = 0, first_volume = 0;  // m3 per metre; of the hole when the charge went off
  double pressure = 0;                  // Pa
  double front = 0;                     // m, from the hole's centre
};

// Pressure of explosion gas by its volume over the volume it had at first, v >= 1, and the energy it gives.
struct GasLaw {
  std::function<double(double v, const GasMoment&)> pressure;  // Pa, falling with v
  // J per m3 of the first volume, ∫ P dv; empty: by quadrature
  std::function<double(double from, double to)> work;
  std::vector<double> constants;  // that it is made of; empty: a function of the script
};

// Gas leaves a chamber through what is open at the free surfaces it has reached (gas/orifice.h).
struct Orifice {
  double coefficient = 1;         // of discharge
  double gamma = 1.4;             // of the gas as it leaves
  double density = 0;             // kg/m3, of the gas in the hole when the charge goes off
  double atmosphere = 0;          // Pa, at which it ends
  std::optional<double> opening;  // m (m2 per metre); none: the apertures of the joints that end there
};

// What closes the collar of a hole until the gas has thrown it out (gas/gas_ways.cpp).
struct Stemming {
  double length = 0;         // m
  double density = 0;        // kg/m3
  double charge_length = 0;  // m, of the loaded part of the hole; 0: not given
};

// An explosive in a hole of a region.
struct Charge {
  Place place;
  std::string name;
  int region = -1, hole = -1;  // index into Region::holes
  double delay = 0;            // s, scatter included
  double mass = 0;             // kg per metre; 0: the gas is given, not the explosive
  GasLaw law;
  // Of a law that is a function: throws where its pressure grows from one v to a larger one, whichever comes first.
  // Empty else.
  std::function<void(double v, double other, const GasMoment&)> check_fall;
  std::function<double(const GasMoment&)> gas_speed;  // m/s into cracks
  std::optional<double> constant_speed;               // m/s, what gas_speed is; none: a function of the script
  // Part of the pressure left after the gas has reached a free surface. Neither: none, at once.
  std::function<double(const GasMoment&)> venting;
  std::optional<Orifice> orifice;
  std::optional<Stemming> stemming;  // none: the collar stays closed
};

struct Probe {
  Place place;
  std::string name;
  Vec2 at = Vec2::Zero();
  int region = -1;
};

struct ContactRule {
  Place place;
  int region_a = -1, region_b = -1, property = -1;
};

enum class Mode { static_, dynamic };
enum class Integrator { theta, newmark };

struct TimeControl {
  Place place;
  Mode mode = Mode::dynamic;
  double t_end = 0;   // s; static: the load histories run from 0 to t_end
  int steps = 1;      // static: load steps between 0 and t_end
  double dt = 0;      // s; 0: automatic from displacement_ratio
  double dt_min = 0;  // s; 0: 1e-6 of the first step
  double dt_max = 0;  // s; 0: no bound but t_end/10
  // of the fastest motion, what errors of steps may add up to over the run; 0: not looked at
  double tolerance = 0;
  double displacement_ratio = 0.005;  // largest displacement a step / Model::extent (step/motion_past.h)
  bool settled_start = false;  // dynamic: begin from static equilibrium, with joints that do not slide where friction
                               // cannot hold
  long max_steps = 0;          // 0: no bound
};

// How the contacts of an island are solved in motion; see OpenClose.
enum class ContactSolver { automatic, factor, sweeps, splitting };

struct Numerics {
  std::string profile = "default";
  Integrator integrator = Integrator::theta;
  double theta = 0.75;           // [0.5, 1]
  double dynamic_parameter = 1;  // [0, 1], part of the velocity a step inherits (newmark)
  // Part of its velocity that a block of this speed (m/s) keeps after a step (s), [0, 1]; empty: all of it.
  std::function<double(double speed, double dt)> damping;
  double contact_tolerance = 1e-8;  // contact residual / force scale of a block
  double static_tolerance = 1e-8;   // out-of-balance force / force scale
  int max_iterations = 60;          // open–close iterations before the step is cut
  int threads = 1;
  bool islands = true;    // what does not touch is solved apart
  bool sleeping = false;  // islands at rest are left out of the step until something comes near
  ContactSolver solver = ContactSolver::automatic;
  bool recovery = true;  // smoothed stress for output and probes beside the raw block stress
};

enum class FailureOrder { critical, all, one };
// automatic: tracked where bonds stand for a continuum (fracture/crack_tracking.h).
enum class CrackPath { automatic, mesh, tracked };

// Which of the bonds that have reached their strength fail at once, before the others are judged anew.
struct FractureControl {
  FailureOrder order = FailureOrder::critical;  // the most critical and those within `band` of it
  double band = 0.05;                           // part of the highest utilisation
  double overshoot = 0.01;  // static: part by which an increment of load may pass the strength of the first bond
  CrackPath path = CrackPath::automatic;
};

struct Output {
  Place place;
  std::string dir;   // empty: write nothing
  double every = 0;  // s between output times; 0: first and last only
  bool vtk = true;
  bool error = false;  // the estimated error of stress, into VTK and run.json
  bool picture = true;
  std::string picture_field = "s1";  // any block field
  double picture_scale = 0;          // displacement magnification; 0: 1
  // user arrays: name -> function(block id) -> value; evaluated at output times
  std::vector<std::pair<std::string, std::function<double(int)>>> fields;
  std::function<void()> on_frame;  // called after an output time was written; may be empty
};

struct Scene {
  std::string title, file;
  Vec2 gravity = Vec2::Zero();
  std::vector<Material> materials;
  std::vector<JointProperty> properties;
  std::vector<Region> regions;
  int contact = -1;  // property of contacts between regions; -1: JointProperty with friction 30 deg
  std::vector<ContactRule> contact_rules;
  std::vector<Fixity> fixities;
  std::vector<PointLoad> point_loads;
  std::vector<EdgeLoad> edge_loads;
  std::vector<ViscousBoundary> viscous_boundaries;
  std::vector<Charge> charges;
  std::vector<Probe> probes;
  TimeControl time;
  Numerics numerics;
  FractureControl fracture;
  Output output;
  long max_blocks = 200000;  // a mesh that would give more is refused with its estimate
};

}  // namespace talus
