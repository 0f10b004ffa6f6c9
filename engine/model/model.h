#pragma once
// The tables a run works on. Dense ids never change; one meaning an array, all run long.
// Lengths in metres from Model::origin, forces in N per metre of thickness, stresses in Pa (tension positive).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/vec2.h"
#include "model/apart.h"
#include "model/bend.h"
#include "model/curved_edge.h"
#include "scene/scene.h"

namespace talus {

using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

// Unknowns of a block, all in metres: translation of the centroid (x, y; global axes), then l·rotation, for first-order
// blocks l·(εx, εy, γxy) in the block's own turning axes, and for second-order ones the six of model/bend.h. l is the
// block's length √area.
constexpr int rigid_dofs = 3, first_order_dofs = 6, second_order_dofs = 12;
constexpr int max_dofs = second_order_dofs;
// Columns, matrices and rows (displacement under unit unknowns) are of one of two fixed sizes, that of first order for
// all that is no second-order block: what a scene has none of costs it nothing.
template <int n>
using ColumnOf = Eigen::Matrix<double, n, 1>;
template <int n>
using MatrixOf = Eigen::Matrix<double, n, n>;
template <int n>
using RowsOf = Eigen::Matrix<double, 2, n>;
using DofColumn = ColumnOf<first_order_dofs>;
using DofMatrix = MatrixOf<first_order_dofs>;
using DofRows = RowsOf<first_order_dofs>;

// f(n) with n the fixed size that serves blocks of so many unknowns.
template <class F>
decltype(auto) with_size(bool second_order, F&& f) {
  return second_order ? f(std::integral_constant<int, second_order_dofs>())
                      : f(std::integral_constant<int, first_order_dofs>());
}

struct Rotation {
  double c = 1, s = 0;
  static Rotation of(double angle) { return {std::cos(angle), std::sin(angle)}; }
  double c1() const { return c > 0 ? -s * s / (1 + c) : c - 1; }  // c - 1, without cancellation
  Vec2 turn(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
  Vec2 back(const Vec2& v) const { return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()}; }
};

// Of a block's unknowns, m/s: six, though a rigid block has three, or a second-order one's twelve.
class Rates {
 public:
  std::size_t size() const { return all_ ? all_->size() : first_.size(); }
  double* data() { return all_ ? all_->data() : first_.data(); }
  const double* data() const { return all_ ? all_->data() : first_.data(); }
  double* begin() { return data(); }
  double* end() { return data() + size(); }
  const double* begin() const { return data(); }
  const double* end() const { return data() + size(); }
  double& operator[](std::size_t k) { return data()[k]; }
  const double& operator[](std::size_t k) const { return data()[k]; }
  void make_second_order() { all_.make() = {}; }
  Rates& operator=(std::initializer_list<double> first) {  // and noughts
    std::ranges::fill(std::copy(first.begin(), first.end(), begin()), end(), 0.0);
    return *this;
  }
  template <int n>
  ColumnOf<n> column() const {  // of which a block with fewer has noughts
    ColumnOf<n> column = ColumnOf<n>::Zero();
    std::copy_n(data(), std::min<std::size_t>(n, size()), column.data());
    return column;
  }
  friend bool operator==(const Rates& a, const Rates& b) { return std::ranges::equal(a, b); }

