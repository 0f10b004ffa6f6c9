#include "step/open_close.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

// A block's residual is measured against the forces that meet in it, but not below this part of the largest
// such sum in the scene: round-off of the large forces reaches every block through the factor.
constexpr double force_floor = 1e-4;

// The line search is exact when the slope has fallen to this part.
constexpr double slope_part = 0.05;

}  // namespace

double OpenClose::friction_limit(const ContactRows& row, double normal) const {
  return normal > 0 ? (std::isinf(row.friction) ? row.friction : row.friction * normal) + row.cohesion : 0;
}

void OpenClose::evaluate(const ContactTerms& contacts, const Vector& d) {
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    gap_[k] = rows[k].gap0 + contacts.factor() * rows[k].along(rows[k].normal_i, rows[k].normal_j, d);
    slide_[k] = rows[k].slide0 + contacts.factor() * rows[k].along(rows[k].shear_i, rows[k].shear_j, d);
    closed_[k] = gap_[k] <= 0;
  }
}

void OpenClose::residual(const System& system, const ContactTerms& contacts, bool coupled, Vector& r) const {
  r = system.force - kd_;
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const double normal = rows[k].kn * std::max(0.0, -gap_[k]);
    const double limit = coupled ? friction_limit(rows[k], normal) : limit_[k];
    if (normal > 0) rows[k].add(rows[k].normal_i, rows[k].normal_j, normal, r);
    if (limit > 0) rows[k].add(rows[k].shear_i, rows[k].shear_j, -std::clamp(rows[k].ks * slide_[k], -limit, limit), r);
  }
}

void OpenClose::start(const Model& model, const System& system, const ContactTerms& contacts) {
  const size_t count = contacts.rows().size();
  for (auto* list : {&gap_, &slide_, &limit_}) list->resize(count);
  for (auto* list : {&closed_, &stuck_}) list->resize(count);
  factored_closed_.clear();
  kd_.setZero(system.force.size());
  for (size_t k = 0; k < count; ++k)
    limit_[k] = friction_limit(contacts.rows()[k], model.contacts[k].normal_force);
}

void OpenClose::judge_residual(const Model& model, const System& system, const ContactTerms& contacts,
                               double place_rounding, OpenCloseResult& result) {
  residual(system, contacts, true, r_);
  std::vector<double> scale = system.force_scale, rounding = system.force_rounding;
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const Contact& contact = model.contacts[k];
    const double normal = rows[k].kn * std::max(0.0, -gap_[k]);
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
    const double out = std::max(0.0, r_.segment(shape.dof_begin, shape.dofs).norm() - rounding[b]);
    const double relative = out == 0 ? 0 : out / std::max(scale[b], floor);
    if (!(relative <= result.residual)) {
      result.residual = relative;
      result.worst_block = int(b);
    }
  }
}

// Root of the potential's slope along p; the slope is a rising, piecewise linear function of the step.
double OpenClose::line_search(const ContactTerms& contacts, const Vector& p, double slope0, double curvature) const {
  const auto& rows = contacts.rows();
  std::vector<double> gap_rate(rows.size()), slide_rate(rows.size());
  double contact_slope0 = 0;
  const auto contact_slope = [&](double step) {
    double slope = 0;
    for (size_t k = 0; k < rows.size(); ++k) {
      const double gap = gap_[k] + step * gap_rate[k], slide = slide_[k] + step * slide_rate[k];
      slope += (-rows[k].kn * std::max(0.0, -gap) * gap_rate[k] +
                std::clamp(rows[k].ks * slide, -limit_[k], limit_[k]) * slide_rate[k]) /
               contacts.factor();
    }
    return slope;
  };
  for (size_t k = 0; k < rows.size(); ++k) {
    gap_rate[k] = contacts.factor() * rows[k].along(rows[k].normal_i, rows[k].normal_j, p);
    slide_rate[k] = contacts.factor() * rows[k].along(rows[k].shear_i, rows[k].shear_j, p);
  }
  contact_slope0 = contact_slope(0);
  const auto slope = [&](double step) { return slope0 + step * curvature + contact_slope(step) - contact_slope0; };
  const double enough = slope_part * std::abs(slope0);
  double low = 0, high = 1, at_low = slope0, at_high = slope(1);
  if (at_high <= enough) return 1;
  for (int i = 0; i < 60; ++i) {  // Illinois: regula falsi that halves the stale end
    const double middle = (low * at_high - high * at_low) / (at_high - at_low), at_middle = slope(middle);
    if (std::abs(at_middle) <= enough) return middle;
    if (at_middle > 0) {
      high = middle;
      at_high = at_middle;
      at_low *= 0.5;
    } else {
      low = middle;
      at_low = at_middle;
      at_high *= 0.5;
    }
  }
  return low > 0 ? low : high;
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

OpenCloseResult OpenClose::solve(const Model& model, System& system, const ContactTerms& contacts,
                                 LinearSolver& solver, double tolerance, int max_iterations, Vector& d) {
  OpenCloseResult result;
  d.setZero(system.force.size());
  start(model, system, contacts);
  evaluate(contacts, d);
  const auto& rows = contacts.rows();
  const std::vector<double> base = system.matrix.values;
  while (result.iterations < max_iterations) {
    for (size_t k = 0; k < rows.size(); ++k) stuck_[k] = std::abs(rows[k].ks * slide_[k]) < limit_[k];
    if (result.iterations == 0 || closed_ != factored_closed_ || stuck_ != factored_stuck_) {
      system.matrix.values = base;
      contacts.add_stiffness(system.matrix, closed_, stuck_);
      result.singular_block = solver.factor(system.matrix);
      if (result.singular_block >= 0) break;
      factored_closed_ = closed_;
      factored_stuck_ = stuck_;
      system.matrix.values = base;
    }
    residual(system, contacts, false, r_);
    solver.solve(r_, p_);
    ++result.iterations;
    kp_.setZero(p_.size());
    system.matrix.multiply(p_, kp_);
    const double step = rows.empty() ? 1 : line_search(contacts, p_, -r_.dot(p_), p_.dot(kp_));
    d += step * p_;
    kd_ += step * kp_;
    evaluate(contacts, d);
    for (size_t k = 0; k < rows.size(); ++k)
      limit_[k] = friction_limit(rows[k], rows[k].kn * std::max(0.0, -gap_[k]));
    judge_residual(model, system, contacts, 0, result);
    if (!std::isfinite(result.residual)) break;
    if (result.residual <= tolerance) {
      result.converged = true;
      break;
    }
  }
  system.matrix.values = base;
  return result;
}

void OpenClose::store(Model& model, const ContactTerms& contacts) const {
  const auto& rows = contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    Contact& contact = model.contacts[k];
    contact.normal_force = rows[k].kn * std::max(0.0, -gap_[k]);
    const double limit = friction_limit(rows[k], contact.normal_force), trial = rows[k].ks * slide_[k];
    contact.shear_force = std::clamp(trial, -limit, limit);
    contact.state = contact.normal_force <= 0        ? ContactState::open
                    : contact.shear_force == trial ? ContactState::stick
                                                     : ContactState::slip;
    contact.slip = contact.state == ContactState::open ? 0 : contact.slip + (trial - contact.shear_force) / rows[k].ks;
    contact.stretch = contact.shear_force / rows[k].ks;
    contact.gap = gap_[k] - contact.offset;
    contact.offset = std::clamp(-contact.gap, 0.0, contact.offset);  // shrinks as the bodies separate
  }
}

}  // namespace talus
