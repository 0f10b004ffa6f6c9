// Newton's method on the convex potential of springs and of friction at frozen limits, with exact line search; the
// limits follow the normal forces after every iteration, one that swings half as far each time.
#include <algorithm>
#include <cmath>

#include "problem.h"

namespace talus::study {

namespace {

struct Limits {
  std::vector<double> at, pace, last;

  void follow(const Desk& desk, const std::vector<double>& gap) {
    for (size_t k = 0; k < at.size(); ++k) {
      const double change = Desk::limit(desk.row(k), desk.row(k).kn * std::max(0.0, -gap[k])) - at[k];
      if (change * last[k] < 0) pace[k] *= 0.5;
      if (change != 0) last[k] = change;
      at[k] += pace[k] * change;
    }
  }
};

// Root of the slope of the potential along a step, which rises and is piecewise linear.
double line_search(const Desk& desk, const Vector& p, const Vector& r, const std::vector<double>& gap,
                   const std::vector<double>& slide, const std::vector<double>& limit) {
  std::vector<double> gap_rate, slide_rate;
  desk.places(p, gap_rate, slide_rate, true);
  const double curvature = p.dot(desk.product(p)), at0 = -r.dot(p);
  const auto contacts = [&](double step) {
    double sum = 0;
    for (size_t k = 0; k < desk.count(); ++k) {
      const ContactRows& row = desk.row(k);
      sum -= row.kn * std::max(0.0, -gap[k] - step * gap_rate[k]) * gap_rate[k];
      sum += std::clamp(row.ks * (slide[k] + step * slide_rate[k]), -limit[k], limit[k]) * slide_rate[k];
    }
    return sum / desk.factor();
  };
  const double start = contacts(0);
  const auto slope = [&](double step) { return at0 + step * curvature + contacts(step) - start; };
  if (slope(1) <= 0) return 1;
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2, at = slope(middle);
    (at > 0 ? high : low) = middle;
    if (std::abs(at) <= 1e-3 * std::abs(at0)) return middle;
  }
  return (low + high) / 2;
}

// From the states of the last step: what presses may pull, what sticks has no limit, what closes now sticks.
Vector predicted(Desk& desk) {
  Vector d = Vector::Zero(desk.problem.system.force.size());
  std::vector<double> gap, slide, kn(desk.count(), 0), ks(kn), normal(kn), shear(kn);
  desk.places(d, gap, slide);
  for (size_t k = 0; k < desk.count(); ++k) {
    const ContactRows& row = desk.row(k);
    const ContactState state = desk.contact(k).state;
    if (state == ContactState::open && gap[k] > 0) continue;
    kn[k] = row.kn;
    normal[k] = -row.kn * row.gap0;
    if (state != ContactState::slip) ks[k] = row.ks;
    shear[k] = state == ContactState::slip ? desk.contact(k).shear_force : row.ks * row.slide0;
  }
  const Vector rhs = desk.out_of_balance(d, normal, shear);
  if (desk.factorise(kn, ks)) desk.solve(rhs, d);
  return d;
}

}  // namespace

void convex_newton(Desk& desk) {
  const size_t count = desk.count();
  Limits limits{std::vector<double>(count, 0), std::vector<double>(count, 1), std::vector<double>(count, 0)};
  std::vector<double> gap, slide, normal(count), shear(count), kn(count), ks(count);
  Vector d = predicted(desk), p;
  desk.places(d, gap, slide);
  limits.follow(desk, gap);
  for (desk.judge(d); !desk.done() && !desk.spent(); desk.judge(d)) {
    for (size_t k = 0; k < count; ++k) {
      const ContactRows& row = desk.row(k);
      normal[k] = row.kn * std::max(0.0, -gap[k]);
      shear[k] = std::clamp(row.ks * slide[k], -limits.at[k], limits.at[k]);
      kn[k] = gap[k] <= 0 ? row.kn : 0;
      ks[k] = std::abs(row.ks * slide[k]) < limits.at[k] ? row.ks : 0;
    }
    const Vector r = desk.out_of_balance(d, normal, shear);
    if (!desk.factorise(kn, ks)) return;
    desk.solve(r, p);
    d += line_search(desk, p, r, gap, slide, limits.at) * p;
    desk.places(d, gap, slide);
    limits.follow(desk, gap);
  }
}

}  // namespace talus::study