 private:
  std::array<double, first_order_dofs> first_{};
  Apart<std::array<double, second_order_dofs>> all_;
};

// Where a block is: what a step changes and a snapshot keeps. Of many blocks in flight a step takes the time that it
// takes to fetch these: they are in the order of what is asked for together, with nothing between that most have not.
struct BlockState {
  Vec2 centroid = Vec2::Zero();  // m, reference centroid + shift
  double angle = 0;              // rad, since the start
  // εx, εy, γxy in the block's axes, since the start; of second order at the centroid
  Vec3 strain = Vec3::Zero();
  Vec2 shift = Vec2::Zero();  // m, of the centroid since the start: kept apart from the place, so that a
                              // joint's jump is a difference of displacements and keeps its digits
  Rates velocity;
  Apart<BendArray> bend;  // m, of second-order blocks: model/bend.h
};

// What a block is: constant after build. Its order is that of what is asked for together, on two lines of the caches.
struct alignas(64) BlockShape {
  int dofs = 0;  // 0 held, 3 rigid, 6 first order, 12 second order
  int dof_begin = 0;
  int vertex_begin = 0, vertex_end = 0;  // into Model::vertex, reference_vertex
  int region = 0, material = 0;
  int quadratic = -1;   // of a second-order block: into Model::quadratic_shapes
  bool bonded = false;  // to others when it was built
  double length = 0;    // m, √area: scale of unknowns and of contact stiffness
  double radius = 0;    // m, farthest vertex from the centroid
  Vec2 reference_centroid = Vec2::Zero();
  double area = 0;                     // m2, reference
  double xx = 0, yy = 0, xy = 0;       // second moments about the centroid, reference axes, m4
  Vec3 initial_stress = Vec3::Zero();  // sxx, syy, sxy in the block's axes; of second order at the centroid

  bool second_order() const { return dofs == second_order_dofs; }
  // rad, of a block whose spins at both ends of a step come to `mean` in it. A centroid that goes by the mean of its
  // velocities (trapezoidal rule) turns about another by this angle, Cayley's: so do bonded blocks, or each step would
  // tear at their bonds by a twelfth of the angle's cube.
  double turn(double mean) const { return bonded ? 2 * std::atan(mean / 2) : mean; }
  Bend bend() const { return {length, Vec3(xx, xy, yy) / (area * area)}; }
};

// What a second-order block is beside.
struct QuadraticShape {
  HighMoments moments;                                    // about the centroid, m5 and m6
  Vec3 stress_x = Vec3::Zero(), stress_y = Vec3::Zero();  // Pa/m, gradients of the initial stress
};

enum class JointState : std::uint8_t { intact, failed };
enum class FailureMode : std::uint8_t { none, tension, shear };
// Of a new crack: on its own, at the tip of one crack, between two.
enum class CrackKind : std::uint8_t { none, initiated, propagated, coalesced };

// Half a failed bond that still carries tension or cohesion while it opens or slides: traction over jump, in one
// direction. It goes up to its strength over `reach`, along a line; then down the law of the joint's property; back
// along a line.
struct Bridge {
  double origin = 0;    // m, jump without traction
  double reach = 0;     // m, jump beyond it at which the strength is reached, unworn
  double worn = 0;      // m, most jump beyond that
  double now = 0;       // m, jump beyond the origin; in motion of y = X + (θ-½)Δt v, where steps look at it
  double traction = 0;  // Pa
};

struct JointPoint {                // an integration point of a joint, and its state
  double at = 0, weight = 0;       // position 0–1 along the joint; m
  double normal = 0, shear = 0;    // traction, Pa (of the last accepted step)
  double opening = 0, slip = 0;    // m, jump in the joint's axes
  Bridge across = {}, along = {};  // of a failed bond that is bridged
};

// Two points, or three where a block beside is of second order.
class JointPoints {
 public:
  static constexpr int most = 3;
  void resize(std::size_t count) { count_ = count; }
  std::size_t size() const { return count_; }
  JointPoint& operator[](std::size_t k) { return points_[k]; }
  const JointPoint& operator[](std::size_t k) const { return points_[k]; }
  JointPoint* begin() { return points_.data(); }
  JointPoint* end() { return points_.data() + count_; }
  const JointPoint* begin() const { return points_.data(); }
  const JointPoint* end() const { return points_.data() + count_; }

