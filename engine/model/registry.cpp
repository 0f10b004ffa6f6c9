#include "model/registry.h"

#include <algorithm>
#include <tuple>

namespace talus {

namespace {

// What second-order blocks have beside: a table of its own, in their order, so that others keep nothing of it.
using Bends = std::vector<std::array<double, 2 * std::tuple_size_v<BendArray>>>;

Bends bends_of(const Model& model) {
  Bends bends(model.quadratic_shapes.size());
  for (size_t b = 0; !bends.empty() && b < model.shapes.size(); ++b) {
    if (!model.shapes[b].second_order()) continue;
    const BlockState& state = model.blocks[b];
    auto& bend = bends[size_t(model.shapes[b].quadratic)];
    std::copy(state.velocity.begin() + first_order_dofs, state.velocity.end(),
              std::copy(state.bend->begin(), state.bend->end(), bend.begin()));
  }
  return bends;
}

void set_bends(const Bends& bends, Model& model) {
  for (size_t b = 0; !bends.empty() && b < model.shapes.size(); ++b) {
    if (!model.shapes[b].second_order()) continue;
    BlockState& state = model.blocks[b];
    const auto& bend = bends[size_t(model.shapes[b].quadratic)];
    const auto rates = bend.begin() + long(state.bend->size());
    std::copy(bend.begin(), rates, state.bend->begin());
    std::copy(rates, bend.end(), state.velocity.begin() + first_order_dofs);
  }
}

// Where bonds can break blocks get more of it in motion.
void visit_initial_stress(Model& model, StateVisitor& v) {
  std::vector<Vec3> stress;
  for (const BlockShape& shape : model.shapes) stress.push_back(shape.initial_stress);
  v("initial_stress", stress);
  for (size_t b = 0; b < stress.size(); ++b) model.shapes[b].initial_stress = stress[b];
  for (QuadraticShape& shape : model.quadratic_shapes) {
    v("stress_x", shape.stress_x);
    v("stress_y", shape.stress_y);
  }
}

}  // namespace

void visit_state(Model& model, StateVisitor& v) {
  v("time", model.time);
  v("load_way_from", model.load_way.from);
  v("load_way", model.load_way.part);
  v("blocks", model.blocks);
  Bends bends = bends_of(model);
  v("bends", bends);
  set_bends(bends, model);
  v("joints", model.joints);
  v.growing("contacts", model.contacts);
  v.growing("asleep", model.asleep);
  v("sleeping_contacts", model.sleeping_contacts);
  v.growing("support_gaps", model.support_gaps);
  v.growing("support_speeds", model.support_speeds);
  v.growing("support_tractions", model.support_tractions);
  v.growing("held_rising", model.held_rising);
  v("viscous_edges", model.viscous_edges);
  v("probes", model.probes);
  v("highest", model.highest);
  v("strained", model.strained);
  visit_initial_stress(model, v);
  v("added_strain_energy", model.added_strain_energy);
  visit_values(model.scene, v);
  v.constant("origin", model.origin);
  v.constant("extent", model.extent);
  v.constant("gravity", model.scene.gravity);
  v.constant("shapes", model.shapes);
  v.constant("quadratic_shapes", model.quadratic_shapes);
  v.constant("reference_vertex", model.reference_vertex);
  v.constant("regions", model.scene.regions);
  v.constant("held_by", model.held_by);
  v.constant("point_fixities", model.point_fixities);
  v.constant("edge_fixities", model.edge_fixities);
  v.constant("point_forces", model.point_forces);
  v.constant("edge_forces", model.edge_forces);
  // vertex comes from blocks, fragment from joints, held_blocks from shapes; revision and sleep_changes only tell that
  // something changed.
}

void visit_values(Scene& scene, StateVisitor& v) {
  v("materials", scene.materials);
  v("properties", scene.properties);
  v("fixities", scene.fixities);
  v("point_loads", scene.point_loads);
  v("edge_loads", scene.edge_loads);
}

namespace {

template <class T>
void visit(std::optional<T>& part, StateVisitor& v);

void visit(double& number, StateVisitor& v) {
  v("number", number);
}

void visit(Orifice& orifice, StateVisitor& v) {
  auto& [coefficient, gamma, density, atmosphere, opening] = orifice;
  for (double* number : {&coefficient, &gamma, &density, &atmosphere}) v("orifice", *number);
  visit(opening, v);
}

void visit(Stemming& stemming, StateVisitor& v) {
  auto& [length, density, charge_length] = stemming;
  for (double* number : {&length, &density, &charge_length}) v("stemming", *number);
}

template <class T>
void visit(std::optional<T>& part, StateVisitor& v) {
  bool there = part.has_value();
  v("there", there);
  if (there) visit(*part, v);
}

}  // namespace

void visit_charges(Scene& scene, StateVisitor& v) {
  for (Charge& charge : scene.charges) {
    [[maybe_unused]] auto& [place, name, region, hole, delay, mass, law, check_fall, gas_speed, constant_speed, venting,
                            orifice, stemming] = charge;
    v("name", name);
    v("region", region);
    v("hole", hole);
    v("delay", delay);
    v("mass", mass);
    v.growing("law", law.constants);
    bool vents_by_function = bool(venting);
    v("venting", vents_by_function);
    visit(constant_speed, v);
    visit(orifice, v);
    visit(stemming, v);
  }
}

void visit_state(BlockState& state, StateVisitor& v) {
  // Six members and no more, by name: bindings go by their order. Bend and its rates: see Bends.
  [[maybe_unused]] const auto& [first_member, second, third, fourth, fifth, sixth] = state;
  v("shift", state.shift);
  v("centroid", state.centroid);
  v("angle", state.angle);
  v("strain", state.strain);
  std::array<double, first_order_dofs> first;
  std::copy_n(state.velocity.begin(), first.size(), first.begin());
  v("velocity", first);
  std::copy(first.begin(), first.end(), state.velocity.begin());
}

void visit_state(BlockShape& shape, StateVisitor& v) {
  auto& [dofs, dof_begin, vertex_begin, vertex_end, region, material, quadratic, bonded, length, radius,
         reference_centroid, area, xx, yy, xy, initial_stress] = shape;
  for (int* number : {&dofs, &dof_begin, &vertex_begin, &vertex_end, &region, &material}) v("shape", *number);
  for (double* number : {&area, &length, &radius, &xx, &yy, &xy}) v("shape", *number);
  v("reference_centroid", reference_centroid);
  v("bonded", bonded);
  v("quadratic", quadratic);
}

void visit_state(QuadraticShape& shape, StateVisitor& v) {
  auto& [moments, stress_x, stress_y] = shape;  // the stresses change: visit_initial_stress()
  v("third", moments.third);
  v("fourth", moments.fourth);
}

void visit_state(JointPoints& points, StateVisitor& v) {
  for (JointPoint& point : points) v("point", point);
}

void visit_state(JointPoint& point, StateVisitor& v) {
  auto& [at, weight, normal, shear, opening, slip, across, along] = point;
  v.constant("at", at);
  v.constant("weight", weight);
  v("normal", normal);
  v("shear", shear);
  v("opening", opening);
  v("slip", slip);
  v("across", across);
  v("along", along);
}

void visit_state(Bridge& bridge, StateVisitor& v) {
  auto& [origin, reach, worn, now, traction] = bridge;
  v("origin", origin);
  v("reach", reach);
  v("worn", worn);
  v("now", now);
  v("bridge_traction", traction);
}

void visit_state(Joint& joint, StateVisitor& v) {
  auto& [a, b, property, trace, bonded, state, mode, crack, failed_at, failed_with, left_with, utilisation, scatter,
         remaining, most_opening, most_slip, off_path, path_turn, bridged, kind, length, normal, in_a, in_b, edge_a,
         edge_b, sides, node, weight_a, weight_b, points] = joint;
  for (int* number : {&a, &b, &property, &trace, &edge_a, &edge_b, &sides, &node[0], &node[1]})
    v.constant("joint", *number);
  v.constant("bonded", bonded);
  v.constant("scatter", scatter);
  v.constant("kind", kind);
  for (double* number : {&length, &weight_a, &weight_b}) v.constant("joint", *number);
  v.constant("normal", normal);
  v.constant("in_a", in_a);
  v.constant("in_b", in_b);
  v("state", state);
  v("mode", mode);
  v("crack", crack);
  v("failed_at", failed_at);
  for (BondTraction* traction : {&failed_with, &left_with}) {
    v("failed_with", traction->normal);
    v("failed_with", traction->shear);
  }
  v("utilisation", utilisation);
  v("remaining", remaining);
  v("most_opening", most_opening);
  v("most_slip", most_slip);
  v("off_path", off_path);
  v("path_turn", path_turn);
  v("bridged", bridged);
  v("points", points);
}

void visit_state(Strength& strength, StateVisitor& v) {
  auto& [friction, cohesion, tension] = strength;
  v("friction", friction);
  v("cohesion", cohesion);
  v("tension", tension);
}

void visit_state(Contact& contact, StateVisitor& v) {
  // coheres: begins anew with each search.
  [[maybe_unused]] auto& [i, vertex, j, edge, kind, state, property, joint, length, normal_stiffness, shear_stiffness,
                          gap, offset, height, slope, lies, stretch, slip, slid, normal_force, shear_force, may_part,
                          parts, lifted, parting, deeper, load_normal, load_shear, load_slip, load_climb, coheres,
                          global_vertex, global_edge] = contact;
  v("i", i);
  v("vertex", vertex);
  v("j", j);
  v("edge", edge);
  v("kind", kind);
  v("state", state);
  v("property", property);
  v("joint", joint);
  v("length", length);
  v("normal_stiffness", normal_stiffness);
  v("shear_stiffness", shear_stiffness);
  v("gap", gap);
  v("offset", offset);
  v("height", height);
  v("slope", slope);
  v("lies", lies);
  v("stretch", stretch);
  v("slip", slip);
  v("slid", slid);
  v("normal_force", normal_force);
  v("shear_force", shear_force);
  v("may_part", may_part);
  v("parts", parts);
  v("lifted", lifted);
  v("parting", parting);
  v("deeper", deeper);
  v("load_normal", load_normal);
  v("load_shear", load_shear);
  v("load_slip", load_slip);
  v("load_climb", load_climb);
  v("global_vertex", global_vertex);
  v("global_edge", global_edge);
}

void visit_state(Material& material, StateVisitor& v) {
  [[maybe_unused]] auto& [place, name, density, young, poisson, plane] = material;  // place, name: of the script
  v("density", density);
  v("young", young);
  v("poisson", poisson);
  v("plane", plane);
}

void visit_state(JointProperty& property, StateVisitor& v) {
  [[maybe_unused]] auto& [place, name, friction, cohesion, tension, bond, penalty, stiffness_kind, stiffness,
                          shear_ratio, restitution, breaks, residual, criterion, reduction, softening_compliance,
                          shear_compliance, weibull, seed] = property;
  // criterion, reduction with its compliances: settled by the script; weibull, seed: see Joint::scatter
  v("friction", friction);
  v("cohesion", cohesion);
  v("tension", tension);
  v("bond", bond);
  v("penalty", penalty);
  v("stiffness_kind", stiffness_kind);
  v("stiffness", stiffness);
  v("shear_ratio", shear_ratio);
  v("restitution", restitution);
  v.constant("breaks", breaks);
  v("residual", residual);
}

void visit_state(On& on, StateVisitor& v) {
  auto& [kind, from, to] = on;
  v("kind", kind);
  v("from", from);
  v("to", to);
}

void visit_state(Fixity& fixity, StateVisitor& v) {
  [[maybe_unused]] auto& [place, name, region, on, held, motion, value, spin, since, gone] = fixity;
  v.constant("region", region);
  v.constant("on", on);
  v.constant("held", held);
  v("motion", motion);
  v("value", value);
  v("spin", spin);
  v("since", since);
  v("gone", gone);
}

void visit_state(PointLoad& load, StateVisitor& v) {
  [[maybe_unused]] auto& [place, name, at, region, force] = load;
  v.constant("at", at);
  v.constant("region", region);
  v("force", force);
}

void visit_state(EdgeLoad& load, StateVisitor& v) {
  [[maybe_unused]] auto& [place, name, region, on, is_pressure, traction] = load;
  v.constant("region", region);
  v.constant("on", on);
  v.constant("is_pressure", is_pressure);
  v("traction", traction);
}

void visit_state(PointFixity& point, StateVisitor& v) {
  auto& [fixity, block, in_block] = point;
  v("fixity", fixity);
  v("block", block);
  v("in_block", in_block);
}

void visit_state(EdgeFixity& edge, StateVisitor& v) {
  auto& [fixity, block, in_block, normal, length] = edge;
  v("fixity", fixity);
  v("block", block);
  v("in_block", in_block);
  v("normal", normal);
  v("length", length);
}

void visit_state(ViscousEdge& edge, StateVisitor& v) {
  auto& [block, local, in_block, normal, length, traction] = edge;
  v.constant("block", block);
  v.constant("edge", local);
  v.constant("in_block", in_block);
  v.constant("normal", normal);
  v.constant("length", length);
  v("traction", traction);
}

void visit_state(PointForce& point, StateVisitor& v) {
  auto& [load, block, in_block, share] = point;
  v("load", load);
  v("block", block);
  v("in_block", in_block);
  v("share", share);
}

void visit_state(ProbePoint& point, StateVisitor& v) {
  auto& [probe, block, in_block, peak_speed, peak_at] = point;
  v.constant("probe", probe);
  v.constant("block", block);
  v.constant("in_block", in_block);
  v("peak_speed", peak_speed);
  v("peak_at", peak_at);
}

void visit_state(Peak& peak, StateVisitor& v) {
  auto& [block, value, at] = peak;
  v("block", block);
  v("value", value);
  v("at", at);
}

void visit_state(EdgeForce& edge, StateVisitor& v) {
  auto& [load, block, in_block] = edge;
  v("load", load);
  v("block", block);
  v("in_block", in_block);
}

// Of a region only what steps still read; the rest has become blocks, joints and their states.
void visit_state(Region& region, StateVisitor& v) {
  v("joint", region.joint);
  v("body_force", region.body_force);
}

}  // namespace talus
