// The law of open–close: gaps, forces, residual, and what it is judged by.
#include <algorithm>
#include <cmath>
#include <limits>

#include "step/open_close.h"

namespace talus {

namespace {

// A block's residual is measured against the forces that meet in it, but not below this part of the largest
// such sum in the problem: round-off of the large forces reaches every block through the factor.
constexpr double force_floor = 1e-4;

}  // namespace

void OpenClose::evaluate(const ContactProblem& problem, const Vector& d) {
  const auto& rows = problem.contacts.rows();
  missed_ = false;
  for (size_t k = 0; k < rows.size(); ++k) {
    gap_[k] = problem.contacts.gap(rows[k], d);
    slide_[k] = problem.contacts.slide(rows[k], d);
    closed_[k] = rows[k].near && gap_[k] <= 0;
    missed_ = missed_ || (!rows[k].near && gap_[k] < 0);
  }
}

void OpenClose::residual(const ContactProblem& problem, bool coupled, Vector& r) const {
  r = problem.system.force - kd_;
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const double normal = normal_force(rows[k], k);
    const double limit = coupled ? friction_limit(rows[k], normal) : limit_[k];
    if (normal > 0) rows[k].add(rows[k].normal_i, rows[k].normal_j, normal, r);
    if (limit > 0) rows[k].add(rows[k].shear_i, rows[k].shear_j, -std::clamp(rows[k].ks * slide_[k], -limit, limit), r);
  }
}

void OpenClose::start(const ContactProblem& problem) {
  const size_t count = problem.contacts.rows().size();
  for (auto* list : {&gap_, &slide_, &limit_}) list->resize(count);
  pace_.assign(count, 1);
  last_change_.assign(count, 0);
  for (auto* list : {&closed_, &stuck_}) list->resize(count);
  factored_closed_.clear();
  pivoted_.reset();
  kd_.setZero(problem.system.force.size());
  for (size_t k = 0; k < count; ++k)
    limit_[k] = friction_limit(problem.contacts.rows()[k], problem.before(k).normal_force);
  normal_.resize(count);
  shear_.resize(count);
  for (size_t k = 0; k < count; ++k) {
    normal_[k] = std::max(0.0, problem.before(k).normal_force);
    shear_[k] = std::clamp(problem.before(k).shear_force, -limit_[k], limit_[k]);
  }
}

void OpenClose::judge_residual(const ContactProblem& problem, bool as_it_lies, OpenCloseResult& result) {
  residual(problem, true, r_);
  std::vector<double> scale = problem.system.force_scale, rounding = problem.system.force_rounding;
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const double normal = normal_force(rows[k], k),
                 shear = std::min(rows[k].ks * std::abs(slide_[k]), friction_limit(rows[k], normal));
    for (const int block : {rows[k].i, rows[k].j}) {
      scale[block] += std::max(normal, shear);  // cohesion holds faces that are not pressed
      if (as_it_lies) rounding[block] += rows[k].kn * rows[k].rounding;
    }
  }
  const double floor = force_floor * *std::max_element(scale.begin(), scale.end());
  result.residual = 0;
  for (size_t b = 0; b < problem.blocks.size(); ++b) {
    if (problem.dofs[b] == 0) continue;
    const double out = r_.segment(problem.dof_begin[b], problem.dofs[b]).norm();
    if (out <= rounding[b]) continue;
    const double meets = std::max(scale[b], floor);
    // Blocks that fly, on the way to where nothing presses on them: all of it is out of balance.
    const double relative = meets == 0 && std::isfinite(out) ? 1 : (out - rounding[b]) / meets;
    if (std::isnan(result.residual) || relative <= result.residual) continue;
    result.residual = relative;  // also where it is not a number: the worst there is
    result.worst_block = problem.blocks[b];
  }
}

OpenCloseResult OpenClose::judge(const ContactProblem& problem) {
  OpenCloseResult result;
  start(problem);
  evaluate(problem, Vector::Zero(problem.system.force.size()));
  judge_residual(problem, true, result);
  return result;
}

OpenCloseResult OpenClose::judge(const ContactProblem& problem, const Vector& d) {
  OpenCloseResult result;
  start(problem);
  problem.system.matrix.multiply(d, kd_);
  evaluate(problem, d);
  judge_residual(problem, false, result);
  result.missed = missed_;
  return result;
}

void OpenClose::store(const ContactTerms& contacts, const ContactRows& row, const Vector& d, Contact& contact) {
  const double gap = contacts.gap(row, d), slide = contacts.slide(row, d);
  contact.normal_force = row.kn * std::max(0.0, -gap);
  const double limit = friction_limit(row, contact.normal_force), trial = row.ks * slide;
  contact.shear_force = std::clamp(trial, -limit, limit);
  contact.state = contact.normal_force <= 0 && limit <= 0 ? ContactState::open
                  : contact.shear_force == trial          ? ContactState::stick
                                                          : ContactState::slip;
  const double slid = slide - contact.stretch;
  contact.stretch = slide;
  // What was pressed as a load step began, or has taken over from that, may press again before its end.
  if (contact.state == ContactState::open && contact.load_normal == 0) contact.part();
  contact.gap = gap - contact.offset;
  contact.slope = row.climb;
  if (contact.offset > 0) {
    const double climbed = std::min(contact.height, row.climb * slid);
    // shrinks as the bodies separate
    contact.offset = std::clamp(-contact.gap, 0.0, std::max(0.0, contact.offset - climbed));
    contact.height = std::min(contact.height - climbed, contact.offset);
  } else if (gap > 0) {
    contact.offset = 0;  // what a bond was pressed with is gone
  }
}

}  // namespace talus
