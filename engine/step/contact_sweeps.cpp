#include "step/contact_sweeps.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace talus {

namespace {

// Pairs of sweeps after which a restart of the momentum by growth of the change is allowed: it takes a few to build up.
constexpr int least_run = 5;
// Blocks. The larger the patches the fewer the sweeps; a patch costs the cube of its unknowns.
constexpr size_t most_in_patch = 6;

template <int n>
ColumnOf<n> padded(const Row& row, int size) {
  ColumnOf<n> column = ColumnOf<n>::Zero();
  for (int k = 0; k < size; ++k) column[k] = row[size_t(k)];
  return column;
}

// The law of one contact: gap = gap0 + nn n - ns t, slide = slide0 + ns n - ss t, stiffness included in nn and ss, so
// pressed and sticking mean gap = 0 and slide = 0. Cohesion holds at n = 0 too (ContactTerms::linearise).
Sweeping::Forces coulomb(double gap0, double slide0, double nn, double ns, double ss, double friction, double cohesion) {
  const double det = nn * ss - ns * ns;  // > 0: a contact's own compliance is in both
  const double n = (-gap0 * ss + slide0 * ns) / det, t = (nn * slide0 - ns * gap0) / det;
  if (n > 0 && std::abs(t) <= friction * n + cohesion) return {n, t};
  const double alone = std::clamp(slide0 / ss, -cohesion, cohesion);
  if (gap0 - ns * alone >= 0 && n <= 0) return {0, alone};
  // Sliding towards where sticking would ask too much, else the other way.
  for (const double way : {t > 0 ? 1.0 : -1.0, t > 0 ? -1.0 : 1.0}) {
    const double steep = nn - way * ns * friction;  // not positive: it would wedge itself without bound
    if (steep <= 0) continue;
    const double pressed = (-gap0 + way * ns * cohesion) / steep;
    if (pressed <= 0) continue;
    const double limit = friction * pressed + cohesion;
    if (way * (slide0 + ns * pressed) - ss * limit >= 0) return {pressed, way * limit};
  }
  if (gap0 - ns * alone >= 0) return {0, alone};
  // Nothing fits to the last digit, at the border of two cases: the nearest of sticking.
  const double pressed = std::max(n, 0.0), limit = friction * pressed + cohesion;
  return {pressed, std::clamp(t, -limit, limit)};
}

}  // namespace

template <int size>
void SweepsOf<size>::start(const ContactProblem& problem) {
  problem_ = &problem;
  const System& system = problem.system;
  factor_ = problem.contacts.factor();
  contacts_.clear();
  with_.clear();
  blocks_.clear();
  patches_.clear();
  std::vector<int> place(problem.blocks.size(), -1);
  for (size_t b = 0; b < place.size(); ++b)
    if (problem.dofs[b] > 0) {
      place[b] = int(blocks_.size());
      blocks_.push_back(int(b));
    }
  const size_t count = blocks_.size();
  force_.assign(count + 1, Column::Zero());
  motion_.assign(count + 1, Column::Zero());
  bond_.assign(count, Column::Zero());
  for (size_t l = 0; l < count; ++l)
    force_[l].head(problem.dofs[blocks_[l]]) =
        system.force.segment(problem.dof_begin[blocks_[l]], problem.dofs[blocks_[l]]);
  ties_.assign(count, {});
  Matrix coupling = Matrix::Zero();
  for (const auto& [column, row] : system.matrix.pairs()) {
    if (row == column || place[row] < 0 || place[column] < 0) continue;
    coupling.setZero();
    system.matrix.part(row, column, coupling);
    if (coupling.isZero(0)) continue;  // they only touch
    ties_[place[row]].push_back({place[column], coupling});
    ties_[place[column]].push_back({place[row], coupling.transpose()});
  }
  find_patches();
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k)
    if (rows[k].near && (place[rows[k].i] >= 0 || place[rows[k].j] >= 0)) add_link(rows[k], int(k), place);
}