 private:
  std::array<JointPoint, most> points_;
  std::size_t count_ = 2;
};

// A persistent interface between two blocks that share an edge: a bond, until it fails, or a real joint, which was
// never bonded. The edge runs from end 0 to end 1 with block a on its left; its normal points from a to b.
struct Joint {
  int a = 0, b = 0;
  int property = 0;
  int trace = -1;      // id of the joint trace of its region, or -1 for an artificial joint
  bool bonded = true;  // at the start
  JointState state = JointState::intact;
  FailureMode mode = FailureMode::none;
  CrackKind crack = CrackKind::none;
  double failed_at = 0;      // s
  BondTraction failed_with;  // Pa, by which it was judged: where the step would have led
  BondTraction left_with;    // Pa, as that step began, which what takes over from it goes on from
  double utilisation = 0;    // by its criterion, of the last accepted step; of a failed bond: when it failed
  double scatter = 1;        // of its strength, about that of its property
  Strength remaining;        // Pa; of what has failed
  double most_opening = 0, most_slip = 0;  // m, since it failed
  // m, reference, from its end away from the crack that it carries on to that crack's path: where paths are tracked.
  Vec2 off_path = Vec2::Zero();
  double path_turn = 0;  // rad, from its normal to that of the path
  bool bridged = false;  // failed, and its property's reduction leaves it more than the residual
  BondKind kind = BondKind::exact;
  double length = 0;               // m, reference
  Vec2 normal = Vec2::Zero();      // reference
  std::array<Vec2, 2> in_a, in_b;  // ends, from the blocks' reference centroids
  // the blocks' own edges, by local number: so many from these on, of b those that face them from the last on
  int edge_a = 0, edge_b = 0, sides = 1;
  // edge of the one block that faces this one of the other
  int facing(int edge) const { return edge_a + edge_b + sides - 1 - edge; }
  std::array<int, 2> node = {-1, -1};     // of its ends, into Model::nodes
  double weight_a = 0.5, weight_b = 0.5;  // shares of the two blocks in the flux {σ}n
  JointPoints points;
};

BondTraction mean_traction(const Joint& joint);  // over its points

enum class ContactState : std::uint8_t { open, stick, slip };
enum class ContactKind : std::uint8_t { angle_angle, angle_edge, edge_edge };

// A transient pair: vertex `vertex` of block `i` against edge `edge` of block `j` (ids local to the block).
struct Contact {
  int i = 0, vertex = 0, j = 0, edge = 0;
  ContactKind kind = ContactKind::angle_edge;
  ContactState state = ContactState::open;
  int property = 0;
  int joint = -1;     // that has failed or was never bonded and whose faces these are, or -1
  double length = 0;  // m, part of the interface it stands for
  double normal_stiffness = 0, shear_stiffness = 0;  // N/m
  double gap = 0;                                    // m, negative when pressed together
  // m, overlap at birth that is not counted as pressing; < 0: pressed by a bond before
  double offset = 0;
  // m, of the offset, by which the face that it has come on to lies higher: it climbs to that as it slides
  double height = 0;
  // of that climb, in the last step: as much of the normal force acts against the vertex's way along the edge
  double slope = 0;
  bool lies = false;  // at rest, where its gap is by rounding what its force says: then that is its gap
  // m, elastic part of the sliding: shear force / shear stiffness; until end_sliding() all of it
  double stretch = 0;
  double slip = 0;                           // m, plastic part, accumulated along the edge
  double slid = 0;                           // m, of it in the last step
  double normal_force = 0, shear_force = 0;  // N; normal positive when pressed together
  // m/s, the most at which what presses here may part, by its restitution; < 0: no bound yet
  double may_part = -1;
  bool parts = false;  // has parted since that bound was set
  double lifted = 0;   // m/s, by which it may part faster, as it has come to that while it was open
  // m/s, at which its bodies did, as rigid ones, at the end of the last step; where a restitution is below 1
  double parting = 0;
  double deeper = 0;  // m, that it lies deeper than the contact it has taken over from before this step
  // N, N, m: of a static run, at the end of the last load step; no number: has taken over from another contact since;
  // and what it was lifted by after that one.
  double load_normal = 0, load_shear = 0, load_slip = 0, load_climb = 0;
  bool coheres = false;  // in a search for equilibrium that keeps it: whatever presses it now
  // What the contact cannot hold of its sliding is slip: at the end of a step; of a load step, where friction goes by
  // the way from its start, whichever way the search for equilibrium takes (backward Euler), or else of each solve of
  // the search.
  void end_sliding() {
    if (state == ContactState::open) {
      part();
      return;
    }
    const double held = shear_force / shear_stiffness;
    slid = stretch - held;
    slip += slid;
    stretch = held;
  }
  void part() { slip = slid = stretch = load_slip = load_climb = load_normal = load_shear = 0; }
  // J/m
  double stored() const {
    return normal_force * normal_force / (2 * normal_stiffness) + shear_force * shear_force / (2 * shear_stiffness);
  }
  static std::int64_t key(int global_vertex, int global_edge) {
    return (std::int64_t(global_vertex) << 32) | std::uint32_t(global_edge);
  }
  std::int64_t key() const { return key(global_vertex, global_edge); }
  int global_vertex = 0, global_edge = 0;  // indices into Model::vertex
};

struct PointFixity {
  int fixity = 0;  // index into Scene::fixities
  int block = 0;
  Vec2 in_block = Vec2::Zero();  // from the reference centroid
};

struct EdgeFixity {  // an edge bonded to the ground
  int fixity = 0, block = 0;
  std::array<Vec2, 2> in_block;
  Vec2 normal = Vec2::Zero();  // outward, reference
  double length = 0;
};

struct ViscousEdge {        // or a part of one, that absorbs waves
  int block = 0, edge = 0;  // the block's own edge, by local number
  std::array<Vec2, 2> in_block;
  Vec2 normal = Vec2::Zero();  // outward, reference
  double length = 0;           // m, reference
  // Pa at its Gauss points, two or three, found in equilibrium, global
  std::array<Vec2, 3> traction = {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
};

struct PointForce {
  int load = 0, block = 0;  // index into Scene::point_loads
  Vec2 in_block = Vec2::Zero();
  double share = 1;  // where several blocks meet at the point
};

struct EdgeForce {
  int load = 0, block = 0;  // index into Scene::edge_loads
  std::array<Vec2, 2> in_block;
};

struct BlockEdge {
  int block = 0, edge = 0;  // ids; edge local
};

// The wall of a charge's hole: free edges in order, each beginning where the one before ends; then likewise the
// outlines of what lies in the hole by itself.
struct HoleWall {
  int charge = 0;
  Vec2 centre = Vec2::Zero();  // of the hole, reference
  double radius = 0;           // m, of a disc of its area
  std::vector<BlockEdge> edges;
  std::vector<size_t> outlines = {0};  // where in edges each begins
};

struct GasFace {  // part of a block's edge under gas, in this step
  int chamber = 0, block = 0;
  std::array<Vec2, 2> in_block;  // in the edge's own sense, block on its left
};

struct ProbePoint {
  int probe = 0, block = 0;
  Vec2 in_block = Vec2::Zero();
  double peak_speed = 0, peak_at = 0;  // m/s, highest of the motion so far; s, when
};

struct LoadWay {  // in a part of a load step: loads and supports are on the way to those of Model::time
  static constexpr double nothing = -1;  // s: there were none, and no gravity
  double from = 0, part = 1;             // s, when they were those they come from; how far they have come
};

struct Peak {  // the most that any block has come to so far
  int block = -1;
  double value = 0, at = 0;  // s, when
};

// A node of the meshes: the corner that several bonded blocks share at the start. For stress recovery.
struct Nodes {
  std::vector<Vec2> position;  // reference
  std::vector<int> region;
  std::vector<int> begin, blocks, corners;  // CSR: blocks that meet at a node and their local vertex
  std::vector<char> free;                   // a boundary edge that is no hole with a charge, and not viscous, ends here
};

class Model {
 public:
  Scene scene;  // materials, properties, loads' values are read from here, and may be changed between steps
  Vec2 origin = Vec2::Zero();
  // m, of what the places round `at` are differences of: the size of the scene, or the distance from its middle where
  // that is more.
  double size_of(const Vec2& at) const { return std::max(extent, at.norm()); }
  // m, half the scene's height, along gravity or else where it is narrowest (half its width where it is flat)
  double extent = 1;
  double time = 0;
  // J/m: what blocks store beside Σ A ε·(σ₀ + ½ C ε), as strains have been added to their own (Fracture::add_strain).
  double added_strain_energy = 0;
  long revision = 0;  // raised by changed()

