#pragma once
// The energies of the model's present state, J per metre of thickness. `ahead`: seconds along the present
// velocities, to the places y at which the integrator's forces act (docs/theory.md, "Energy").
#include <span>

#include "equations/joint_terms.h"
#include "equations/supports.h"

namespace talus {

// ½ vᵀM v of what can move, spin with the moment of inertia of the block as it is strained at y: angular momentum
// I(e)s of the mean spin is kept (step/update.cpp), and ½Is² changes by the work of the centrifugal forces. Held blocks
// are not counted.
double kinetic_energy(const Model& model, double ahead);
double kinetic_energy(const Model& model, int block, double ahead);

// A (½ ε·Dε + σ0·ε) of the blocks that are awake, and the potentials of bonds and supports.
double strain_energy(const Model& model, const JointTerms& joints, const Supports& supports, double ahead);

Vec2 contact_push(const Model& model, const Contact& contact);  // N/m, on the corner
double contact_energy(std::span<const Contact> contacts);
int closed_contacts(std::span<const Contact> contacts);

// What is asleep stores, and how many of its contacts are closed: it does not change while it sleeps.
struct Asleep {
  double strain = 0, contact = 0;  // J/m, strain of the blocks
  int closed = 0;
};
Asleep stored_asleep(const Model& model);

// what the initial stress can give: ½ A σ₀·D⁻¹σ₀ of blocks that strain
double initial_stress_energy(const Model& model);
double gravity_energy_ahead(const Model& model, double ahead);  // of the way from X to y: -m g·v ahead

}  // namespace talus
