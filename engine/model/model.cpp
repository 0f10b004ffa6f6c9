#include "model/model.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace talus {

namespace {

Vec2 stretched(const Vec3& strain, const Vec2& x) {
  return {(1 + strain[0]) * x.x() + strain[2] / 2 * x.y(), strain[2] / 2 * x.x() + (1 + strain[1]) * x.y()};
}

// (I + e) X + q(X)
Vec2 deformed(const BlockShape& shape, const BlockState& state, const Vec2& x) {
  if (!shape.second_order()) return stretched(state.strain, x);
  return stretched(state.strain, x) + shape.bend().displacement(x, *state.bend);
}

// The undeformed arm of the point that now lies at `arm`, in the block's axes: q is small beside X, so that each round
// gains the digits of a strain.
Vec2 undeformed(const BlockShape& shape, const BlockState& state, const Vec2& arm) {
  constexpr int rounds = 8;
  Vec2 x = arm;
  for (int k = 0; k < rounds; ++k) x += arm - deformed(shape, state, x);
  return x;
}

// Its rate but for the rotation, at the undeformed arm X of a second-order block.
Vec2 deforming(const BlockShape& shape, const BlockState& state, const Vec2& x) {
  const auto& v = state.velocity;
  return Vec2(v[3] * x.x() + v[5] / 2 * x.y(), v[5] / 2 * x.x() + v[4] * x.y()) / shape.length +
         Bend::sum(shape.bend().monomials(x), &v[first_order_dofs]);
}

}  // namespace

std::string block_name(const Model& model, int block) {
  char text[160];
  const Vec2 at = model.blocks[block].centroid + model.origin;
  std::snprintf(text, sizeof text, "block %d (region \"%s\", at (%.6g, %.6g))", block + 1,
                model.scene.regions[model.shapes[block].region].name.c_str(), at.x(), at.y());
  return text;
}

Vec2 Model::place(int block, const BlockState& state, const Vec2& in_block) const {
  return state.centroid + Rotation::of(state.angle).turn(deformed(shapes[block], state, in_block));
}

Vec2 Model::velocity_at(int block, const Vec2& point) const {
  if (shapes[block].second_order()) return bent_velocity(block, point);
  const BlockState& state = blocks[block];
  const Rotation rotation = Rotation::of(state.angle);
  const auto& v = state.velocity;
  const Vec2 x = rotation.back(point - state.centroid) / shapes[block].length;
  const Vec2 local(-v[2] * x.y() + v[3] * x.x() + v[5] / 2 * x.y(), v[2] * x.x() + v[4] * x.y() + v[5] / 2 * x.x());
  return Vec2(v[0], v[1]) + rotation.turn(local);
}

Vec2 Model::bent_velocity(int block, const Vec2& point) const {
  const BlockState& state = blocks[block];
  const Vec2 arm = undeformed(shapes[block], state, Rotation::of(state.angle).back(point - state.centroid));
  return bent_velocity(block, arm, point);
}

Vec2 Model::bent_velocity(int block, const Vec2& in_block, const Vec2& point) const {
  const BlockShape& shape = shapes[block];
  const BlockState& state = blocks[block];
  return Vec2(state.velocity[0], state.velocity[1]) + state.velocity[2] / shape.length * perp(point - state.centroid) +
         Rotation::of(state.angle).turn(deforming(shape, state, in_block));
}

Vec2 Model::rise(int block, int edge, const BlockState& state) const {
  const BlockShape& shape = shapes[block];
  const Vec2 along =
      reference_vertex[shape.vertex_begin + next_vertex(block, edge)] - reference_vertex[shape.vertex_begin + edge];
  return Rotation::of(state.angle).turn(Bend::sum(shape.bend().rise(along), *state.bend));
}

CurvedEdge Model::curved_edge(int block, int edge) const {
  const int begin = shapes[block].vertex_begin, from = begin + edge, to = begin + next_vertex(block, edge);
  return {vertex[from], vertex[to] - vertex[from], rise(block, edge, blocks[block])};
}