  // Per block, the number of the group it sleeps in, or 0: awake. Empty where the scene does not let anything sleep
  // (step/sleep.h). The contacts of what sleeps stand first in `contacts`, each part in the order of key().
  std::vector<int> asleep;
  int sleeping_contacts = 0;
  long sleep_changes = 0;  // raised whenever others sleep: for what is derived from it

  std::vector<BlockShape> shapes;
  std::vector<QuadraticShape> quadratic_shapes;
  std::vector<BlockState> blocks;
  std::vector<Vec2> reference_vertex;  // from the reference centroid
  std::vector<Vec2> vertex;            // now
  std::vector<Joint> joints;
  std::vector<Contact> contacts;
  std::vector<PointFixity> point_fixities;
  std::vector<EdgeFixity> edge_fixities;
  // m, in motion, of each point of a support (equations/supports.h): the gap at y that the last step was solved for. As
  // the blocks lie, one that turns has come off by as much as the way of a step bends, for which no force answers.
  std::vector<Vec2> support_gaps;
  std::vector<Vec2> support_speeds;     // m/s, likewise, of each fixity: as the last step ended
  std::vector<Vec2> support_tractions;  // Pa, likewise, in the directions held: that of the last step
  std::vector<ViscousEdge> viscous_edges;
  std::vector<PointForce> point_forces;
  std::vector<EdgeForce> edge_forces;
  std::vector<HoleWall> hole_walls;
  std::vector<GasFace> gas_faces;
  std::vector<double> gas_pressure;  // Pa, mean over the step, per chamber
  std::vector<ProbePoint> probes;
  LoadWay load_way;
  Peak highest;   // m, of a centroid above its place at the start, against gravity; in motion
  Peak strained;  // largest principal strain, by its size (of second-order blocks the mean)
  Nodes nodes;
  std::vector<int> fragment;     // per block: which connected set of intact joints it belongs to
  std::vector<int> held_by;      // per block: index of the fixity that holds it wholly, or -1
  std::vector<int> held_blocks;  // those without unknowns, rising
  // m/s, of each of held_blocks where they move: by how much faster it is as this step ends than as the last one did.
  std::vector<std::array<double, rigid_dofs>> held_faster;
  // m/s, likewise, its velocity as the last step ended less that on its mean, blocks[b].velocity
  std::vector<Vec2> held_rising;
  std::unordered_map<std::int64_t, int> pair_property;  // unbonded interfaces: (a, b) with a < b -> property
  int dofs = 0;
  std::vector<std::string> notes;  // what building it has to tell the user

