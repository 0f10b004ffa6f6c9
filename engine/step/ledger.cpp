#include "step/ledger.h"

#include <algorithm>
#include <cmath>

#include "contact/hand_over.h"
#include "equations/block_terms.h"
#include "equations/boundary_terms.h"
#include "equations/viscous_terms.h"
#include "step/energies.h"

namespace talus {

namespace {

template <int n>
ColumnOf<n> velocity_of(const Model& model, int block) {
  return model.blocks[block].velocity.column<n>();
}

// A block's unknowns along X, ΔX, and w (book_blocks).
using Motion = std::pair<ColumnOf<max_dofs>, ColumnOf<max_dofs>>;
Motion motion_of(const BookedStep& s, int block) {
  const BlockShape& shape = s.model.shapes[block];
  const auto& v0 = s.model.blocks[block].velocity;
  Motion motion{ColumnOf<max_dofs>::Zero(), ColumnOf<max_dofs>::Zero()};
  for (int k = 0; k < shape.dofs; ++k) {
    const double d = s.d[shape.dof_begin + k];
    motion.first[k] = s.scheme.step_v * v0[k] + s.scheme.move_d * d;
    motion.second[k] = s.scheme.bond_v * v0[k] + (s.scheme.bond_d - s.scheme.move_d / 2) * d;
  }
  return motion;
}

// In one pass, as of many blocks the states are more than caches hold: what gravity gives, and the loss of the linear
// forces along X. They are those of ȳ = (1-β) y0 + β y1; with X̄ = (X0 + X1)/2 and w = ȳ - X̄
//   -f·ΔX = U(X1) - U(X0) + ΔX·K w.
// K ΔX is nothing where a body turns as one, which the classic (θ-½) Δv·MΔv is not. K is what the system's matrix
// has beside inertia and dashpots. Those take ΔX·C ΔX/Δt.
void book_blocks(const BookedStep& s, Ledger& ledger) {
  const Model& model = s.model;
  const auto motion = [&s](int block) { return motion_of(s, block); };
  double all = 0, inertial = 0;
  for (const int b : model.awake_blocks()) {
    const BlockShape& shape = model.shapes[b];
    if (shape.dofs == 0) continue;
    const Motion own = motion_of(s, b);
    const auto& [step, w] = own;
    // at the centroid: on the translation alone, of any order
    ledger.gravity_work += model.mass(b) * model.scene.gravity.dot(step.head<2>());
    all += s.system.matrix.form(b, own, motion);
    with_size(shape.second_order(), [&](auto n) {
      inertial += step.template head<n>().dot(mass_matrix_of<n>(model, b) * w.template head<n>());
    });
  }
  const ViscousForms dashpots = viscous_forms(model, s.poses, motion);
  ledger.numerical_flow +=
      (all - s.scheme.inertia * inertial - s.scheme.velocity_d / 2 * dashpots.mixed) / s.scheme.bond_d;
  ledger.viscous_work += dashpots.own / s.scheme.dt;
}

double squared(double x) {
  return x * x;
}

}  // namespace

void visit_state(Ledger& ledger, StateVisitor& v) {
  auto& [ahead, gravity_work, external_work, gas_work, boundary_work, friction_work, damping_work, viscous_work,
         fracture_work, numerical_flow, unpaid, start_energy, start_shift, largest_work] = ledger;
  v("ahead", ahead);
  v("gravity_work", gravity_work);
  v("external_work", external_work);
  v("gas_work", gas_work);
  v("boundary_work", boundary_work);
  v("friction_work", friction_work);
  v("damping_work", damping_work);
  v("viscous_work", viscous_work);
  v("fracture_work", fracture_work);
  v("numerical_flow", numerical_flow);
  v("unpaid", unpaid);
  v("start_energy", start_energy);
  v("start_shift", start_shift);
  v("largest_work", largest_work);
}

void visit_state(Energies& energies, StateVisitor& v) {
  auto& [kinetic, strain, contact, gravity, total, external, gas, boundary, friction, damping, viscous, fracture,
         numerical, unexplained, scale] = energies;
  for (double* energy : {&kinetic, &strain, &contact, &gravity, &total, &external, &gas, &boundary, &friction, &damping,
                         &viscous, &fracture, &numerical, &unexplained, &scale})
    v("energy", *energy);
}

void Ledger::keep_largest() {
  for (const double work : {gravity_work, external_work, gas_work, boundary_work})
    largest_work = std::max(largest_work, std::abs(work));
}

double book_motion(const BookedStep& s, Ledger& ledger) {
  const Model& model = s.model;
  const double time = model.time + s.scheme.load_time, before = ledger.ahead, after = s.scheme.bond_ahead;
  // A load that puts `force` on a block: its work along y, and what of it the way from X to y takes or gives.
  const auto load = [&](int block, const auto& force, double& work) {
    constexpr int n = std::decay_t<decltype(force)>::RowsAtCompileTime;
    const ColumnOf<n> v0 = velocity_of<n>(model, block), d = of_block<n>(model.shapes[block], s.d);
    const double along_x = force.dot(motion_of(s, block).first.template head<n>());
    const double shift = force.dot(after * (v0 + s.scheme.velocity_d * d) - before * v0);
    work += along_x + shift;
    ledger.numerical_flow += shift;
  };
  const auto load_at = [&](int block, const LoadPoint& point, const Vec2& force, double& work) {
    with_size(model.shapes[block].second_order(),
              [&](auto n) { load(block, force_on<n>(s.poses.blocks[block], point, force), work); });
  };
  each_load(model, s.poses, time, [&](int block, const LoadPoint& point, const Vec2& force) {
    if (model.shapes[block].dofs > 0) load_at(block, point, force, ledger.external_work);
  });
  each_viscous_traction(model, s.poses, [&](int block, const LoadPoint& point, const Vec2& force) {
    load_at(block, point, force, ledger.boundary_work);
  });
  // along X, as the law's work is
  each_gas_load(model, s.poses, [&](int block, const LoadPoint& point, const Vec2& force) {
    if (model.shapes[block].dofs == 0) return;
    with_size(model.shapes[block].second_order(), [&](auto n) {
      ledger.gas_work +=
          force_on<n>(s.poses.blocks[block], point, force).dot(motion_of(s, block).first.template head<n>());
    });
  });
  const auto pushed = [](const Region& region) { return region.body_force[0].given() || region.body_force[1].given(); };
  if (std::ranges::any_of(model.scene.regions, pushed))
    for (const int b : model.awake_blocks()) {
      const BlockShape& shape = model.shapes[b];
      if (shape.dofs == 0 || !pushed(model.scene.regions[shape.region])) continue;
      DofColumn force = DofColumn::Zero();
      force.head<2>() = shape.area * body_force(model, shape.region, 0, time);
      load(b, force, ledger.external_work);
    }
  const Supports::Work moved = s.supports.work(model, s.poses, s.scheme, s.d, s.moved, before, after);
  ledger.boundary_work += moved.boundary;
  ledger.numerical_flow += moved.numerical;
  book_blocks(s, ledger);
  const JointTerms::Turning turning = s.joints.turning(model, s.poses, s.scheme, s.d, s.moved);
  ledger.numerical_flow += turning.loss;
  ledger.keep_largest();
  return moved.lift + turning.lift;
}

double pressed_at_start(const Contact& c) {
  return c.normal_force > 0 ? std::max(0.0, c.normal_force / c.normal_stiffness + c.deeper) : 0;
}

ContactBooking::ContactBooking(const Model& model) {
  for (const Contact& c : model.awake_contacts())
    before_.push_back({gap_now(model, c), pressed_at_start(c), c.stretch, c.slip});
}

// Loss of a contact along X: -N Δg less the spring's gain. For a gap that is linear in y this is the convexity gap
// N (p1 - p0) - ½ kn (p1² - p0²) >= 0 and N·ahead·Δġ; Δg is measured on the blocks as they lie, so that a contact
// on which a block pivots, whose gap does not change, loses nothing. What one that has taken over from
// another is pressed more or less than its force says is not the integrator's. In shear likewise
// ½ ks (Δstretch)² and -T·ahead·Δṡ, and |T|·Δslip is friction's.
void ContactBooking::book(const Model& model, const std::vector<ContactRows>& rows, const Scheme& scheme,
                          const Vector& d, Ledger& ledger) const {
  for (size_t k = 0; k < before_.size(); ++k) {
    const Contact& c = model.awake_contacts()[k];
    const Before& b = before_[k];
    if (c.normal_force > 0 || b.pressed > 0) {
      const double pressed = c.normal_force / c.normal_stiffness;
      const double slid = c.stretch - b.stretch + c.slip - b.slip;
      ledger.numerical_flow += -c.normal_force * (gap_now(model, c) - b.gap - c.slope * slid) -
                               c.normal_stiffness / 2 * (squared(pressed) - squared(b.pressed));
    }
    if (c.stretch != 0 || b.stretch != 0)
      ledger.numerical_flow += c.shear_stiffness / 2 * squared(c.stretch - b.stretch);
    if (c.state == ContactState::open) continue;
    const ContactRows& row = rows[k];
    ledger.numerical_flow -=
        c.shear_force * scheme.bond_ahead * (scheme.velocity_d * row.along(row.shear_i, row.shear_j, d) + row.faster);
    // Work of a held block that moves: against the force the contact puts on it.
    const auto held = [&](int block, const Row& normal, const Row& shear) {
      if (model.shapes[block].dofs > 0) return;
      const double* v = model.blocks[block].velocity.data();
      ledger.boundary_work -=
          scheme.step_v * (c.normal_force * dot(normal, v, rigid_dofs) - c.shear_force * dot(shear, v, rigid_dofs));
    };
    held(c.i, row.normal_i, row.shear_i);
    held(c.j, row.normal_j, row.shear_j);
  }
  for (size_t k = 0; k < before_.size(); ++k) {
    const Contact& c = model.awake_contacts()[k];
    if (c.state == ContactState::slip) ledger.friction_work += std::abs(c.shear_force * (c.slip - before_[k].slip));
  }
  ledger.keep_largest();
}

std::vector<Vec2> support_reactions(const Model& model, const Supports& supports, double time) {
  std::vector<Vec2> sum = supports.reactions(model, time);
  for (const Contact& c : model.contacts) {
    const Vec2 on_i = contact_push(model, c);
    if (model.held_by[c.i] >= 0) sum[model.held_by[c.i]] -= on_i;
    if (model.held_by[c.j] >= 0) sum[model.held_by[c.j]] += on_i;
  }
  return sum;
}

BridgeBooking::BridgeBooking(const Model& model) {
  for (size_t j = 0; j < model.joints.size(); ++j)
    if (model.joints[j].bridged) before_.emplace_back(int(j), model.joints[j]);
}

void BridgeBooking::book(const Model& model, Ledger& ledger) const {
  double taken = 0;
  for (const auto& [j, then] : before_) taken += bridge_work(model.joints[j], then);
  book(model, taken, ledger);
}

void BridgeBooking::book(const Model& model, double taken, Ledger& ledger) const {
  ledger.fracture_work += taken;
  for (const auto& [j, then] : before_) ledger.fracture_work -= bridge_energy(model.joints[j]) - bridge_energy(then);
}

double Ledger::pay(double lost) {
  const double before = unpaid;
  unpaid = std::max(0.0, unpaid - std::max(0.0, lost));
  return before - unpaid;
}

}  // namespace talus