bool Model::dented(int block, std::span<const Vec2> corners) const {
  // sine of an angle: sides of slender blocks then sag by less than what corners in one place may be apart
  constexpr double straight = 3e-5;
  const auto turn = [](const Vec2& before, const Vec2& at, const Vec2& after) {
    return cross(at - before, after - at) / ((at - before).norm() * (after - at).norm());
  };
  const int count = vertex_count(block);
  const Vec2* const drawn = reference_vertex.data() + shapes[block].vertex_begin;
  for (int v = 0; curved(block) && v < count; ++v) {
    const int before = v == 0 ? count - 1 : v - 1, after = next_vertex(block, v);
    if (turn(corners[size_t(before)], corners[size_t(v)], corners[size_t(after)]) < -straight &&
        turn(drawn[before], drawn[v], drawn[after]) > -straight)
      return true;
  }
  return false;
}

double Model::largest_rise(int block, const BlockState& state) const {
  double largest = 0;
  for (int e = 0; curved(block) && e < vertex_count(block); ++e)
    largest = std::max(largest, rise(block, e, state).norm());
  return largest;
}

Vec2 Model::velocity_on_bent_edge(int block, int edge, const Vec2& point) const {
  const int from = shapes[block].vertex_begin + edge, to = shapes[block].vertex_begin + next_vertex(block, edge);
  const double at = CurvedEdge::within(curved_edge(block, edge).nearest(point));
  return bent_velocity(block, (1 - at) * reference_vertex[from] + at * reference_vertex[to], point);
}

double Model::area(int block) const {
  const BlockShape& shape = shapes[block];
  if (shape.second_order()) {
    double area = signed_area(Polyline(vertex.begin() + shape.vertex_begin, vertex.begin() + shape.vertex_end));
    for (int e = 0; e < vertex_count(block); ++e) {  // the segment of a parabola is 2/3 of chord times rise
      const CurvedEdge edge = curved_edge(block, e);
      area += 2.0 / 3 * cross(edge.rise, edge.span);
    }
    return area;
  }
  const Vec3& e = blocks[block].strain;
  return shapes[block].area * ((1 + e[0]) * (1 + e[1]) - e[2] * e[2] / 4);
}

Vec3 Model::stress(int block) const {
  const BlockState& state = blocks[block];
  const Vec3 own = shapes[block].initial_stress + elasticity(material(block)) * state.strain;
  return turn_stress(Rotation::of(state.angle), own);
}

Vec3 Model::stress(int block, const Vec2& in_block) const {
  const BlockShape& shape = shapes[block];
  if (!shape.second_order()) return stress(block);
  const BlockState& state = blocks[block];
  const QuadraticShape& quadratic = quadratic_shapes[shape.quadratic];
  const Vec3 initial = shape.initial_stress + quadratic.stress_x * in_block.x() + quadratic.stress_y * in_block.y();
  const Vec3 strain = state.strain + shape.bend().strain(in_block, *state.bend);
  return turn_stress(Rotation::of(state.angle), initial + elasticity(material(block)) * strain);
}

void Model::hold(int block) {
  BlockShape& shape = shapes[block];
  if (shape.second_order()) {
    BlockState still;
    still.centroid = blocks[block].centroid;
    std::copy_n(blocks[block].velocity.begin(), first_order_dofs, still.velocity.begin());
    blocks[block] = still;
  }
  shape.quadratic = -1;
  shape.dofs = 0;
}

std::size_t Model::held_number(int block) const {
  return std::size_t(std::lower_bound(held_blocks.begin(), held_blocks.end(), block) - held_blocks.begin());
}

Vec2 Model::rising(int block) const {
  return held_rising.empty() || shapes[block].dofs > 0 ? Vec2(0, 0) : held_rising[held_number(block)];
}

double Model::faster_along(int block, const std::array<double, max_dofs>& row) const {
  if (held_faster.empty() || shapes[block].dofs > 0) return 0;
  const auto& faster = held_faster[held_number(block)];
  return std::inner_product(faster.begin(), faster.end(), row.begin(), 0.0);
}

void Model::place_vertices() {
  vertex.resize(reference_vertex.size());
  for (int b = 0; b < int(shapes.size()); ++b) place_vertices(b, blocks[b], vertex);
}

void Model::place_vertices(int block, const BlockState& state, std::vector<Vec2>& to) const {
  const Rotation rotation = Rotation::of(state.angle);
  const BlockShape& shape = shapes[block];
  for (int v = shape.vertex_begin; v < shape.vertex_end; ++v) to[v] = vertex_at(block, state, rotation, v);
}

