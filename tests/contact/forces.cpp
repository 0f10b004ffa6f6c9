#include "forces.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace talus::study {

namespace {

DofColumn padded(const Row& row, int size) {
  DofColumn column = DofColumn::Zero();
  for (int q = 0; q < size; ++q) column[q] = row[q];
  return column;
}

// Normal and shear force of one contact with gap = gap0 + nn N - ns T, slide = slide0 + ns N - ss T, its own
// compliance in nn and ss, so that pressed means gap = 0 and sticking slide = 0.
std::pair<double, double> law(double gap0, double slide0, double nn, double ns, double ss, double friction,
                              double cohesion) {
  const double det = nn * ss - ns * ns, n = (slide0 * ns - gap0 * ss) / det, t = (nn * slide0 - ns * gap0) / det;
  if (n > 0 && std::abs(t) <= friction * n + cohesion) return {n, t};
  if (gap0 >= 0 && n <= 0) return {0, 0};
  for (const double way : {t > 0 ? 1.0 : -1.0, t > 0 ? -1.0 : 1.0}) {
    const double steep = nn - way * ns * friction;
    const double pressed = steep > 0 ? (way * ns * cohesion - gap0) / steep : 0;
    if (pressed <= 0) continue;
    const double limit = friction * pressed + cohesion;
    if (way * (slide0 + ns * pressed) >= ss * limit) return {pressed, way * limit};
  }
  const double pressed = gap0 < 0 ? std::max(n, 0.0) : 0, limit = pressed > 0 ? friction * pressed + cohesion : 0;
  return {pressed, std::clamp(t, -limit, limit)};
}

}  // namespace

Forces::Forces(const Desk& desk) : desk_(desk) {
  const Problem& problem = desk.problem;
  const auto& shapes = problem.model.shapes;
  inverse_.assign(shapes.size(), DofMatrix::Zero());
  load_.assign(shapes.size(), DofColumn::Zero());
  motion_ = load_;
  for (size_t b = 0; b < shapes.size(); ++b) {
    const int size = shapes[b].dofs;
    DofMatrix matrix = DofMatrix::Identity();
    problem.system.matrix.diagonal(int(b), matrix);
    inverse_[b].topLeftCorner(size, size) = matrix.topLeftCorner(size, size).inverse();
    load_[b].head(size) = problem.system.force.segment(shapes[b].dof_begin, size);
  }
  for (size_t k = 0; k < desk.count(); ++k) {
    const ContactRows& row = desk.row(k);
    Link l{desk.contact(k).i,
           desk.contact(k).j,
           padded(row.normal_i, row.size_i),
           padded(row.normal_j, row.size_j),
           padded(row.shear_i, row.size_i),
           padded(row.shear_j, row.size_j),
           {},
           {},
           {},
           {},
           0,
           0,
           0};
    l.moved_ni = inverse_[l.i] * l.ni;
    l.moved_nj = inverse_[l.j] * l.nj;
    l.moved_si = inverse_[l.i] * l.si;
    l.moved_sj = inverse_[l.j] * l.sj;
    l.nn = desk.factor() * (l.ni.dot(l.moved_ni) + l.nj.dot(l.moved_nj));
    l.ns = desk.factor() * (l.ni.dot(l.moved_si) + l.nj.dot(l.moved_sj));
    l.ss = desk.factor() * (l.si.dot(l.moved_si) + l.sj.dot(l.moved_sj));
    links_.push_back(l);
    normal.push_back(std::max(0.0, desk.contact(k).normal_force));
    shear.push_back(desk.contact(k).shear_force);
  }
  rebuild();
}

void Forces::rebuild() {
  std::vector<DofColumn> sum = load_;
  for (size_t k = 0; k < links_.size(); ++k) {
    sum[links_[k].i] += normal[k] * links_[k].ni - shear[k] * links_[k].si;
    sum[links_[k].j] += normal[k] * links_[k].nj - shear[k] * links_[k].sj;
  }
  for (size_t b = 0; b < sum.size(); ++b) motion_[b] = inverse_[b] * sum[b];
}

Vector Forces::motion() const {
  Vector d(desk_.problem.system.force.size());
  const auto& shapes = desk_.problem.model.shapes;
  for (size_t b = 0; b < shapes.size(); ++b)
    d.segment(shapes[b].dof_begin, shapes[b].dofs) = motion_[b].head(shapes[b].dofs);
  return d;
}

double Forces::gap(size_t k) const {
  const Link& l = links_[k];
  return desk_.row(k).gap0 + desk_.factor() * (l.ni.dot(motion_[l.i]) + l.nj.dot(motion_[l.j]));
}

double Forces::slide(size_t k) const {
  const Link& l = links_[k];
  return desk_.row(k).slide0 + desk_.factor() * (l.si.dot(motion_[l.i]) + l.sj.dot(motion_[l.j]));
}

double Forces::value() const {
  std::vector<DofColumn> sum = load_;
  double value = 0;
  for (size_t k = 0; k < links_.size(); ++k) {
    const ContactRows& row = desk_.row(k);
    sum[links_[k].i] += normal[k] * links_[k].ni - shear[k] * links_[k].si;
    sum[links_[k].j] += normal[k] * links_[k].nj - shear[k] * links_[k].sj;
    value += (normal[k] * (row.gap0 + normal[k] / (2 * row.kn)) + shear[k] * (shear[k] / (2 * row.ks) - row.slide0)) /
             desk_.factor();
  }
  for (size_t b = 0; b < sum.size(); ++b) value += sum[b].dot(inverse_[b] * sum[b]) / 2;
  return value;
}

void Forces::settle(size_t k) {
  const Link& l = links_[k];
  const ContactRows& row = desk_.row(k);
  const double gap_now = gap(k);
  if (normal[k] == 0 && gap_now >= 0) return;
  const auto [n, t] = law(gap_now - l.nn * normal[k] + l.ns * shear[k], slide(k) - l.ns * normal[k] + l.ss * shear[k],
                          l.nn + 1 / row.kn, l.ns, l.ss + 1 / row.ks, row.friction, row.cohesion);
  const double dn = n - normal[k], dt = t - shear[k];
  motion_[l.i] += dn * l.moved_ni - dt * l.moved_si;
  motion_[l.j] += dn * l.moved_nj - dt * l.moved_sj;
  normal[k] = n;
  shear[k] = t;
}

void Forces::sweep(bool backwards) {
  const size_t count = links_.size();
  for (size_t k = 0; k < count; ++k) settle(backwards ? count - 1 - k : k);
}

}  // namespace talus::study
