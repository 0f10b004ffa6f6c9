#include "model/fields.h"

#include <algorithm>
#include <cmath>

#include "equations/error_estimate.h"

namespace talus {

namespace {

using Context = const FieldContext&;

// A field of the table's row `id`, from a function without captures (its type alone is kept).
template <class F>
Field whole(std::string name, std::string meaning, F) {
  const auto get = [](Context c, int id, double* out) { *out = static_cast<double>(F{}(c, id)); };
  return {name, "", meaning, 1, get, "", true};
}

template <class F>
Field scalar(std::string name, std::string symbol, std::string unit, std::string meaning, F) {
  const auto get = [](Context c, int id, double* out) { *out = F{}(c, id); };
  return {name, unit, meaning, 1, get, symbol};
}

template <int n, class F>
Field vector(std::string name, std::string symbol, std::string unit, std::string meaning, F) {
  const auto get = [](Context c, int id, double* out) {
    const Eigen::Matrix<double, n, 1> value = F{}(c, id);
    std::copy_n(value.data(), n, out);
  };
  return {name, unit, meaning, n, get, symbol};
}

const BlockShape& shape(Context c, int id) {
  return c.model.shapes[id];
}
const BlockState& state(Context c, int id) {
  return c.model.blocks[id];
}

Vec2 displacement(Context c, int id) {
  return state(c, id).centroid - shape(c, id).reference_centroid;
}
Vec2 velocity(Context c, int id) {
  return {state(c, id).velocity[0], state(c, id).velocity[1]};
}

Vec3 global_strain(Context c, int id) {
  Vec3 e = state(c, id).strain;
  e[2] /= 2;
  e = turn_stress(Rotation::of(state(c, id).angle), e);
  e[2] *= 2;
  return e;
}

double out_of_plane(Context c, int id) {
  const Vec3 s = c.model.stress(id);
  const Material& material = c.model.material(id);
  return material.plane == Plane::strain ? material.poisson * (s[0] + s[1]) : 0;
}

double mises(Context c, int id) {
  const Vec3 s = c.model.stress(id);
  const double szz = out_of_plane(c, id);
  const double xy = s[0] - s[1], yz = s[1] - szz, zx = szz - s[0];
  return std::sqrt((xy * xy + yz * yz + zx * zx) / 2 + 3 * s[2] * s[2]);
}

double joint_mean(const Joint& joint, double JointPoint::*value) {
  double sum = 0, weight = 0;
  for (const JointPoint& point : joint.points) {
    sum += point.weight * (point.*value);
    weight += point.weight;
  }
  return weight > 0 ? sum / weight : 0;
}

Vec2 joint_middle(const Model& model, const Joint& joint) {
  const Vec2 in_a = (joint.in_a[0] + joint.in_a[1]) / 2, in_b = (joint.in_b[0] + joint.in_b[1]) / 2;
  return (model.place(joint.a, in_a) + model.place(joint.b, in_b)) / 2;
}

const Joint& joint(Context c, int id) {
  return c.model.joints[id];
}
const Contact& contact(Context c, int id) {
  return c.model.contacts[id];
}

Strength strength_now(Context c, int id) {
  const Joint& j = joint(c, id);
  return j.bonded && j.state == JointState::failed ? j.remaining : c.model.strength(j);
}

double per_length(double force, const Contact& contact) {
  return contact.length > 0 ? force / contact.length : 0;
}

const ProbePoint& probe(Context c, int id) {
  return c.model.probes[id];
}
Vec2 probe_place(Context c, int id) {
  return c.model.place(probe(c, id).block, probe(c, id).in_block);
}
Vec2 probe_displacement(Context c, int id) {
  return probe_place(c, id) - c.model.reference_place(probe(c, id).block, probe(c, id).in_block);
}
Vec2 probe_velocity(Context c, int id) {
  return c.model.velocity_at(probe(c, id).block, probe_place(c, id));
}
Vec3 probe_raw(Context c, int id) {
  return c.model.stress(probe(c, id).block, probe(c, id).in_block);
}
Vec3 probe_stress(Context c, int id) {
  if (!c.recovery) return probe_raw(c, id);
  return c.recovery->stress_at(c.model, probe(c, id).block, probe(c, id).in_block);
}

}  // namespace

Principals principals(const Vec3& s) {
  const double mean = (s[0] + s[1]) / 2, radius = std::hypot((s[0] - s[1]) / 2, s[2]);
  return {mean + radius, mean - radius, std::atan2(2 * s[2], s[0] - s[1]) / 2};
}

Vec3 smoothed_stress(const FieldContext& c, int block) {
  if (c.smoothed) return (*c.smoothed)[block];
  return c.recovery ? c.recovery->stress_at(c.model, block, Vec2::Zero()) : c.model.stress(block);
}

std::vector<Vec3> smoothed_stresses(const FieldContext& c) {
  std::vector<Vec3> stresses(c.model.shapes.size());
  for (std::size_t b = 0; b < stresses.size(); ++b) stresses[b] = smoothed_stress(c, static_cast<int>(b));
  return stresses;
}

static double estimated_error(Context c, int block) {
  return c.recovery ? stress_error(c.model, *c.recovery, block) : 0;
}

std::span<const Field> block_fields() {
  static const std::vector<Field> fields = {
      whole("id", "number of the block, from 0", [](Context, int i) { return i; }),
      whole("region", "number of its region, from 0", [](Context c, int i) { return shape(c, i).region; }),
      whole("material", "number of its material, from 0", [](Context c, int i) { return shape(c, i).material; }),
      whole("order", "0 rigid or held, 1 first order, 2 second order",
            [](Context c, int i) { return shape(c, i).dofs / first_order_dofs; }),
      whole("fixed", "1 for a held block", [](Context c, int i) { return shape(c, i).dofs == 0; }),
      whole("fragment", "which fragment it belongs to, from 0: blocks that hang together by intact bonds",
            [](Context c, int i) { return c.model.fragment[i]; }),
      scalar("area", "A", "m2", "area now", [](Context c, int i) { return c.model.area(i); }),
      scalar("density", "ρ", "kg/m3", "density of its material",
             [](Context c, int i) { return c.model.material(i).density; }),
      scalar("mass", "m", "kg/m", "mass per metre of thickness", [](Context c, int i) { return c.model.mass(i); }),
      vector<2>("centroid", "", "m", "place of the centroid now",
                [](Context c, int i) -> Vec2 { return state(c, i).centroid + c.model.origin; }),
      vector<2>("displacement", "|u|", "m", "displacement of the centroid since the start",
                [](Context c, int i) { return displacement(c, i); }),
      scalar("u", "|u|", "m", "magnitude of the centroid's displacement",
             [](Context c, int i) { return displacement(c, i).norm(); }),
      scalar("ux", "u_x", "m", "displacement along x", [](Context c, int i) { return displacement(c, i).x(); }),
      scalar("uy", "u_y", "m", "displacement along y", [](Context c, int i) { return displacement(c, i).y(); }),
      vector<2>("velocity", "|v|", "m/s", "velocity of the centroid", [](Context c, int i) { return velocity(c, i); }),
      scalar("speed", "|v|", "m/s", "magnitude of the centroid's velocity",
             [](Context c, int i) { return velocity(c, i).norm(); }),
      scalar("rotation", "θ", "rad", "rotation since the start, counter-clockwise",
             [](Context c, int i) { return state(c, i).angle; }),
      scalar("spin", "ω", "rad/s", "rate of rotation",
             [](Context c, int i) { return state(c, i).velocity[2] / shape(c, i).length; }),
      vector<3>("strain", "", "", "exx, eyy, gxy since the start, global axes",
                [](Context c, int i) { return global_strain(c, i); }),
      scalar("exx", "ε_xx", "", "strain along x", [](Context c, int i) { return global_strain(c, i)[0]; }),
      scalar("eyy", "ε_yy", "", "strain along y", [](Context c, int i) { return global_strain(c, i)[1]; }),
      scalar("gxy", "γ_xy", "", "shear strain (engineering)", [](Context c, int i) { return global_strain(c, i)[2]; }),
      vector<3>("stress", "", "Pa", "sxx, syy, sxy of the block, tension positive",
                [](Context c, int i) { return c.model.stress(i); }),
      scalar("sxx", "σ_xx", "Pa", "stress along x, tension positive",
             [](Context c, int i) { return c.model.stress(i)[0]; }),
      scalar("syy", "σ_yy", "Pa", "stress along y, tension positive",
             [](Context c, int i) { return c.model.stress(i)[1]; }),
      scalar("sxy", "σ_xy", "Pa", "shear stress", [](Context c, int i) { return c.model.stress(i)[2]; }),
      scalar("szz", "σ_zz", "Pa", "stress out of the plane: ν(sxx + syy) in plane strain, 0 in plane stress",
             [](Context c, int i) { return out_of_plane(c, i); }),
      scalar("s1", "σ_1", "Pa", "principal stress, the most tensile, tension positive",
             [](Context c, int i) { return principals(c.model.stress(i)).first; }),
      scalar("s2", "σ_2", "Pa", "principal stress, the most compressive, tension positive",
             [](Context c, int i) { return principals(c.model.stress(i)).second; }),
      scalar("s1_direction", "θ_1", "rad", "direction of s1 against +x",
             [](Context c, int i) { return principals(c.model.stress(i)).direction; }),
      scalar("mises", "σ_vM", "Pa", "von Mises stress", [](Context c, int i) { return mises(c, i); }),
      vector<3>("stress_smooth", "", "Pa", "sxx, syy, sxy at the centroid, smoothed",
                [](Context c, int i) { return smoothed_stress(c, i); }),
      scalar("sxx_smooth", "σ_xx", "Pa", "stress along x at the centroid, smoothed",
             [](Context c, int i) { return smoothed_stress(c, i)[0]; }),
      scalar("syy_smooth", "σ_yy", "Pa", "stress along y at the centroid, smoothed",
             [](Context c, int i) { return smoothed_stress(c, i)[1]; }),
      scalar("sxy_smooth", "σ_xy", "Pa", "shear stress at the centroid, smoothed",
             [](Context c, int i) { return smoothed_stress(c, i)[2]; }),
      scalar("s1_smooth", "σ_1", "Pa", "principal stress, the most tensile, smoothed",
             [](Context c, int i) { return principals(smoothed_stress(c, i)).first; }),
      scalar("s2_smooth", "σ_2", "Pa", "principal stress, the most compressive, smoothed",
             [](Context c, int i) { return principals(smoothed_stress(c, i)).second; }),
      scalar(
          "stress_error", "σ_err", "Pa",
          "estimated error of its stress, mean in energy over the block: √(E e²/A), e² = ∫ Δσ·D⁻¹Δσ dA; 0 where nothing is smoothed",
          [](Context c, int i) { return estimated_error(c, i); }),
  };
  return fields;
}

std::span<const Field> joint_fields() {
  static const std::vector<Field> fields = {
      whole("id", "number of the joint, from 0", [](Context, int i) { return i; }),
      whole("block_a", "block on its left", [](Context c, int i) { return joint(c, i).a; }),
      whole("block_b", "block on its right", [](Context c, int i) { return joint(c, i).b; }),
      whole("property", "number of its joint property, from 0", [](Context c, int i) { return joint(c, i).property; }),
      whole("trace", "joint trace it lies on, -1 for a joint of the mesh",
            [](Context c, int i) { return joint(c, i).trace; }),
      whole("state", "0 intact, 1 failed", [](Context c, int i) { return joint(c, i).state == JointState::failed; }),
      whole("kind", "0 exact bond, 1 springs", [](Context c, int i) { return joint(c, i).kind == BondKind::spring; }),
      whole("mode", "0 intact or a real joint, failed in 1 tension, 2 shear",
            [](Context c, int i) { return int(joint(c, i).mode); }),
      whole("crack", "when it failed: 1 initiated, 2 propagated, 3 coalesced; else 0",
            [](Context c, int i) { return int(joint(c, i).crack); }),
      scalar("utilisation", "", "",
             "part of its strength that is used, by its criterion; of a failed one: when it failed",
             [](Context c, int i) { return joint(c, i).utilisation; }),
      scalar("failed_at", "", "s", "time of failure", [](Context c, int i) { return joint(c, i).failed_at; }),
      scalar("cohesion", "", "Pa", "cohesion now", [](Context c, int i) { return strength_now(c, i).cohesion; }),
      scalar("tension", "", "Pa", "tensile strength now", [](Context c, int i) { return strength_now(c, i).tension; }),
      scalar("friction", "", "rad", "friction angle now", [](Context c, int i) { return strength_now(c, i).friction; }),
      scalar("length", "", "m", "length at the start", [](Context c, int i) { return joint(c, i).length; }),
      scalar("normal_traction", "", "Pa", "mean normal traction, tension positive",
             [](Context c, int i) { return joint_mean(joint(c, i), &JointPoint::normal); }),
      scalar("shear_traction", "", "Pa", "mean shear traction",
             [](Context c, int i) { return joint_mean(joint(c, i), &JointPoint::shear); }),
      scalar(
          "traction_jump", "", "Pa",
          "what the stresses of its blocks disagree by in their traction on it, root mean square; 0 beside a rigid one",
          [](Context c, int i) { return traction_jump(c.model, joint(c, i)); }),
      scalar("opening", "", "m", "mean opening",
             [](Context c, int i) { return joint_mean(joint(c, i), &JointPoint::opening); }),
      scalar("slip", "", "m", "mean sliding",
             [](Context c, int i) { return joint_mean(joint(c, i), &JointPoint::slip); }),
      vector<2>("mid", "", "m", "place of its middle now",
                [](Context c, int i) -> Vec2 { return joint_middle(c.model, joint(c, i)) + c.model.origin; }),
      vector<2>("mid_start", "", "m", "place of its middle at the start",
                [](Context c, int i) -> Vec2 {
                  const Joint& j = joint(c, i);
                  return c.model.reference_place(j.a, (j.in_a[0] + j.in_a[1]) / 2) + c.model.origin;
                }),
  };
  return fields;
}

std::span<const Field> contact_fields() {
  static const std::vector<Field> fields = {
      whole("block_i", "block of the vertex", [](Context c, int i) { return contact(c, i).i; }),
      whole("block_j", "block of the edge", [](Context c, int i) { return contact(c, i).j; }),
      whole("vertex", "vertex of block_i, from 0", [](Context c, int i) { return contact(c, i).vertex; }),
      whole("edge", "edge of block_j, from 0", [](Context c, int i) { return contact(c, i).edge; }),
      whole("property", "number of its joint property, from 0",
            [](Context c, int i) { return contact(c, i).property; }),
      whole("kind", "0 angle–angle, 1 angle–edge, 2 edge–edge", [](Context c, int i) { return contact(c, i).kind; }),
      whole("state", "0 open, 1 stick, 2 slip", [](Context c, int i) { return contact(c, i).state; }),
      scalar("length", "", "m", "part of the interface it stands for",
             [](Context c, int i) { return contact(c, i).length; }),
      scalar("gap", "", "m", "gap, negative when pressed together", [](Context c, int i) { return contact(c, i).gap; }),
      scalar("normal_force", "", "N/m", "normal force, positive when pressed together",
             [](Context c, int i) { return contact(c, i).normal_force; }),
      scalar("shear_force", "", "N/m", "friction force along the edge",
             [](Context c, int i) { return contact(c, i).shear_force; }),
      scalar("normal_traction", "", "Pa",
             "-normal_force / length: tension positive, like every traction; 0 without length",
             [](Context c, int i) { return -per_length(contact(c, i).normal_force, contact(c, i)); }),
      scalar("shear_traction", "", "Pa", "shear_force / length; 0 without length",
             [](Context c, int i) { return per_length(contact(c, i).shear_force, contact(c, i)); }),
      scalar("stretch", "", "m", "elastic part of the sliding", [](Context c, int i) { return contact(c, i).stretch; }),
      scalar("slip", "", "m", "plastic part of the sliding, accumulated",
             [](Context c, int i) { return contact(c, i).slip; }),
      vector<2>("point", "", "m", "place of the vertex now",
                [](Context c, int i) -> Vec2 { return c.model.vertex[contact(c, i).global_vertex] + c.model.origin; }),
  };
  return fields;
}

std::span<const Field> probe_fields() {
  static const std::vector<Field> fields = {
      whole("block", "block that carries the probe", [](Context c, int i) { return probe(c, i).block; }),
      scalar("x", "", "m", "place now", [](Context c, int i) { return probe_place(c, i).x() + c.model.origin.x(); }),
      scalar("y", "", "m", "place now", [](Context c, int i) { return probe_place(c, i).y() + c.model.origin.y(); }),
      scalar("ux", "u_x", "m", "displacement along x", [](Context c, int i) { return probe_displacement(c, i).x(); }),
      scalar("uy", "u_y", "m", "displacement along y", [](Context c, int i) { return probe_displacement(c, i).y(); }),
      scalar("vx", "v_x", "m/s", "velocity along x", [](Context c, int i) { return probe_velocity(c, i).x(); }),
      scalar("vy", "v_y", "m/s", "velocity along y", [](Context c, int i) { return probe_velocity(c, i).y(); }),
      scalar("speed", "|v|", "m/s", "magnitude of the velocity",
             [](Context c, int i) { return probe_velocity(c, i).norm(); }),
      scalar("peak_speed", "PPV", "m/s", "highest speed of the motion so far, peak particle velocity; after each step",
             [](Context c, int i) { return probe(c, i).peak_speed; }),
      scalar("peak_at", "", "s", "when that was", [](Context c, int i) { return probe(c, i).peak_at; }),
      scalar("sxx", "σ_xx", "Pa", "stress along x, tension positive; smoothed where the run has a recovery",
             [](Context c, int i) { return probe_stress(c, i)[0]; }),
      scalar("syy", "σ_yy", "Pa", "stress along y, smoothed", [](Context c, int i) { return probe_stress(c, i)[1]; }),
      scalar("sxy", "σ_xy", "Pa", "shear stress, smoothed", [](Context c, int i) { return probe_stress(c, i)[2]; }),
      scalar("s1", "σ_1", "Pa", "principal stress, the most tensile, smoothed",
             [](Context c, int i) { return principals(probe_stress(c, i)).first; }),
      scalar("s2", "σ_2", "Pa", "principal stress, the most compressive, smoothed",
             [](Context c, int i) { return principals(probe_stress(c, i)).second; }),
      scalar("raw_sxx", "σ_xx", "Pa", "stress along x of its block",
             [](Context c, int i) { return probe_raw(c, i)[0]; }),
      scalar("raw_syy", "σ_yy", "Pa", "stress along y of its block",
             [](Context c, int i) { return probe_raw(c, i)[1]; }),
      scalar("raw_sxy", "σ_xy", "Pa", "shear stress of its block", [](Context c, int i) { return probe_raw(c, i)[2]; }),
  };
  return fields;
}

const Field* find_field(std::span<const Field> fields, const std::string& name) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace talus
