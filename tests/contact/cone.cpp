// Primal-dual interior point on Coulomb's cone itself. Friction is not associated: sliding would lift the contact
// by tan φ times its speed. De Saxcé & Feng (1998): adding h = tan φ |sliding| to the gap makes it so; h is taken
// from the iteration before. Per contact, with the cone's two sides p± = tan φ N ± T >= 0 and their duals b± >= 0:
//   gap + N/kn + h = tan φ (b+ + b-),   slide - T/ks = b- - b+,   p± b± = m.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "problem.h"

namespace talus::study {

namespace {

constexpr double to_border = 0.99;
constexpr double enough = 1e-14;  // barrier, part of the first

class Cone {
 public:
  explicit Cone(Desk& desk);
  void solve();

 private:
  // The cone's sides after s of the change; kept by themselves, as differences of forces they would lose their
  // digits.
  double plus(size_t k, double s) const { return plus_[k] + s * (mu(k) * dn_[k] + dt_[k]); }
  double minus(size_t k, double s) const { return minus_[k] + s * (mu(k) * dn_[k] - dt_[k]); }
  double mu(size_t k) const { return desk_.row(k).friction; }
  double barrier(double step) const;
  double longest() const;
  bool linearise();
  void direction(double m, bool corrected, Vector& p);

  Desk& desk_;
  size_t count_;
  Vector d_, out_;
  double first_ = 0, unsettled_ = 1;  // barrier; part of the shifts h that the last iteration has changed
  std::vector<double> n_, t_, plus_, minus_, up_, um_, dn_, dt_, dup_, dum_;  // forces; p±; b±; changes
  std::vector<double> gap_off_, slide_off_, nn_, nt_, tt_, shift_;
};

Cone::Cone(Desk& desk) : desk_(desk), count_(desk.count()) {
  const double force = desk.usual_force(), length = desk.usual_length();
  first_ = force * length;
  d_.setZero(desk.problem.system.force.size());
  for (auto* list : {&t_, &dn_, &dt_, &dup_, &dum_, &gap_off_, &slide_off_, &nn_, &nt_, &tt_, &shift_})
    list->assign(count_, 0);
  n_.assign(count_, force);
  for (size_t k = 0; k < count_; ++k) up_.push_back(std::max(desk.row(k).gap0, length) / mu(k));
  um_ = up_;
  for (size_t k = 0; k < count_; ++k) plus_.push_back(mu(k) * n_[k]);
  minus_ = plus_;
}

double Cone::barrier(double s) const {
  double sum = 0;
  for (size_t k = 0; k < count_; ++k) sum += plus(k, s) * (up_[k] + s * dup_[k]) + minus(k, s) * (um_[k] + s * dum_[k]);
  return sum / double(2 * count_);
}

double Cone::longest() const {
  double step = 1;
  const auto within = [&](double value, double change) {
    if (change < 0) step = std::min(step, -value / change);
  };
  for (size_t k = 0; k < count_; ++k) {
    within(plus(k, 0), mu(k) * dn_[k] + dt_[k]);
    within(minus(k, 0), mu(k) * dn_[k] - dt_[k]);
    within(up_[k], dup_[k]);
    within(um_[k], dum_[k]);
  }
  return step;
}

bool Cone::linearise() {
  std::vector<double> gap, slide;
  desk_.places(d_, gap, slide);
  double changed = 0, all = 0;
  for (size_t k = 0; k < count_; ++k) {
    const ContactRows& row = desk_.row(k);
    const double slipped = slide[k] - t_[k] / row.ks, m = mu(k);
    changed += std::abs(m * std::abs(slipped) - shift_[k]);
    all += shift_[k] = m * std::abs(slipped);
    gap_off_[k] = gap[k] + n_[k] / row.kn + shift_[k] - m * (up_[k] + um_[k]);
    slide_off_[k] = slipped + up_[k] - um_[k];
    const double p = up_[k] / plus(k, 0), q = um_[k] / minus(k, 0);
    const double a = 1 / row.kn + m * m * (p + q), b = m * (q - p), c = 1 / row.ks + p + q;
    const double det = std::max(a * c - b * b, 1e-14 * a * c);
    nn_[k] = c / det;
    tt_[k] = a / det;
    nt_[k] = -b / det;
  }
  unsettled_ = all > 0 ? changed / all : 0;
  out_ = desk_.out_of_balance(d_, n_, t_);
  return desk_.factorise(nn_, tt_, &nt_);
}

void Cone::direction(double m, bool corrected, Vector& p) {
  const double second = corrected ? 1 : 0;
  std::vector<double> cp(count_), cm(count_), rn(count_), rt(count_), gap, slide;
  Vector rhs = out_;
  for (size_t k = 0; k < count_; ++k) {
    const ContactRows& row = desk_.row(k);
    cp[k] = (m - second * (mu(k) * dn_[k] + dt_[k]) * dup_[k]) / plus(k, 0) - up_[k];
    cm[k] = (m - second * (mu(k) * dn_[k] - dt_[k]) * dum_[k]) / minus(k, 0) - um_[k];
    rn[k] = -gap_off_[k] + mu(k) * (cp[k] + cm[k]);
    rt[k] = -slide_off_[k] - cp[k] + cm[k];
    row.add(row.normal_i, row.normal_j, nn_[k] * rn[k] + nt_[k] * rt[k], rhs);
    row.add(row.shear_i, row.shear_j, nt_[k] * rn[k] + tt_[k] * rt[k], rhs);
  }
  desk_.solve(rhs, p);
  desk_.places(p, gap, slide, true);
  for (size_t k = 0; k < count_; ++k) {
    const double x = rn[k] - gap[k], y = rt[k] - slide[k], above = plus(k, 0), below = minus(k, 0);
    dn_[k] = nn_[k] * x + nt_[k] * y;
    dt_[k] = -(nt_[k] * x + tt_[k] * y);
    dup_[k] = cp[k] - up_[k] * (mu(k) * dn_[k] + dt_[k]) / above;
    dum_[k] = cm[k] - um_[k] * (mu(k) * dn_[k] - dt_[k]) / below;
  }
}

void Cone::solve() {
  int steps = 0;
  double last = 0;
  for (; !desk_.spent(); ++steps) {
    if (desk_.judge(d_); desk_.done()) break;
    const double now = barrier(0);
    if (!(now >= enough * first_) || !linearise()) break;
    Vector p;
    direction(0, false, p);
    const double part = std::pow(barrier(longest()) / now, 3);
    direction(std::max(part, 1e-3) * now, true, p);
    last = std::min(1.0, to_border * longest());
    d_ += last * p;
    for (size_t k = 0; k < count_; ++k) {
      plus_[k] = plus(k, last);
      minus_[k] = minus(k, last);
      n_[k] += last * dn_[k];
      t_[k] += last * dt_[k];
      up_[k] += last * dup_[k];
      um_[k] += last * dum_[k];
    }
  }
  char note[120];
  std::snprintf(note, sizeof note, "barrier %.0g of the first, last step %.1g, last change of h %.0g",
                barrier(0) / first_, last, unsettled_);
  desk_.outcome.note = note;
}

}  // namespace

void cone_interior_point(Desk& desk) {
  for (size_t k = 0; k < desk.count(); ++k)
    if (desk.row(k).friction <= 0 || desk.row(k).cohesion > 0) {
      desk.outcome.note = "needs friction and no cohesion";
      return;
    }
  Cone(desk).solve();
}

}  // namespace talus::study
