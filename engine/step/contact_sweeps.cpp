#include "step/contact_sweeps.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace talus {

namespace {

// Pairs of sweeps after which a restart of the momentum by growth of the change is allowed: it takes a few to build up.
constexpr int least_run = 5;

DofColumn padded(const Row& row, int size) {
  DofColumn column = DofColumn::Zero();
  for (int k = 0; k < size; ++k) column[k] = row[k];
  return column;
}

// The law of one contact: gap = gap0 + nn n - ns t, slide = slide0 + ns n - ss t, stiffness included in nn and ss, so
// pressed and sticking mean gap = 0 and slide = 0.
ContactSweeps::Forces coulomb(double gap0, double slide0, double nn, double ns, double ss, double friction, double cohesion) {
  const double det = nn * ss - ns * ns;  // > 0: a contact's own compliance is in both
  const double n = (-gap0 * ss + slide0 * ns) / det, t = (nn * slide0 - ns * gap0) / det;
  if (n > 0 && std::abs(t) <= friction * n + cohesion) return {n, t};
  if (gap0 >= 0 && n <= 0) return {0, 0};
  // Sliding towards where sticking would ask too much, else the other way.
  for (const double way : {t > 0 ? 1.0 : -1.0, t > 0 ? -1.0 : 1.0}) {
    const double steep = nn - way * ns * friction;  // not positive: it would wedge itself without bound
    if (steep <= 0) continue;
    const double pressed = (-gap0 + way * ns * cohesion) / steep;
    if (pressed <= 0) continue;
    const double limit = friction * pressed + cohesion;
    if (way * (slide0 + ns * pressed) - ss * limit >= 0) return {pressed, way * limit};
  }
  if (gap0 >= 0) return {0, 0};
  // Nothing fits to the last digit, at the border of two cases: the nearest of sticking.
  const double pressed = std::max(n, 0.0), limit = friction * pressed + cohesion;
  return {pressed, pressed > 0 ? std::clamp(t, -limit, limit) : 0};
}

}  // namespace

void ContactSweeps::start(const ContactProblem& problem, bool swept) {
  problem_ = &problem;
  const System& system = problem.system;
  factor_ = problem.contacts.factor();
  const int count = int(problem.blocks.size());
  std::vector<char> loose(count);
  whole_ = swept;
  for (int b = 0; b < count; ++b) {
    loose[b] = swept && problem.dofs[b] > 0 && !problem.bonded[b];
    if (problem.dofs[b] > 0 && problem.bonded[b]) whole_ = false;
  }
  blocks_.clear();
  std::vector<int> place(count, -1);
  for (int b = 0; b < count; ++b)
    if (loose[b]) {
      place[b] = int(blocks_.size());
      blocks_.push_back(b);
    }
  const size_t loose_count = blocks_.size();
  inverse_.assign(loose_count, DofMatrix::Zero());
  force_.assign(loose_count + 1, DofColumn::Zero());
  motion_.assign(loose_count + 1, DofColumn::Zero());
  for (size_t l = 0; l < loose_count; ++l) {
    const int dofs = problem.dofs[blocks_[l]];
    DofMatrix matrix = DofMatrix::Identity();
    system.matrix.diagonal(blocks_[l], matrix);
    inverse_[l] = matrix.inverse();
    for (int k = dofs; k < max_dofs; ++k) inverse_[l](k, k) = 0;
    force_[l].head(dofs) = system.force.segment(problem.dof_begin[blocks_[l]], dofs);
  }
  contacts_.clear();
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k) {
    const ContactRows& c = rows[k];
    if (!rows[k].near || (!loose[c.i] && !loose[c.j])) continue;
    const ContactRows& row = rows[k];
    Link link{};
    link.i = loose[c.i] ? place[c.i] : int(loose_count);
    link.j = loose[c.j] ? place[c.j] : int(loose_count);
    const DofMatrix zero = DofMatrix::Zero();
    const DofMatrix &ki = loose[c.i] ? inverse_[link.i] : zero, &kj = loose[c.j] ? inverse_[link.j] : zero;
    link.normal_i = padded(row.normal_i, loose[c.i] ? row.size_i : 0);
    link.normal_j = padded(row.normal_j, loose[c.j] ? row.size_j : 0);
    link.shear_i = padded(row.shear_i, loose[c.i] ? row.size_i : 0);
    link.shear_j = padded(row.shear_j, loose[c.j] ? row.size_j : 0);
    link.moved_ni = ki * link.normal_i;
    link.moved_nj = kj * link.normal_j;
    link.moved_si = ki * link.shear_i;
    link.moved_sj = kj * link.shear_j;
    link.nn = factor_ * (link.normal_i.dot(link.moved_ni) + link.normal_j.dot(link.moved_nj));
    link.ns = factor_ * (link.normal_i.dot(link.moved_si) + link.normal_j.dot(link.moved_sj));
    link.ss = factor_ * (link.shear_i.dot(link.moved_si) + link.shear_j.dot(link.moved_sj));
    link.soft_n = 1 / row.kn;
    link.soft_s = 1 / row.ks;
    link.friction = row.friction;
    link.cohesion = row.cohesion;
    link.contact = int(k);
    contacts_.push_back(link);
  }
}

void ContactSweeps::rebuild() {
  const size_t count = blocks_.size();
  std::vector<DofColumn> sum = force_;
  for (const Link& link : contacts_) {
    sum[link.i] += link.n * link.normal_i - link.t * link.shear_i;
    sum[link.j] += link.n * link.normal_j - link.t * link.shear_j;
  }
  for (size_t l = 0; l < count; ++l) motion_[l] = inverse_[l] * sum[l];
}

