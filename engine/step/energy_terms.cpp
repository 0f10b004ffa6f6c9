#include "step/energy_terms.h"

#include "scene/plan.h"

namespace talus {

namespace {

bool always(const Plan&) {
  return true;
}
bool with_dashpots(const Plan& plan) {
  return plan.viscous && plan.dynamic;
}
bool with_contacts(const Plan& plan) {
  return plan.contacts;
}

}  // namespace

std::span<const EnergyTerm> energy_terms() {
  static const std::vector<EnergyTerm> terms = {
      {"kinetic", "kinetic_energy", "kinetic", EnergyTerm::stored, &Energies::kinetic, "of what is not held", always},
      {"strain", "strain_energy", "strain", EnergyTerm::stored, &Energies::strain, "of blocks, bonds and supports",
       always},
      {"contact", "contact_energy", "contact springs", EnergyTerm::stored, &Energies::contact,
       "in the springs of contacts", with_contacts},
      {"gravity", "gravity_energy", "gravity", EnergyTerm::stored, &Energies::gravity,
       "of height, since the start, as velocities lead in (θ-½)Δt, where forces act: what falls has less than m g h, which numerical has more (theory, § 9)",
       [](const Plan& plan) { return plan.gravity; }},
      {"total", "total_energy", "total", EnergyTerm::sum, &Energies::total,
       "kinetic, strain, contact and gravity together", always},
      {"external", "external_work", "loads", EnergyTerm::put_in, &Energies::external,
       "work of loads and body forces, of what a script changes between steps, and in static runs of what is not in balance of an initial stress",
       [](const Plan& plan) { return plan.loads; }},
      {"gas", "gas_work", "gas", EnergyTerm::put_in, &Energies::gas, "work of explosion gas on the rock",
       [](const Plan& plan) { return plan.gas; }},
      {"boundary", "boundary_work", "moving supports", EnergyTerm::put_in, &Energies::boundary,
       "work of supports and held regions that move, and of what viscous boundaries carried at the start",
       [](const Plan& plan) { return plan.moving_supports || with_dashpots(plan); }},
      {"friction", "friction_work", "friction", EnergyTerm::lost, &Energies::friction,
       "lost to sliding, by the slide to where gravity's heights are: in long steps up to a twentieth more than is seen, which numerical has less",
       with_contacts},
      {"damping", "damping_work", "damping", EnergyTerm::lost, &Energies::damping,
       "taken by the dynamic parameter or a damping law", [](const Plan& plan) { return plan.damping; }},
      {"viscous", "viscous_work", "viscous boundaries", EnergyTerm::lost, &Energies::viscous,
       "absorbed by viscous boundaries", with_dashpots},
      {"fracture", "fracture_work", "fracture", EnergyTerm::lost, &Energies::fracture,
       "released by bonds that failed, and by static rock that jumps as they do",
       [](const Plan& plan) { return plan.fracture; }},
      {"numerical", "numerical_loss", "integrator", EnergyTerm::lost, &Energies::numerical,
       "lost to the integrator, by its formula, and lent by it; in static runs what contacts give off at once, less what lifts those that climb without friction",
       [](const Plan& plan) { return plan.dynamic || plan.contacts; }},
      {"unexplained", "unexplained_energy", "unexplained", EnergyTerm::rest, &Energies::unexplained,
       "what is left: total - its start - work put in + losses", always},
  };
  return terms;
}

std::vector<const EnergyTerm*> energy_terms(const Plan& plan) {
  return energy_terms(plan, {});
}

std::vector<const EnergyTerm*> energy_terms(const Plan& plan, const Energies& energies) {
  std::vector<const EnergyTerm*> present;
  for (const EnergyTerm& term : energy_terms())
    if (term.present(plan) || energies.*term.value != 0) present.push_back(&term);
  return present;
}

}  // namespace talus
