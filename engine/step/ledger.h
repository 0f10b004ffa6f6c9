#pragma once
// Where the energy of a run comes from and where it goes, J per metre of thickness. docs/theory.md, "Energy",
// derives it.
//
// An accepted step changes the kinetic energy by exactly F·ΔX, the work of the forces F it was solved with along
// ΔX = Δt (v0 + v1)/2. What each force gives is booked here from the solution; what is stored is read off the
// state. All energies are those of the places y = X + ahead·v at which the integrator's forces act, ahead =
// (θ-½)Δt. The integrator's own loss is booked by its formula, term by term, never as what is left; what is left
// is `unexplained`: finite rotations, contacts that hand over, the solver's residual.
#include <algorithm>

#include "equations/bridge_terms.h"
#include "equations/contact_terms.h"
#include "equations/joint_terms.h"
#include "equations/supports.h"
#include "model/state_visitor.h"

namespace talus {

// Accumulated since the start of the run.
struct Ledger {
  // s, from X to y over the velocity: of the last accepted step, and from change_step() on of the one attempted
  double ahead = 0;
  double gravity_work = 0;  // along X
  // loads and body forces, along y; an initial stress out of balance (static); what the script changes in motion
  double external_work = 0;
  double gas_work = 0;        // explosion gas, along X
  double boundary_work = 0;   // moving supports and held blocks; what viscous boundaries carried at the start
  double friction_work = 0;   // dissipated
  double damping_work = 0;    // taken by the dynamic parameter or a damping law
  double viscous_work = 0;    // absorbed by viscous boundaries
  double fracture_work = 0;   // released by bonds that failed, and by static rock that jumps as they do
  double numerical_flow = 0;  // the integrator's loss but for what is read off the state (start_shift)
  // by which steps of another length, and paths that bend, have lifted y, and which is not counted as energy until
  // losses have paid for it (theory, § 9)
  double unpaid = 0;
  double start_energy = 0;  // kinetic and stored, at y
  double start_shift = 0;   // strain and gravity energy at y less those at X
  // largest magnitude of gravity, external, gas or boundary work so far; in motion at least what an initial stress can
  // give
  double largest_work = 0;

  double scale() const { return std::max(start_energy, largest_work); }  // that errors are measured by
  void keep_largest();                                                   // after works have been booked
  double pay(double lost);  // what is unpaid, by what a step has lost; returns what that adds to the total energy
};
void visit_state(Ledger& ledger, StateVisitor& visitor);  // the registry, model/registry.h

// What has come and gone, in one row of the history.
struct Energies {
  double kinetic = 0, strain = 0, contact = 0, gravity = 0;                    // stored; gravity: since the start
  double total = 0;                                                            // their sum
  double external = 0, gas = 0, boundary = 0;                                  // put in since the start
  double friction = 0, damping = 0, viscous = 0, fracture = 0, numerical = 0;  // lost since the start
  double unexplained = 0;                                                      // total - start - put in + lost
  double own() const { return total - external - gas - boundary; }             // that no step raises
  double stored() const { return kinetic + strain + contact; }
  double scale = 0;  // the larger of kinetic and stored energy at the start and the largest work put in
};
void visit_state(Energies& energies, StateVisitor& visitor);

struct BookedStep {  // what an accepted step was solved with; the model is still as before it
  const Model& model;
  const Poses& poses;
  const System& system;
  const JointTerms& joints;
  const Supports& supports;
  const Scheme& scheme;
  const Vector& d;
  const std::vector<BlockState>& moved;  // the blocks after it
};

// Forces that do not come from contacts, and the loss of bulk, bonds and supports. Returns what bonds and supports lift
// y by where blocks turn, J/m (step/turning.h).
double book_motion(const BookedStep& step, Ledger& ledger);

// m, by which a contact's spring is pressed as a step begins: by its force, and where it has taken over from another as
// much more as it lies deeper.
double pressed_at_start(const Contact& contact);

// Contacts of what is awake before and after a step.
class ContactBooking {
 public:
  explicit ContactBooking(const Model& model);
  // The model is that after the step, with the contacts' new forces; `d` and `rows` are the step's.
  void book(const Model& model, const std::vector<ContactRows>& rows, const Scheme& scheme, const Vector& d,
            Ledger& ledger) const;

 private:
  struct Before {
    double gap, pressed, stretch, slip;  // m
  };
  std::vector<Before> before_;
};

// What softening bonds take, beside what their bridges store.
class BridgeBooking {
 public:
  explicit BridgeBooking(const Model& model);
  void book(const Model& model, Ledger& ledger) const;  // work of the mean tractions along the jumps
  void book(const Model& model, double taken, Ledger& ledger) const;

 private:
  std::vector<std::pair<int, Joint>> before_;
};

// N/m per fixity, as Supports::reactions: on what it holds by points and edges, and on what its held blocks touch.
std::vector<Vec2> support_reactions(const Model& model, const Supports& supports, double time);

}  // namespace talus