void ContactSweeps::settle(Link& link) {
  DofColumn &di = motion_[link.i], &dj = motion_[link.j];
  const double gap = link.gap0 + factor_ * (link.normal_i.dot(di) + link.normal_j.dot(dj));
  if (link.n == 0 && gap >= 0) return;
  const double slide = link.slide0 + factor_ * (link.shear_i.dot(di) + link.shear_j.dot(dj));
  const Forces now = coulomb(gap - link.nn * link.n + link.ns * link.t, slide - link.ns * link.n + link.ss * link.t,
                             link.nn + link.soft_n, link.ns, link.ss + link.soft_s, link.friction, link.cohesion);
  const double dn = now.n - link.n, dt = now.t - link.t;
  di += dn * link.moved_ni - dt * link.moved_si;
  dj += dn * link.moved_nj - dt * link.moved_sj;
  link.n = now.n;
  link.t = now.t;
}

void ContactSweeps::sweep(bool backwards) {
  if (backwards)
    for (auto link = contacts_.rbegin(); link != contacts_.rend(); ++link) settle(*link);
  else
    for (Link& link : contacts_) settle(link);
}

// The forces of a contact, cut to what it can carry.
void ContactSweeps::carry_on(Link& link, double n, double t) {
  link.n = std::max(0.0, n);
  const double limit = link.n > 0 ? link.friction * link.n + link.cohesion : 0;
  link.t = std::clamp(t, -limit, limit);
}

void ContactSweeps::mix(const std::vector<Forces>& from, Mixing& mixing) {
  const Eigen::Index count = Eigen::Index(contacts_.size());
  Vector x(2 * count), change(2 * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    x[k] = from[size_t(k)].n;
    x[count + k] = from[size_t(k)].t;
    change[k] = contacts_[size_t(k)].n - x[k];
    change[count + k] = contacts_[size_t(k)].t - x[count + k];
  }
  const Vector next = mixing.next(x, change);
  for (Eigen::Index k = 0; k < count; ++k)
    if (Link& link = contacts_[size_t(k)]; link.n > 0) carry_on(link, next[k], next[count + k]);  // what has opened stays open
  rebuild();
}

ContactSweeps::Progress ContactSweeps::run(int most, double enough, int worth, Carry carry, std::vector<double>& normal,
                                           std::vector<double>& shear, Vector& d) {
  const auto& rows = problem_->contacts.rows();
  const int loose = int(blocks_.size());
  for (Link& link : contacts_) {
    const ContactRows& row = rows[link.contact];
    link.gap0 = row.gap0;
    link.slide0 = row.slide0;
    if (link.i == loose && row.size_i) {
      link.gap0 += factor_ * dot(row.normal_i, &d[row.dof_i], row.size_i);
      link.slide0 += factor_ * dot(row.shear_i, &d[row.dof_i], row.size_i);
    }
    if (link.j == loose && row.size_j) {
      link.gap0 += factor_ * dot(row.normal_j, &d[row.dof_j], row.size_j);
      link.slide0 += factor_ * dot(row.shear_j, &d[row.dof_j], row.size_j);
    }
    link.n = normal[link.contact];
    link.t = shear[link.contact];
  }
  rebuild();
  const size_t count = contacts_.size();
  std::vector<Forces> from(count), last(count);  // before the present pair; after the one before it
  for (size_t k = 0; k < count; ++k) last[k] = {contacts_[k].n, contacts_[k].t};
  Progress progress;
  Mixing mixing;
  double theta = 1, before = 0;
  double decade = 0;  // change ten pairs ago
  int since = 0;
  while (progress.pairs < most) {
    for (size_t k = 0; k < count; ++k) from[k] = {contacts_[k].n, contacts_[k].t};
    sweep(false);
    sweep(true);
    ++progress.pairs;
    double change = 0, level = 0, turned = 0;
    for (size_t k = 0; k < count; ++k) {
      const Link& link = contacts_[k];
      const double dn = link.n - from[k].n, dt = link.t - from[k].t;
      change += dn * dn + dt * dt;
      level += link.n * link.n;
      turned -= dn * (link.n - last[k].n) + dt * (link.t - last[k].t);
    }
    progress.change = level > 0 ? std::sqrt(change / level) : 0;
    if (progress.change <= enough) break;
    if (progress.pairs % 10 == 0) {
      if (worth > 0 && decade > 0 && !(progress.change < decade * std::pow(enough / progress.change, 10.0 / worth))) break;
      decade = progress.change;
    }
    if (progress.pairs == most) break;
    if (carry == Carry::mixing) {
      mix(from, mixing);
      continue;
    }
    const double next = (1 + std::sqrt(1 + 4 * theta * theta)) / 2;
    double momentum = (theta - 1) / next;
    theta = next;
    ++since;
    if (turned > 0 || (change > before && since > least_run)) {
      theta = 1;
      momentum = 0;
      since = 0;
    }
    before = change;
    for (size_t k = 0; k < count; ++k) {
      Link& link = contacts_[k];
      const Forces now{link.n, link.t};
      if (momentum > 0) carry_on(link, now.n + momentum * (now.n - last[k].n), now.t + momentum * (now.t - last[k].t));
      last[k] = now;
    }
    if (momentum > 0) rebuild();
  }
  rebuild();
  for (const Link& link : contacts_) {
    normal[link.contact] = link.n;
    shear[link.contact] = link.t;
  }
  for (int l = 0; l < loose; ++l) {
    const int dofs = problem_->dofs[blocks_[l]];
    d.segment(problem_->dof_begin[blocks_[l]], dofs) = motion_[l].head(dofs);
  }
  return progress;
}

}  // namespace talus
