// Newton's method in forces: the dual of the problem at frozen friction limits is a quadratic function of the
// contact forces within bounds (N >= 0, |T| <= limit). The free forces go by Newton's step, which is one solve
// with their springs in the matrix, and are projected back on the bounds, halved until the function has fallen
// (Bertsekas 1982). Limits follow after every iteration.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "forces.h"

namespace talus::study {

namespace {

constexpr double least_part = 1e-4;
// of the largest normal force: what is so near its bound and wants to cross it is held
constexpr double bound_part = 1e-6;

struct Step {
  std::vector<double> normal, shear;  // N, forces that Newton's step asks for
};

// Free is what is off its bound, or leaves it by the slope of the dual.
Step newton(Desk& desk, const Forces& forces, const std::vector<double>& limit, Vector& d) {
  const size_t count = desk.count();
  const double near_bound = bound_part * *std::max_element(forces.normal.begin(), forces.normal.end());
  std::vector<double> kn(count, 0), ks(count, 0);
  Step step{std::vector<double>(count, 0), std::vector<double>(count, 0)};
  for (size_t k = 0; k < count; ++k) {
    const ContactRows& row = desk.row(k);
    const double trial = row.ks * forces.slide(k);
    if (forces.normal[k] > near_bound || forces.gap(k) + forces.normal[k] / row.kn < 0) kn[k] = row.kn;
    const bool inside = std::abs(forces.shear[k]) < limit[k] * (1 - 1e-12),
               returns = trial * forces.shear[k] < limit[k] * std::abs(forces.shear[k]);
    if (limit[k] > 0 && (inside || returns)) ks[k] = row.ks;
    step.normal[k] = kn[k] > 0 ? -row.kn * row.gap0 : forces.normal[k];
    step.shear[k] = ks[k] > 0 ? row.ks * row.slide0 : forces.shear[k];
  }
  d.setZero(desk.problem.system.force.size());
  const Vector rhs = desk.out_of_balance(d, step.normal, step.shear);
  if (desk.factorise(kn, ks)) desk.solve(rhs, d);
  std::vector<double> gap, slide;
  desk.places(d, gap, slide);
  for (size_t k = 0; k < count; ++k) {
    if (kn[k] > 0) step.normal[k] = -kn[k] * gap[k];
    if (ks[k] > 0) step.shear[k] = ks[k] * slide[k];
  }
  return step;
}

}  // namespace

void dual_newton(Desk& desk) {
  Forces forces(desk);
  std::vector<double> limit(desk.count());
  double least = 1;  // part of a step
  Vector d;
  while (!desk.done() && !desk.spent()) {
    for (size_t k = 0; k < desk.count(); ++k) limit[k] = Desk::limit(desk.row(k), forces.normal[k]);
    const Step to = newton(desk, forces, limit, d);
    if (desk.judge(d); desk.done()) return;
    const std::vector<double> n0 = forces.normal, t0 = forces.shear;
    const double before = forces.value();
    double part = 1;
    for (;; part /= 2) {
      for (size_t k = 0; k < desk.count(); ++k) {
        forces.normal[k] = std::max(0.0, n0[k] + part * (to.normal[k] - n0[k]));
        forces.shear[k] = std::clamp(t0[k] + part * (to.shear[k] - t0[k]), -limit[k], limit[k]);
      }
      if (forces.value() < before || part < least_part) break;
    }
    forces.rebuild();
    least = std::min(least, part);
    char note[60];
    std::snprintf(note, sizeof note, "smallest part of a step %.1g", least);
    desk.outcome.note = note;
  }
}

}  // namespace talus::study
