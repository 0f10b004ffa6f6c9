// Primal-dual interior point (Mehrotra 1992) on the convex problem at frozen friction limits L, with the limits
// renewed outside from the normal forces found. Per contact, to a barrier m that goes to nothing:
//   w = gap + N/kn,  N w = m;    A - B = slide - T/ks,  (L - T) A = m,  (L + T) B = m.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "problem.h"

namespace talus::study {

namespace {

constexpr double to_border = 0.995;
constexpr double enough = 1e-13;  // barrier, part of the first
constexpr int most_inner = 45;
constexpr double least_limit = 1e-6;  // part of the force scale: the interior must not be empty
constexpr double apart = 1e-2;        // warm start: part of the scales by which it is put inside

struct Interior {
  Vector d;
  std::vector<double> n, w, t, a, b;       // N, m, N, m, m
  std::vector<double> over, under;         // N, L - T and L + T, which as differences would lose their digits
  std::vector<double> dn, dw, dt, da, db;  // changes of the predictor, then of the step
};

class Frozen {
 public:
  Frozen(Desk& desk, std::vector<double> limit, double force, double length)
      : desk_(desk), limit_(std::move(limit)), force_(force), length_(length), count_(desk.count()) {}

  void start(bool warm, Interior& x) const;
  int solve(Interior& x);  // iterations

 private:
  double barrier(const Interior& x, double step) const;
  void linearise(const Interior& x);
  void direction(double m, bool corrected, Interior& x, Vector& p);
  double longest(const Interior& x) const;

