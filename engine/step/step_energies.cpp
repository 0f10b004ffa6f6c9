// The energies of a step's model: read off its state, and taken from the ledger.
#include "equations/viscous_terms.h"
#include "step/energies.h"
#include "step/step_parts.h"

namespace talus {

void StepParts::begin_ledger(double ahead) {
  ledger = {};
  ledger.ahead = ahead;
  if (plan.fixities && ledger.ahead > 0) {
    prepare_bonds();
    model.support_gaps = supports.gaps(model);
  }
  const Energies now = energies();
  ledger.start_energy = now.total;
  ledger.start_shift = -now.numerical;
  if (plan.dynamic) ledger.largest_work = initial_stress_energy(model);
}

double StepParts::elastic_energy(double ahead) {
  double sum = strain_energy(model, joints, supports, ahead) + sleep.stored(model).strain;
  for (const auto& term : terms) sum += term->energy(model, ahead);
  return sum;
}

int StepParts::closed_contacts() {
  return sleep.stored(model).closed + talus::closed_contacts(model.awake_contacts());
}

Energies StepParts::energies() {
  prepare_bonds();
  const double ahead = ledger.ahead, gravity_ahead = gravity_energy_ahead(model, ahead) - ledger.unpaid;
  Energies e;
  e.kinetic = plan.dynamic ? kinetic_energy(model, ahead) : 0;
  e.strain = elastic_energy(ahead);
  if (!plan.dynamic) e.strain += viscous_hold_energy(model);
  e.contact = contact_energy(model.awake_contacts()) + sleep.stored(model).contact;
  e.gravity = gravity_ahead - ledger.gravity_work;
  e.total = e.kinetic + e.strain + e.contact + e.gravity;
  e.external = ledger.external_work;
  e.gas = ledger.gas_work;
  e.boundary = ledger.boundary_work;
  e.friction = ledger.friction_work;
  e.damping = ledger.damping_work;
  e.viscous = ledger.viscous_work;
  e.fracture = ledger.fracture_work;
  double shift = gravity_ahead;  // at y less at X: part of the integrator's loss that needs no booking
  if (ahead != 0) shift += e.strain - elastic_energy(0) + e.kinetic - kinetic_energy(model, 0);
  e.numerical = ledger.numerical_flow - (shift - ledger.start_shift);
  e.unexplained = e.total - ledger.start_energy - e.external - e.gas - e.boundary + e.friction + e.damping + e.viscous +
                  e.fracture + e.numerical;
  e.scale = ledger.scale();
  return e;
}

}  // namespace talus
