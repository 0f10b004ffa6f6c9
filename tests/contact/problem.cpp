#include "problem.h"

#include <algorithm>
#include <cmath>

#include "step/energies.h"
#include "step/part_timer.h"
#include "step/update.h"

namespace talus::study {

namespace {

// Of blocks, places and speeds; contacts are added by the caller. Scenes of the study have no bonds and no
// supports.
double energy_of(const Model& model, double ahead) {
  double sum = kinetic_energy(model, ahead) + strain_energy(model, {}, {}, ahead);
  for (size_t b = 0; b < model.blocks.size(); ++b) {
    const BlockState& state = model.blocks[b];
    if (model.shapes[b].dofs > 0)
      sum -= model.mass(int(b)) *
             model.scene.gravity.dot(state.shift + ahead * Vec2(state.velocity[0], state.velocity[1]));
  }
  return sum;
}

}  // namespace

double Problem::energy() const {
  return energy_of(model, scheme.bond_ahead) + contact_energy(model.contacts);
}

double Problem::energy(const Vector& d) const {
  Model after = model;
  after.blocks = moved_blocks(model, scheme, d);
  double sum = energy_of(after, scheme.bond_ahead);
  for (const ContactRows& row : contacts.rows()) {
    const double gap = row.gap0 + contacts.factor() * row.along(row.normal_i, row.normal_j, d);
    const double slide = row.slide0 + contacts.factor() * row.along(row.shear_i, row.shear_j, d);
    const double normal = row.kn * std::max(0.0, -gap), limit = Desk::limit(row, normal);
    const double shear = std::clamp(row.ks * slide, -limit, limit);
    sum += normal * normal / (2 * row.kn) + shear * shear / (2 * row.ks);
  }
  return sum;
}

Desk::Desk(const Problem& given) : problem(given), matrix_(given.system.matrix) {
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k)
    if (rows[k].near) near_.push_back(k);
  for (size_t k = 0; k < count(); ++k)
    slots_.push_back({matrix_.slot(contact(k).i, contact(k).i), matrix_.slot(contact(k).j, contact(k).j),
                      matrix_.slot(contact(k).i, contact(k).j)});
  solver_.analyse(matrix_);
  std::vector<int> place(problem.model.shapes.size());
  Islands islands;
  islands.find(problem.model, problem.contacts, true);
  whole_.take(problem.model, problem.system, problem.contacts, islands.blocks(0), islands.rows(0), place);
  whole_.take_matrix(problem.system, place);
}

void Desk::places(const Vector& d, std::vector<double>& gap, std::vector<double>& slide, bool rate) const {
  gap.resize(count());
  slide.resize(count());
  for (size_t k = 0; k < count(); ++k) {
    const ContactRows& r = row(k);
    gap[k] = (rate ? 0 : r.gap0) + factor() * r.along(r.normal_i, r.normal_j, d);
    slide[k] = (rate ? 0 : r.slide0) + factor() * r.along(r.shear_i, r.shear_j, d);
  }
}

Vector Desk::product(const Vector& x) const {
  Vector y = Vector::Zero(x.size());
  problem.system.matrix.multiply(x, y);
  return y;
}

Vector Desk::out_of_balance(const Vector& d, const std::vector<double>& normal,
                            const std::vector<double>& shear) const {
  Vector r = problem.system.force - product(d);
  for (size_t k = 0; k < count(); ++k) {
    if (normal[k] != 0) row(k).add(row(k).normal_i, row(k).normal_j, normal[k], r);
    if (shear[k] != 0) row(k).add(row(k).shear_i, row(k).shear_j, -shear[k], r);
  }
  return r;
}

double Desk::usual_length() const {
  double sum = 0;
  for (size_t k = 0; k < count(); ++k) sum += std::max(0.0, -row(k).gap0);
  return std::max(sum / double(count()), 1e-3 * usual_force() / row(0).kn);
}

// The larger of what loads a block and of what it takes to move it by the usual overlap within the step.
double Desk::usual_force() const {
  const auto& shapes = problem.model.shapes;
  double load = 0, inertia = 0, overlap = 0;
  int moving = 0;
  for (size_t b = 0; b < shapes.size(); ++b) {
    if (shapes[b].dofs == 0) continue;
    DofMatrix k = DofMatrix::Identity();
    problem.system.matrix.diagonal(int(b), k);
    load += problem.system.force_scale[b];
    inertia += k(0, 0);
    ++moving;
  }
  for (size_t k = 0; k < count(); ++k) overlap += std::max(0.0, -row(k).gap0) / double(count());
  return std::max(load, inertia * overlap) / std::max(1, moving);
}

double Desk::judge(const Vector& d) {
  if (!d.allFinite()) return std::numeric_limits<double>::infinity();
  const OpenCloseResult result = judge_.judge(whole_, d);
  if (result.residual < outcome.residual) {
    outcome.residual = result.residual;
    outcome.d = d;
  }
  outcome.converged = outcome.residual <= problem.model.scene.numerics.contact_tolerance;
  return result.residual;
}

void Desk::add(size_t k, double weight, const Row& i, const Row& j) {
  const Slots& slots = slots_[k];
  const double w = factor() * weight;
  if (row(k).size_i) matrix_.add_outer(slots.ii, w, i.data(), i.data());
  if (row(k).size_j) matrix_.add_outer(slots.jj, w, j.data(), j.data());
  if (!row(k).size_i || !row(k).size_j) return;
  const bool i_is_row = slots.ij.row == slots.ii.row;
  matrix_.add_outer(slots.ij, w, i_is_row ? i.data() : j.data(), i_is_row ? j.data() : i.data());
}

bool Desk::factorise(const std::vector<double>& normal, const std::vector<double>& shear,
                     const std::vector<double>* cross) {
  matrix_.values = problem.system.matrix.values;
  for (size_t k = 0; k < count(); ++k) {
    const ContactRows& r = row(k);
    const double c = cross ? (*cross)[k] : 0;
    if (normal[k] != c) add(k, normal[k] - c, r.normal_i, r.normal_j);
    if (shear[k] != c) add(k, shear[k] - c, r.shear_i, r.shear_j);
    if (c == 0) continue;  // n sᵀ + s nᵀ = (n + s)(n + s)ᵀ - n nᵀ - s sᵀ
    Row i, j;
    for (int q = 0; q < first_order_dofs; ++q) {  // no problem has blocks of second order
      i[q] = r.normal_i[q] + r.shear_i[q];
      j[q] = r.normal_j[q] + r.shear_j[q];
    }
    add(k, c, i, j);
  }
  ++outcome.factorisations;
  return solver_.factor(matrix_) < 0;
}

BareCost bare_cost(const Problem& problem, int times) {
  Desk desk(problem);
  std::vector<double> kn, ks;
  for (size_t k = 0; k < desk.count(); ++k) {
    kn.push_back(desk.row(k).kn);
    ks.push_back(desk.row(k).ks);
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  BareCost least{infinity, infinity};
  Vector x;
  desk.factorise(kn, ks);  // assembly is not counted
  for (int i = 0; i < times; ++i) {
    const double start = cpu_seconds();
    desk.analyse_again();
    desk.refactorise();
    desk.solve(problem.system.force, x);
    const double analysed = cpu_seconds();
    desk.refactorise();
    desk.solve(problem.system.force, x);
    least.fresh = std::min(least.fresh, analysed - start);
    least.known = std::min(least.known, cpu_seconds() - analysed);
  }
  return least;
}

}  // namespace talus::study