Vec2 Model::vertex_at(int block, const BlockState& state, const Rotation& rotation, int v) const {
  return state.centroid + rotation.turn(deformed(shapes[block], state, reference_vertex[v]));
}

void Model::changed() {
  ++revision;
  if (std::all_of(asleep.begin(), asleep.end(), [](int group) { return group == 0; })) return;
  std::fill(asleep.begin(), asleep.end(), 0);
  order_contacts();
}

void Model::order_contacts() {
  const auto awake = std::partition(contacts.begin(), contacts.end(), [this](const Contact& c) { return sleeps(c); });
  const auto by_key = [](const Contact& a, const Contact& b) { return a.key() < b.key(); };
  std::sort(contacts.begin(), awake, by_key);
  std::sort(awake, contacts.end(), by_key);
  sleeping_contacts = int(awake - contacts.begin());
  ++sleep_changes;
}

int Model::contact_property(int a, int b) const {
  const auto found = pair_property.find((std::int64_t(std::min(a, b)) << 32) | std::max(a, b));
  if (found != pair_property.end()) return found->second;
  const int region_a = shapes[a].region, region_b = shapes[b].region;
  for (const ContactRule& rule : scene.contact_rules)
    if ((rule.region_a == region_a && rule.region_b == region_b) ||
        (rule.region_a == region_b && rule.region_b == region_a))
      return rule.property;
  if (region_a == region_b && scene.regions[region_a].joint >= 0) return scene.regions[region_a].joint;
  return scene.contact;
}

double Model::stiffness_per_area(const JointProperty& property, int a, int b) const {
  if (property.stiffness_kind == StiffnessKind::per_area) return property.stiffness;
  const bool given = property.stiffness_kind == StiffnessKind::per_length;
  return (given ? property.stiffness : JointProperty{}.stiffness) * std::min(material(a).young, material(b).young) /
         std::min(shapes[a].length, shapes[b].length);
}

BondTraction mean_traction(const Joint& joint) {
  BondTraction sum;
  double weight = 0;
  for (const JointPoint& point : joint.points) {
    sum.normal += point.weight * point.normal;
    sum.shear += point.weight * point.shear;
    weight += point.weight;
  }
  return {sum.normal / weight, sum.shear / weight};
}

Strength Model::strength(const Joint& joint) const {
  const JointProperty& property = scene.properties[joint.property];
  return {property.friction, joint.scatter * property.cohesion, joint.scatter * property.tension};
}

// What joins the faces of a failed bond, the cohesion of its roughness, does not join faces that meet elsewhere.
Strength Model::contact_strength(const Contact& contact) const {
  const JointProperty& property = scene.properties[contact.property];
  if (contact.joint >= 0 && joints[contact.joint].bonded) {
    const Strength& left = joints[contact.joint].remaining;
    return {left.friction, std::min(left.cohesion, property.residual.cohesion), 0};  // more is carried by its bridge
  }
  if (contact.joint < 0 && property.breaks) return {property.residual.friction, 0, 0};
  return {property.friction, property.cohesion, 0};
}

Mat3 elasticity(const Material& material) {
  const double nu = material.poisson;
  Mat3 d = Mat3::Zero();
  if (material.plane == Plane::stress) {
    const double factor = material.young / (1 - nu * nu);
    d << factor, factor * nu, 0, factor * nu, factor, 0, 0, 0, factor * (1 - nu) / 2;
  } else {
    const double factor = material.young / ((1 + nu) * (1 - 2 * nu));
    d << factor * (1 - nu), factor * nu, 0, factor * nu, factor * (1 - nu), 0, 0, 0, factor * (1 - 2 * nu) / 2;
  }
  return d;
}

Vec3 turn_stress(const Rotation& r, const Vec3& s) {
  const double c = r.c, n = r.s;
  return {c * c * s[0] + n * n * s[1] - 2 * c * n * s[2], n * n * s[0] + c * c * s[1] + 2 * c * n * s[2],
          c * n * (s[0] - s[1]) + (c * c - n * n) * s[2]};
}

}  // namespace talus
