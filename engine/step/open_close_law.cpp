// The law of open–close: gaps, forces, residual, and what it is judged by.
#include "step/open_close.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

// A block's residual is measured against the forces that meet in it, but not below this part of the largest
// such sum in the scene: round-off of the large forces reaches every block through the factor.
constexpr double force_floor = 1e-4;

}  // namespace

double OpenClose::friction_limit(const ContactRows& row, double normal) const {
  return normal > 0 ? (std::isinf(row.friction) ? row.friction : row.friction * normal) + row.cohesion : 0;
}

void OpenClose::evaluate(const ContactTerms& contacts, const Vector& d) {
  const auto& rows = contacts.rows();
  missed_ = false;
  for (size_t k = 0; k < rows.size(); ++k) {
    gap_[k] = rows[k].gap0 + contacts.factor() * rows[k].along(rows[k].normal_i, rows[k].normal_j, d);
    slide_[k] = rows[k].slide0 + contacts.factor() * rows[k].along(rows[k].shear_i, rows[k].shear_j, d);
    closed_[k] = rows[k].near && gap_[k] <= 0;
    missed_ = missed_ || (!rows[k].near && gap_[k] < 0);
  }
}

void OpenClose::residual(const System& system, const ContactTerms& contacts, bool coupled, Vector& r) const {
  r = system.force - kd_;
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const double normal = normal_force(rows[k], k);
    const double limit = coupled ? friction_limit(rows[k], normal) : limit_[k];
    if (normal > 0) rows[k].add(rows[k].normal_i, rows[k].normal_j, normal, r);
    if (limit > 0) rows[k].add(rows[k].shear_i, rows[k].shear_j, -std::clamp(rows[k].ks * slide_[k], -limit, limit), r);
  }
}

void OpenClose::start(const Model& model, const System& system, const ContactTerms& contacts) {
  const size_t count = contacts.rows().size();
  for (auto* list : {&gap_, &slide_, &limit_}) list->resize(count);
  pace_.assign(count, 1);
  last_change_.assign(count, 0);
  for (auto* list : {&closed_, &stuck_}) list->resize(count);
  factored_closed_.clear();
  kd_.setZero(system.force.size());
  for (size_t k = 0; k < count; ++k)
    limit_[k] = friction_limit(contacts.rows()[k], model.contacts[k].normal_force);
  normal_.resize(count);
  shear_.resize(count);
  for (size_t k = 0; k < count; ++k) {
    normal_[k] = std::max(0.0, model.contacts[k].normal_force);
    shear_[k] = std::clamp(model.contacts[k].shear_force, -limit_[k], limit_[k]);
  }
}

void OpenClose::judge_residual(const Model& model, const System& system, const ContactTerms& contacts,
                               double place_rounding, OpenCloseResult& result) {
  residual(system, contacts, true, r_);
  std::vector<double> scale = system.force_scale, rounding = system.force_rounding;
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const Contact& contact = model.contacts[k];
    const double normal = normal_force(rows[k], k);
    scale[contact.i] += normal;
    scale[contact.j] += normal;
    rounding[contact.i] += rows[k].kn * place_rounding;
    rounding[contact.j] += rows[k].kn * place_rounding;
  }
  const double floor = force_floor * *std::max_element(scale.begin(), scale.end());
  result.residual = 0;
  for (size_t b = 0; b < model.shapes.size(); ++b) {
    const BlockShape& shape = model.shapes[b];
    if (shape.dofs == 0) continue;
    const double out = r_.segment(shape.dof_begin, shape.dofs).norm();
    if (out <= rounding[b]) continue;
    const double relative = (out - rounding[b]) / std::max(scale[b], floor);
    if (std::isnan(result.residual) || relative <= result.residual) continue;
    result.residual = relative;  // also where it is not a number: the worst there is
    result.worst_block = int(b);
  }
}

OpenCloseResult OpenClose::judge(const Model& model, const System& system, const ContactTerms& contacts) {
  OpenCloseResult result;
  start(model, system, contacts);
  evaluate(contacts, Vector::Zero(system.force.size()));
  // Gaps are differences of places: their rounding times the stiffness is no force.
  const double place_rounding = 8 * std::numeric_limits<double>::epsilon() * model.extent;
  judge_residual(model, system, contacts, place_rounding, result);
  return result;
}

OpenCloseResult OpenClose::judge(const Model& model, const System& system, const ContactTerms& contacts,
                                 const Vector& d) {
  OpenCloseResult result;
  start(model, system, contacts);
  system.matrix.multiply(d, kd_);
  evaluate(contacts, d);
  judge_residual(model, system, contacts, 0, result);
  result.missed = missed_;
  return result;
}

void OpenClose::store(Model& model, const ContactTerms& contacts) const {
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    Contact& contact = model.contacts[k];
    contact.normal_force = normal_force(rows[k], k);
    const double limit = friction_limit(rows[k], contact.normal_force), trial = rows[k].ks * slide_[k];
    contact.shear_force = std::clamp(trial, -limit, limit);
    contact.state = contact.normal_force <= 0        ? ContactState::open
                    : contact.shear_force == trial ? ContactState::stick
                                                     : ContactState::slip;
    contact.slip = contact.state == ContactState::open ? 0 : contact.slip + (trial - contact.shear_force) / rows[k].ks;
    contact.stretch = contact.shear_force / rows[k].ks;
    contact.gap = gap_[k] - contact.offset;
    if (contact.offset > 0)
      contact.offset = std::clamp(-contact.gap, 0.0, contact.offset);  // shrinks as the bodies separate
    else if (gap_[k] > 0)
      contact.offset = 0;  // what a bond was pressed with is gone
  }
}

}  // namespace talus