// Blocks that hang together, a few at a time, breadth first.
template <int size>
void SweepsOf<size>::find_patches() {
  const int count = int(blocks_.size());
  patch_of_.assign(size_t(count) + 1, -1);
  rank_.assign(size_t(count) + 1, 0);
  for (int first = 0; first < count; ++first) {
    if (patch_of_[first] >= 0) continue;
    const int own = int(patches_.size());
    Patch& patch = patches_.emplace_back();
    patch.blocks = {first};
    patch_of_[first] = own;
    for (size_t k = 0; k < patch.blocks.size(); ++k)
      for (const Tie& tie : ties_[patch.blocks[k]]) {
        if (patch_of_[tie.other] >= 0 || patch.blocks.size() >= most_in_patch) continue;
        patch_of_[tie.other] = own;
        patch.blocks.push_back(tie.other);
      }
    const Eigen::Index members = Eigen::Index(patch.blocks.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(members * size, members * size);
    for (Eigen::Index k = 0; k < members; ++k) rank_[patch.blocks[k]] = int(k);
    Matrix diagonal;
    for (Eigen::Index k = 0; k < members; ++k) {
      diagonal.setIdentity();
      const int block = patch.blocks[k];
      problem_->system.matrix.diagonal(blocks_[block], diagonal);
      matrix.template block<size, size>(k * size, k * size) = diagonal;
      auto& ties = ties_[block];
      for (const Tie& tie : ties)
        if (patch_of_[tie.other] == own)
          matrix.template block<size, size>(k * size, rank_[tie.other] * size) = tie.k;
      std::erase_if(ties, [&](const Tie& tie) { return patch_of_[tie.other] == own; });
      patch.tied = patch.tied || !ties.empty();
    }
    patch.inverse = matrix.inverse();
    for (Eigen::Index k = 0; k < members; ++k)
      for (int dof = problem_->dofs[blocks_[patch.blocks[k]]]; dof < size; ++dof)
        patch.inverse.col(k * size + dof).setZero();
  }
}

template <int size>
void SweepsOf<size>::add_link(const ContactRows& row, int contact, const std::vector<int>& place) {
  const int held = int(blocks_.size());
  Link& link = contacts_.emplace_back();
  link.i = place[row.i] >= 0 ? place[row.i] : held;
  link.j = place[row.j] >= 0 ? place[row.j] : held;
  link.normal_i = padded<size>(row.normal_i, link.i < held ? row.size_i : 0);
  link.normal_j = padded<size>(row.normal_j, link.j < held ? row.size_j : 0);
  link.shear_i = padded<size>(row.shear_i, link.i < held ? row.size_i : 0);
  link.shear_j = padded<size>(row.shear_j, link.j < held ? row.size_j : 0);
  for (Column* moved : {&link.moved_ni, &link.moved_nj, &link.moved_si, &link.moved_sj}) moved->setZero();
  link.with_begin = int(with_.size());
  for (const auto& [block, normal, shear] : {std::tuple{link.i, &link.normal_i, &link.shear_i}, {link.j, &link.normal_j, &link.shear_j}}) {
    if (block == held) continue;
    const Patch& patch = patches_[patch_of_[block]];
    for (const int moved : patch.blocks) {
      const auto inverse = patch.inverse.template block<size, size>(rank_[moved] * size, rank_[block] * size);
      const Column n = inverse * *normal, s = inverse * *shear;
      if (moved == link.i || moved == link.j) {
        (moved == link.i ? link.moved_ni : link.moved_nj) += n;
        (moved == link.i ? link.moved_si : link.moved_sj) += s;
        continue;
      }
      const auto own = std::find_if(with_.begin() + link.with_begin, with_.end(), [&](const With& w) { return w.block == moved; });
      if (own == with_.end()) {
        with_.push_back({moved, n, s});
      } else {
        own->n += n;
        own->s += s;
      }
    }
  }
  link.with_end = int(with_.size());
  link.nn = factor_ * (link.normal_i.dot(link.moved_ni) + link.normal_j.dot(link.moved_nj));
  link.ns = factor_ * (link.normal_i.dot(link.moved_si) + link.normal_j.dot(link.moved_sj));
  link.ss = factor_ * (link.shear_i.dot(link.moved_si) + link.shear_j.dot(link.moved_sj));
  link.soft_n = 1 / row.kn;
  link.soft_s = 1 / row.ks;
  link.friction = row.friction;
  link.cohesion = row.cohesion;
  link.contact = contact;
}

template <int size>
void SweepsOf<size>::rebuild() {
  std::vector<Column> sum = force_;
  for (const Link& link : contacts_) {
    sum[link.i] += link.n * link.normal_i - link.t * link.shear_i;
    sum[link.j] += link.n * link.normal_j - link.t * link.shear_j;
  }
  for (size_t l = 0; l < bond_.size(); ++l) sum[l] += bond_[l];
  for (const Patch& patch : patches_)
    for (const int b : patch.blocks) {
      motion_[b].setZero();
      for (const int other : patch.blocks)
        motion_[b] += patch.inverse.template block<size, size>(rank_[b] * size, rank_[other] * size) * sum[other];
    }
}

template <int size>
void SweepsOf<size>::relax(const Patch& patch) {
  if (!patch.tied) return;
  for (const int b : patch.blocks) {
    if (ties_[b].empty()) continue;
    Column force = Column::Zero();
    for (const Tie& tie : ties_[b]) force -= tie.k * motion_[tie.other];
    const Column change = force - bond_[b];
    bond_[b] = force;
    for (const int moved : patch.blocks)
      motion_[moved] += patch.inverse.template block<size, size>(rank_[moved] * size, rank_[b] * size) * change;
  }
}

template <int size>
void SweepsOf<size>::settle(Link& link) {
  Column &di = motion_[link.i], &dj = motion_[link.j];
  const double gap = link.gap0 + factor_ * (link.normal_i.dot(di) + link.normal_j.dot(dj));
  if (link.n == 0 && gap >= 0 && link.cohesion == 0) return;
  const double slide = link.slide0 + factor_ * (link.shear_i.dot(di) + link.shear_j.dot(dj));
  const Forces now = coulomb(gap - link.nn * link.n + link.ns * link.t, slide - link.ns * link.n + link.ss * link.t,
                             link.nn + link.soft_n, link.ns, link.ss + link.soft_s, link.friction, link.cohesion);
  const double dn = now.n - link.n, dt = now.t - link.t;
  if (dn == 0 && dt == 0) return;
  di += dn * link.moved_ni - dt * link.moved_si;
  dj += dn * link.moved_nj - dt * link.moved_sj;
  for (int k = link.with_begin; k < link.with_end; ++k) motion_[with_[k].block] += dn * with_[k].n - dt * with_[k].s;
  link.n = now.n;
  link.t = now.t;
}

template <int size>
void SweepsOf<size>::sweep(bool backwards) {
  if (backwards) {
    for (auto patch = patches_.rbegin(); patch != patches_.rend(); ++patch) relax(*patch);
    for (auto link = contacts_.rbegin(); link != contacts_.rend(); ++link) settle(*link);
  } else {
    for (Link& link : contacts_) settle(link);
    for (const Patch& patch : patches_) relax(patch);
  }
}

// The forces of a contact, cut to what it can carry.
template <int size>
void SweepsOf<size>::carry_on(Link& link, double n, double t) {
  link.n = std::max(0.0, n);
  const double limit = (link.n > 0 ? link.friction * link.n : 0) + link.cohesion;
  link.t = std::clamp(t, -limit, limit);
}

template <int size>
void SweepsOf<size>::mix(const std::vector<Forces>& from, Mixing& mixing) {
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

template <int size>
Sweeping::Progress SweepsOf<size>::run(int most, double enough, int worth, Carry carry, std::vector<double>& normal,
                                           std::vector<double>& shear, Vector& d) {
  const auto& rows = problem_->contacts.rows();
  const int blocks = int(blocks_.size());
  for (Link& link : contacts_) {
    const ContactRows& row = rows[link.contact];
    link.gap0 = row.gap0;
    link.slide0 = row.slide0;
    link.n = normal[link.contact];
    link.t = shear[link.contact];
  }
  for (int l = 0; l < blocks; ++l) {
    motion_[l].setZero();
    motion_[l].head(problem_->dofs[blocks_[l]]) = d.segment(problem_->dof_begin[blocks_[l]], problem_->dofs[blocks_[l]]);
  }
  for (int l = 0; l < blocks; ++l) {
    bond_[l].setZero();
    for (const Tie& tie : ties_[l]) bond_[l] -= tie.k * motion_[tie.other];
  }
  rebuild();
  const size_t count = contacts_.size();
  std::vector<Column> bond_from, bond_last = bond_;
  std::vector<Forces> from(count), last(count);  // before the present pair; after the one before it
  for (size_t k = 0; k < count; ++k) last[k] = {contacts_[k].n, contacts_[k].t};
  Progress progress;
  Mixing mixing;
  double theta = 1, before = 0;
  double decade = 0;  // change ten pairs ago
  int since = 0;
  while (progress.pairs < most) {
    for (size_t k = 0; k < count; ++k) from[k] = {contacts_[k].n, contacts_[k].t};
    bond_from = bond_;
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
    for (int l = 0; l < blocks; ++l) {
      const Column db = bond_[l] - bond_from[l];
      change += db.squaredNorm();
      level += bond_[l].squaredNorm();
      turned -= db.dot(bond_[l] - bond_last[l]);
    }
    progress.change = level > 0 ? std::sqrt(change / level) : 0;
    progress.moved = std::sqrt(change);
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
    for (int l = 0; l < blocks; ++l) {
      const Column now = bond_[l];
      if (momentum > 0) bond_[l] += momentum * (now - bond_last[l]);
      bond_last[l] = now;
    }
    if (momentum > 0) rebuild();
  }
  rebuild();
  for (const Link& link : contacts_) {
    normal[link.contact] = link.n;
    shear[link.contact] = link.t;
  }
  for (int l = 0; l < blocks; ++l) {
    const int dofs = problem_->dofs[blocks_[l]];
    d.segment(problem_->dof_begin[blocks_[l]], dofs) = motion_[l].head(dofs);
  }
  return progress;
}

template class SweepsOf<first_order_dofs>;
template class SweepsOf<second_order_dofs>;

void ContactSweeps::start(const ContactProblem& problem) {
  second_order_ = std::find(problem.dofs.begin(), problem.dofs.end(), second_order_dofs) != problem.dofs.end();
  if (second_order_)
    second_.start(problem);
  else
    first_.start(problem);
}

}  // namespace talus