  int vertex_count(int block) const { return shapes[block].vertex_end - shapes[block].vertex_begin; }
  int next_vertex(int block, int local) const { return local + 1 == vertex_count(block) ? 0 : local + 1; }
  // Of a load, and m of a fixity, at the time t.
  double load(const History& history, double t) const {
    return on_the_way(t, [&](double at) { return at == LoadWay::nothing ? 0 : history.at(at); });
  }
  Vec2 moved(const Fixity& fixity, double t) const {
    return on_the_way(t, [&](double at) { return fixity.moved(std::max(at, 0.0)); });
  }
  Vec2 gravity() const { return (load_way.from == LoadWay::nothing ? load_way.part : 1) * scene.gravity; }  // m/s2
  const Material& material(int block) const { return scene.materials[shapes[block].material]; }

  bool sleeps(int block) const { return !asleep.empty() && asleep[block] != 0; }
  auto awake_blocks() const {  // rising
    return std::views::iota(0, int(shapes.size())) | std::views::filter([this](int block) { return !sleeps(block); });
  }
  double faster_along(int block, const std::array<double, max_dofs>& row) const;  // m/s, of a held block; of another 0
  Vec2 rising(int block) const;                                                   // likewise
  std::size_t held_number(int block) const;                                       // its place in held_blocks
  bool sleeps(const Contact& c) const { return sleeps(c.i) || sleeps(c.j); }
  // To be called by whoever changes materials, joint properties, loads, supports or states of blocks between steps: all
  // wake. (A state of what sleeps that is changed without is lost: steps keep two copies, by turns.)
  void changed();
  void hold(int block);   // while it is built: it has no unknowns, of any order
  void order_contacts();  // after a change of `asleep`
  std::span<Contact> awake_contacts() { return std::span(contacts).subspan(size_t(sleeping_contacts)); }
  std::span<const Contact> awake_contacts() const { return std::span(contacts).subspan(size_t(sleeping_contacts)); }
  std::span<const Contact> asleep_contacts() const { return std::span(contacts).first(size_t(sleeping_contacts)); }