  Desk& desk_;
  std::vector<double> limit_;
  double force_, length_;
  size_t count_;
  std::vector<double> gap_off_, slide_off_, kn_, kt_;  // what the equations of the law are out by; stiffnesses
  Vector out_;
};

void Frozen::start(bool warm, Interior& x) const {
  if (!warm) x.d.setZero(desk_.problem.system.force.size());
  for (auto* list : {&x.n, &x.w, &x.t, &x.a, &x.b, &x.over, &x.under, &x.dn, &x.dw, &x.dt, &x.da, &x.db})
    if (!warm || list->size() != count_) list->assign(count_, 0);
  std::vector<double> gap, slide;
  desk_.places(x.d, gap, slide);
  for (size_t k = 0; k < count_; ++k) {
    x.n[k] = warm ? std::max(x.n[k], apart * force_) : force_;
    x.w[k] = std::max(gap[k] + x.n[k] / desk_.row(k).kn, warm ? apart * length_ : length_);
    x.t[k] = warm ? std::clamp(x.t[k], -(1 - apart) * limit_[k], (1 - apart) * limit_[k]) : 0;
    x.over[k] = limit_[k] - x.t[k];
    x.under[k] = limit_[k] + x.t[k];
    x.a[k] = warm ? std::max(x.a[k], apart * length_) : length_;
    x.b[k] = warm ? std::max(x.b[k], apart * length_) : length_;
  }
}

// Mean product of the pairs, after `step` of the changes.
double Frozen::barrier(const Interior& x, double s) const {
  double sum = 0;
  for (size_t k = 0; k < count_; ++k)
    sum += (x.n[k] + s * x.dn[k]) * (x.w[k] + s * x.dw[k]) + (x.over[k] - s * x.dt[k]) * (x.a[k] + s * x.da[k]) +
           (x.under[k] + s * x.dt[k]) * (x.b[k] + s * x.db[k]);
  return sum / double(3 * count_);
}

void Frozen::linearise(const Interior& x) {
  std::vector<double> gap, slide;
  desk_.places(x.d, gap, slide);
  for (auto* list : {&gap_off_, &slide_off_, &kn_, &kt_}) list->resize(count_);
  for (size_t k = 0; k < count_; ++k) {
    const ContactRows& row = desk_.row(k);
    gap_off_[k] = gap[k] + x.n[k] / row.kn - x.w[k];
    slide_off_[k] = slide[k] - x.t[k] / row.ks - (x.a[k] - x.b[k]);
    kn_[k] = x.n[k] / (x.w[k] + x.n[k] / row.kn);
    kt_[k] = 1 / (1 / row.ks + x.a[k] / x.over[k] + x.b[k] / x.under[k]);
  }
  out_ = desk_.out_of_balance(x.d, x.n, x.t);
}

void Frozen::direction(double m, bool corrected, Interior& x, Vector& p) {
  const double second = corrected ? 1 : 0;
  std::vector<double> cn(count_), ct(count_), ea(count_), eb(count_), ew(count_), shear(count_);
  Vector rhs = out_;
  for (size_t k = 0; k < count_; ++k) {
    const ContactRows& row = desk_.row(k);
    ew[k] = m - x.n[k] * x.w[k] - second * x.dn[k] * x.dw[k];
    ea[k] = m - x.over[k] * x.a[k] + second * x.dt[k] * x.da[k];
    eb[k] = m - x.under[k] * x.b[k] - second * x.dt[k] * x.db[k];
    cn[k] = (ew[k] - x.n[k] * gap_off_[k]) / (x.w[k] + x.n[k] / row.kn);
    ct[k] = kt_[k] * (slide_off_[k] - ea[k] / x.over[k] + eb[k] / x.under[k]);
    row.add(row.normal_i, row.normal_j, cn[k], rhs);
    row.add(row.shear_i, row.shear_j, -ct[k], rhs);
  }
  desk_.solve(rhs, p);
  std::vector<double> gap, slide;
  desk_.places(p, gap, slide, true);
  for (size_t k = 0; k < count_; ++k) {
    x.dn[k] = cn[k] - kn_[k] * gap[k];
    x.dw[k] = gap[k] + x.dn[k] / desk_.row(k).kn + gap_off_[k];
    x.dt[k] = ct[k] + kt_[k] * slide[k];
    x.da[k] = (ea[k] + x.a[k] * x.dt[k]) / x.over[k];
    x.db[k] = (eb[k] - x.b[k] * x.dt[k]) / x.under[k];
  }
}

double Frozen::longest(const Interior& x) const {
  double step = 1;
  const auto within = [&](double value, double change) {
    if (change < 0) step = std::min(step, -value / change);
  };
  for (size_t k = 0; k < count_; ++k) {
    within(x.n[k], x.dn[k]);
    within(x.w[k], x.dw[k]);
    within(x.a[k], x.da[k]);
    within(x.b[k], x.db[k]);
    within(x.over[k], -x.dt[k]);
    within(x.under[k], x.dt[k]);
  }
  return step;
}

int Frozen::solve(Interior& x) {
  const double first = force_ * length_;
  int i = 0;
  for (; i < most_inner && !desk_.spent(); ++i) {
    if (desk_.judge(x.d); desk_.done()) return i;
    const double now = barrier(x, 0);
    if (now < enough * first) return i;
    linearise(x);
    if (!desk_.factorise(kn_, kt_)) return i;
    Vector p;
    direction(0, false, x, p);
    const double part = std::pow(barrier(x, longest(x)) / now, 3);
    direction(std::max(part, 1e-3) * now, true, x, p);
    const double step = std::min(1.0, to_border * longest(x));
    x.d += step * p;
    for (size_t k = 0; k < count_; ++k) {
      x.n[k] += step * x.dn[k];
      x.w[k] += step * x.dw[k];
      x.t[k] += step * x.dt[k];
      x.over[k] -= step * x.dt[k];
      x.under[k] += step * x.dt[k];
      x.a[k] += step * x.da[k];
      x.b[k] += step * x.db[k];
    }
  }
  return i;
}

void interior(Desk& desk, bool warm) {
  const double force = desk.usual_force(), length = desk.usual_length();
  std::vector<double> limit, pace(desk.count(), 1), last(desk.count(), 0);
  for (size_t k = 0; k < desk.count(); ++k) limit.push_back(Desk::limit(desk.row(k), desk.contact(k).normal_force));
  Interior x;
  std::string inner;
  for (int outer = 0; !desk.done() && !desk.spent(); ++outer) {
    std::vector<double> inside = limit;
    for (double& l : inside) l = std::max(l, least_limit * force);
    Frozen problem(desk, std::move(inside), force, length);
    problem.start(warm && outer > 0, x);
    inner += (outer > 0 ? " " : "iterations a limit update: ") + std::to_string(problem.solve(x));
    for (size_t k = 0; k < desk.count(); ++k) {
      const double change = Desk::limit(desk.row(k), x.n[k]) - limit[k];
      if (change * last[k] < 0) pace[k] *= 0.5;
      last[k] = change;
      limit[k] += pace[k] * change;
    }
  }
  desk.outcome.note = inner;
}

}  // namespace

void interior_point(Desk& desk) {
  interior(desk, false);
}
void interior_point_warm(Desk& desk) {
  interior(desk, true);
}

}  // namespace talus::study
