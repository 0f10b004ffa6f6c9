#include "step/step_parts.h"

#include <algorithm>

#include "equations/block_terms.h"
#include "equations/boundary_terms.h"
#include "equations/viscous_terms.h"
#include "step/part_timer.h"

namespace talus {

StepParts::StepParts(Model& of, const Plan& its_plan, RunTotals& counts, Ledger& energy)
    : model(of), plan(its_plan), totals(counts), ledger(energy) {
  for (const BlockShape& shape : model.shapes) block_sizes_.push_back(shape.dofs);
  if (plan.fracture) fracture = std::make_unique<Fracture>(model);
  if (plan.gas) gas = std::make_unique<Gas>(model);
}

void StepParts::prepare_bonds() {
  if (revision_ == model.revision) return;
  revision_ = model.revision;
  if (plan.bonds || plan.fixities) joints.prepare(model);
  if (plan.fixities) supports.prepare(model, joints.ground_stiffness());
  if (fracture) transit_ = fracture->least_transit();
}

void StepParts::assemble(const Scheme& scheme, const ContactChoice& choice) {
  StepTimer timer(totals, "assembly");
  prepare_bonds();
  poses.predict(model, scheme);
  const bool plain =
      scheme.dt > 0 && !fracture && choice.pressed == ContactTerms::least_pressed && choice.nearness.empty();
  // of the same dt, as the search was
  linked_as_before_ = plain && plain_ && search.found_as_before() && islands.all_rest();
  plain_ = plain;
  if (!linked_as_before_) link(scheme, choice);
  system.clear(model);
  add_block_terms(model, poses, scheme, system);
  if (plan.bonds) joints.add(model, poses, scheme, system);
  if (plan.fixities) supports.add(model, poses, scheme, system);
  if (plan.viscous) add_viscous_edges(model, poses, scheme, system);
  add_loads(model, poses, scheme, system);
  for (const auto& term : terms) term->add(model, poses, scheme, system);
}

// What may press on what: rows of contacts, the pattern of the matrix, islands.
void StepParts::link(const Scheme& scheme, const ContactChoice& choice) {
  std::vector<std::pair<int, int>> pairs;
  for (const Joint& joint : model.joints)
    if (ties(joint) && !model.sleeps(joint.a) && !model.sleeps(joint.b)) pairs.push_back({joint.a, joint.b});
  if (plan.contacts) contacts.linearise(model, poses, scheme, choice.stick, choice.nearness, choice.pressed);
  for (const ContactRows& row : contacts.rows())
    if (row.near) pairs.push_back({row.i, row.j});
  std::vector<int> with_entries;
  std::ranges::copy(model.awake_blocks(), std::back_inserter(with_entries));
  if (system.matrix.set_pattern(block_sizes_, std::move(pairs), std::move(with_entries)) && plan.bonds)
    joints.find_slots(model, system.matrix);
  islands.find(model, contacts, !model.scene.numerics.islands);
}

// The same forces on contacts as they were: the residual that the last step was accepted with.
bool StepParts::balances_as_before() const {
  return linked_as_before_ && system.force == at_rest_.force && system.force_scale == at_rest_.scale &&
         system.force_rounding == at_rest_.rounding;
}

IslandResult StepParts::solve(double dt, double most_effort, Vector& d) {
  StepTimer timer(totals, "open-close and solve");
  const Numerics& numerics = model.scene.numerics;
  const bool motion = dt > 0;
  if (motion && balances_as_before()) return islands.rest_on(system, d);
  // Equilibrium is judged once more afterwards, by scales of its own.
  const double tolerance =
      motion ? numerics.contact_tolerance : std::min(numerics.contact_tolerance, 0.1 * numerics.static_tolerance);
  const OpenCloseSettings settings{tolerance, numerics.max_iterations, motion, numerics.solver, most_effort};
  const IslandResult result = islands.solve(model, system, contacts, settings, dt, d);
  totals.iterations += result.solves;
  totals.sweeps += result.sweeps;
  totals.splittings += result.splittings;
  totals.pivots += result.pivots;
  totals.factorisations += result.factorisations;
  totals.largest_iterations = std::max(totals.largest_iterations, result.iterations);
  if (plain_ && islands.all_rest())
    at_rest_ = {system.force, system.force_scale, system.force_rounding};
  else
    at_rest_ = {};
  return result;
}

const std::vector<int>& StepParts::fractures() const {
  static const std::vector<int> none;
  return fracture ? fracture->events() : none;
}

std::vector<Vec2> StepParts::reactions() {
  prepare_bonds();
  return support_reactions(model, supports, model.time);
}

void StepParts::visit_state(StateVisitor& visitor) {
  visitor("contact_search", search);
  visitor("sleep", sleep);
  visitor("islands", islands);
  if (gas) visitor("gas", *gas);
}

void StepParts::restored() {
  revision_ = -1;
  // the state may be of a run that let things sleep
  if (!model.scene.numerics.sleeping || !plan.dynamic) model.changed();
}

void StepParts::rewound() {
  search.forget(model);
  sleep.restored();
  if (fracture) fracture->restored();
  if (gas) gas->restored();
}

}  // namespace talus