  // Place of the material point `in_block` (from the reference centroid): c + R ((I + e) X + q(X)).
  Vec2 place(int block, const Vec2& in_block) const { return place(block, blocks[block], in_block); }
  Vec2 place(int block, const BlockState& state, const Vec2& in_block) const;  // in another state
  Vec2 velocity_at(int block, const Vec2& point) const;
  // Whether the edges of a block bend.
  bool curved(int block) const { return shapes[block].second_order(); }
  CurvedEdge curved_edge(int block, int edge) const;  // of a curved block, as it lies
  // Whether sides of a curved block, with its corners there, have bent inwards: what holds of convex blocks and parts
  // does not of it.
  bool dented(int block, std::span<const Vec2> corners) const;
  // m, of the middles of its edges; 0 where it is not curved
  double largest_rise(int block, const BlockState& state) const;
  Vec2 velocity_on_edge(int block, int edge, const Vec2& point) const {
    return curved(block) ? velocity_on_bent_edge(block, edge, point) : velocity_at(block, point);
  }
  Vec2 corner_velocity(int block, int local) const {
    const int v = shapes[block].vertex_begin + local;
    return curved(block) ? bent_velocity(block, reference_vertex[v], vertex[v]) : velocity_at(block, vertex[v]);
  }
  Vec2 reference_place(int block, const Vec2& in_block) const { return shapes[block].reference_centroid + in_block; }
  double area(int block) const;  // m2, now
  double mass(int block) const { return material(block).density * shapes[block].area; }
  Vec3 stress(int block) const;                        // sxx, syy, sxy, global axes, raw, at the centroid
  Vec3 stress(int block, const Vec2& in_block) const;  // at a material point: another only in a second-order block
  void place_vertices();                               // vertex from blocks
  void place_vertices(int block, const BlockState& state, std::vector<Vec2>& to) const;
  // Where the block would have the corner `v`, an index into `vertex`, in another state.
  Vec2 vertex_at(int block, const BlockState& state, const Rotation& rotation, int v) const;
  int contact_property(int a, int b) const;
  // Pa/m, normal stiffness of an interface between two blocks, unless it is given per contact: by default then.
  double stiffness_per_area(const JointProperty& property, int a, int b) const;
  Strength strength(const Joint& joint) const;  // of the intact bond
  Strength contact_strength(const Contact& contact) const;

 private:
  template <class Of>
  std::invoke_result_t<Of, double> on_the_way(double t, Of of) const {
    if (load_way.part == 1 || t != time) return of(t);
    return (1 - load_way.part) * of(load_way.from) + load_way.part * of(t);
  }
  Vec2 rise(int block, int edge, const BlockState& state) const;
  Vec2 velocity_on_bent_edge(int block, int edge, const Vec2& point) const;
  Vec2 bent_velocity(int block, const Vec2& point) const;
  // of the material point `in_block`, which is at `point`
  Vec2 bent_velocity(int block, const Vec2& in_block, const Vec2& point) const;
};

std::string block_name(const Model& model, int block);  // for messages: its number from 1, region and place

// Stress–strain matrix (Pa) for (εx, εy, γxy) -> (σx, σy, τ).
Mat3 elasticity(const Material& material);

// (sxx, syy, sxy) in axes turned by `r`, from the turned axes into the fixed ones.
Vec3 turn_stress(const Rotation& r, const Vec3& stress);

}  // namespace talus
