#include "scene/plan.h"

#include <algorithm>

#include "model/disjoint_sets.h"
#include "model/model.h"

namespace talus {

namespace {

// Bodies that hang together by intact joints: contacts are looked for only where there is more than one, or
// where a joint is open.
int count_bodies(const Model& model) {
  DisjointSets bodies(model.shapes.size());
  for (const Joint& joint : model.joints)
    if (joint.state == JointState::intact) bodies.join(joint.a, joint.b);
  int count = 0;
  for (int b = 0; b < int(model.shapes.size()); ++b) count += bodies.root(b) == b;
  return count;
}

template <class Is>
bool any_load(const Scene& scene, Is is) {
  const auto either = [&](const std::array<History, 2>& of) { return is(of[0]) || is(of[1]); };
  return std::ranges::any_of(scene.point_loads, [&](const PointLoad& load) { return either(load.force); }) ||
         std::ranges::any_of(scene.edge_loads, [&](const EdgeLoad& load) { return either(load.traction); }) ||
         std::ranges::any_of(scene.regions, [&](const Region& region) { return either(region.body_force); });
}

std::string count_text(size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

bool moves_supports(const Scene& scene) {
  return std::any_of(scene.fixities.begin(), scene.fixities.end(),
                     [](const Fixity& fixity) { return fixity.motion != Fixity::none || fixity.spin != 0; });
}

bool loads_change(const Scene& scene) {
  return moves_supports(scene) || any_load(scene, [](const History& of) { return !of.constant(); });
}

bool loaded_from_start(const Scene& scene) {
  return !scene.gravity.isZero(0) || any_load(scene, [](const History& of) { return of.at(0) != 0; });
}

Plan make_plan(const Model& model) {
  Plan plan;
  const Scene& scene = model.scene;
  const auto any_body_force = [](const Region& region) {
    return region.body_force[0].given() || region.body_force[1].given();
  };
  plan.dynamic = scene.time.mode == Mode::dynamic;
  const auto bonded = [](const Joint& joint) { return joint.bonded; };
  const auto breakable = [&](const Joint& joint) { return joint.bonded && scene.properties[joint.property].breaks; };
  plan.bonds = std::any_of(model.joints.begin(), model.joints.end(), bonded);
  const auto breakable_count = std::count_if(model.joints.begin(), model.joints.end(), breakable);
  plan.fracture = breakable_count > 0;
  plan.contacts = count_bodies(model) > 1 || !model.pair_property.empty() || plan.fracture;
  plan.fixities = !model.edge_fixities.empty() || !model.point_fixities.empty();
  plan.viscous = !model.viscous_edges.empty();
  plan.point_loads = !model.point_forces.empty();
  plan.edge_loads = !model.edge_forces.empty();
  plan.body_forces =
      scene.gravity != Vec2::Zero() || std::any_of(scene.regions.begin(), scene.regions.end(), any_body_force);
  plan.gravity = scene.gravity != Vec2::Zero();
  plan.initial_stress = !plan.dynamic && std::any_of(scene.regions.begin(), scene.regions.end(),
                                                     [](const Region& region) { return region.stress.has_value(); });
  plan.loads = plan.point_loads || plan.edge_loads || plan.initial_stress ||
               std::any_of(scene.regions.begin(), scene.regions.end(), any_body_force);
  plan.moving_supports = moves_supports(scene);
  plan.restitution = plan.dynamic && plan.contacts &&
                     std::any_of(scene.properties.begin(), scene.properties.end(),
                                 [](const JointProperty& p) { return p.restitution < 1; });
  plan.damping = plan.restitution ||
                 (plan.dynamic && (scene.numerics.damping || (scene.numerics.integrator == Integrator::newmark &&
                                                              scene.numerics.dynamic_parameter < 1)));
  plan.held_blocks = !model.held_blocks.empty();
  plan.recovery = scene.numerics.recovery && plan.bonds;

  const auto count_order = [&model](int dofs) {
    return std::count_if(model.shapes.begin(), model.shapes.end(), [dofs](const auto& s) { return s.dofs == dofs; });
  };
  const auto line = [&plan](bool present, const std::string& part, const std::string& text) {
    if (present) plan.lines.push_back({part, text});
  };
  const auto second = count_order(second_order_dofs);
  line(true, "blocks",
       count_text(model.shapes.size(), "block") + ": " +
           (second > 0 ? std::to_string(second) + " second order, " : "") +
           std::to_string(count_order(first_order_dofs)) + " first order, " + std::to_string(count_order(rigid_dofs)) +
           " rigid, " + std::to_string(count_order(0)) + " held; " + count_text(size_t(model.dofs), "unknown"));
  line(true, "mode",
       plan.dynamic ? (scene.numerics.integrator == Integrator::theta ? "dynamic, velocity theta-scheme"
                                                                      : "dynamic, Newmark (1/2, 1)")
                    : "static equilibrium, " + count_text(size_t(scene.time.steps), "load step"));
  plan.step_error = plan.dynamic && scene.time.tolerance > 0;
  line(plan.step_error, "step error", "each step again as two halves");
  const auto exact = std::count_if(model.joints.begin(), model.joints.end(),
                                   [](const Joint& j) { return j.bonded && j.kind == BondKind::exact; });
  const auto bonds = std::count_if(model.joints.begin(), model.joints.end(), bonded);
  line(plan.bonds, "bonds",
       std::to_string(exact) + " exact (Nitsche), " + std::to_string(bonds - exact) + " by springs");
  line(plan.fracture, "fracture", count_text(size_t(breakable_count), "bond") + " that can fail");
  plan.gas = !model.hole_walls.empty() && plan.dynamic;
  line(plan.gas, "gas", count_text(model.hole_walls.size(), "charge"));
  line(plan.contacts, "contacts",
       std::string("search, open-close, Coulomb friction") + (plan.restitution ? ", limited restitution" : ""));
  line(plan.fixities, "fixities",
       count_text(model.edge_fixities.size(), "edge") + ", " + count_text(model.point_fixities.size(), "point"));
  line(plan.viscous, "viscous boundaries",
       count_text(model.viscous_edges.size(), "edge") +
           (plan.dynamic ? "" : ", held: nothing moves that they could absorb"));
  line(plan.point_loads, "point loads", count_text(model.point_forces.size(), "block"));
  line(plan.edge_loads, "edge loads", count_text(model.edge_forces.size(), "edge"));
  line(plan.body_forces, "body forces", "gravity or body force");
  line(plan.recovery, "stress recovery", "for output, probes and checks");
  return plan;
}

}  // namespace talus
