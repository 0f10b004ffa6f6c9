// The energies of a step's model: read off its state, and taken from the ledger.
#include <utility>

#include "equations/viscous_terms.h"
#include "step/step.h"

namespace talus {

namespace {

class Unstressed {  // blocks without their initial stress, while this lives
 public:
  explicit Unstressed(Model& model) : model_(model), quadratic_(model.quadratic_shapes) {
    for (BlockShape& shape : model.shapes) stress_.push_back(std::exchange(shape.initial_stress, Vec3::Zero()));
    for (QuadraticShape& shape : model.quadratic_shapes) shape.stress_x = shape.stress_y = Vec3::Zero();
  }
  ~Unstressed() {
    model_.quadratic_shapes = std::move(quadratic_);
    for (size_t b = 0; b < stress_.size(); ++b) model_.shapes[b].initial_stress = stress_[b];
  }
  Unstressed(const Unstressed&) = delete;
  Unstressed& operator=(const Unstressed&) = delete;

 private:
  Model& model_;
  std::vector<QuadraticShape> quadratic_;
  std::vector<Vec3> stress_;
};

}  // namespace

void Stepper::begin_ledger() {
  ledger_ = {};
  if (plan_.dynamic) ledger_.ahead = scheme(step_size_.next(model_.time)).bond_ahead;
  for (BlockState& state : model_.blocks) state.weighed_ahead = 0;
  if (plan_.fixities && ledger_.ahead > 0) {
    prepare_bonds();
    model_.support_gaps = supports_.gaps(model_, ledger_.ahead);
  }
  const Energies now = energies();
  ledger_.start_energy = now.total;
  ledger_.start_shift = -now.numerical;
}

double Stepper::elastic_energy(double ahead) {
  double sum = strain_energy(model_, joints_, supports_, ahead) + sleep_.stored(model_).strain;
  for (const auto& term : terms) sum += term->energy(model_, ahead);
  return sum;
}

// The energy stored is linear in an initial stress, which grows in the first load step as the loads do: half of what it has put in.
void Stepper::book_load(const LoadStepBooking& booking, bool first) {
  if (first && plan_.initial_stress) {
    const double all = energies().strain;
    const Unstressed unstressed(model_);
    ledger_.external_work += (all - energies().strain) / 2;
  }
  booking.book(model_, supports_, ledger_);
}

int Stepper::closed_contacts() { return sleep_.stored(model_).closed + talus::closed_contacts(model_.awake_contacts()); }

Energies Stepper::energies() {
  prepare_bonds();
  const double ahead = ledger_.ahead, gravity_ahead = gravity_energy_ahead(model_);
  Energies e;
  e.kinetic = plan_.dynamic ? kinetic_energy(model_, ahead) : 0;
  e.strain = elastic_energy(ahead);
  if (!plan_.dynamic) e.strain += viscous_hold_energy(model_);
  e.contact = contact_energy(model_.awake_contacts()) + sleep_.stored(model_).contact;
  e.gravity = gravity_ahead - ledger_.gravity_work;
  e.total = e.kinetic + e.strain + e.contact + e.gravity;
  e.external = ledger_.external_work;
  e.gas = ledger_.gas_work;
  e.boundary = ledger_.boundary_work;
  e.friction = ledger_.friction_work;
  e.damping = ledger_.damping_work;
  e.viscous = ledger_.viscous_work;
  e.fracture = ledger_.fracture_work;
  double shift = gravity_ahead;  // at y less at X: part of the integrator's loss that needs no booking
  if (ahead != 0)
    shift += e.strain - elastic_energy(0) + e.kinetic - kinetic_energy(model_, 0);
  e.numerical = ledger_.numerical_flow - (shift - ledger_.start_shift);
  e.unexplained = e.total - ledger_.start_energy - e.external - e.gas - e.boundary + e.friction + e.damping + e.viscous +
                  e.fracture + e.numerical;
  e.scale = ledger_.scale();
  return e;
}

}  // namespace talus
