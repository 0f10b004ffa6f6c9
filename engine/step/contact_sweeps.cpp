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
// Pairs. Motions that are carried on with the forces gather rounding, which stiff rigid walls answer with more sweeps.
constexpr int rebuilt_every = 10;

template <int n>
ColumnOf<n> padded(const Row& row, int size) {
  ColumnOf<n> column = ColumnOf<n>::Zero();
  for (int k = 0; k < size; ++k) column[k] = row[size_t(k)];
  return column;
}

}  // namespace

Sweeping::ContactLaw::ContactLaw(double normal, double mixed, double shear, double tan_phi, double held)
    : friction(tan_phi), cohesion(held), nn(normal), ns(mixed), ss(shear), by_det(1 / (nn * ss - ns * ns)), by_ss(1 / ss) {
  for (const int way : {0, 1}) {
    const double steep = nn - (way == 0 ? 1 : -1) * ns * friction;
    by_steep[way] = steep > 0 ? 1 / steep : 0;
  }
}

// `stuck`: what sticking would ask for, which is too much.
Sweeping::Forces Sweeping::ContactLaw::slide_or_open(double gap0, double slide0, Forces stuck) const {
  const double alone = std::clamp(slide0 * by_ss, -cohesion, cohesion);
  const bool open = gap0 - ns * alone >= 0;
  if (open && stuck.n <= 0) return {0, alone};
  // Sliding towards where sticking would ask too much, else the other way.
  for (const bool back : {stuck.t <= 0, stuck.t > 0}) {
    const double way = back ? -1 : 1;
    const double pressed = (way * ns * cohesion - gap0) * by_steep[back];
    if (pressed <= 0) continue;
    const double limit = friction * pressed + cohesion;
    if (way * (slide0 + ns * pressed) - ss * limit >= 0) return {pressed, way * limit};
  }
  if (open) return {0, alone};
  // Nothing fits to the last digit, at the border of two cases: the nearest of sticking.
  return carried(stuck);
}

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
  for (size_t l = 0; l < count; ++l)
    force_[l].head(problem.dofs[blocks_[l]]) =
        system.force.segment(problem.dof_begin[blocks_[l]], problem.dofs[blocks_[l]]);
  find_patches(find_ties(place));
  const auto& rows = problem.contacts.rows();
  for (size_t k = 0; k < rows.size(); ++k)
    if (rows[k].near && (place[rows[k].i] >= 0 || place[rows[k].j] >= 0)) add_link(rows[k], int(k), place);
}

// Of each block, by what is stiff between it and others.
template <int size>
std::vector<std::vector<typename SweepsOf<size>::Tie>> SweepsOf<size>::find_ties(const std::vector<int>& place) const {
  const BlockMatrix& matrix = problem_->system.matrix;
  std::vector<std::vector<Tie>> ties(blocks_.size());
  Matrix coupling = Matrix::Zero();
  for (const auto& [column, row] : matrix.pairs()) {
    if (row == column || place[row] < 0 || place[column] < 0) continue;
    coupling.setZero();
    matrix.part(row, column, coupling);
    if (coupling.isZero(0)) continue;  // they only touch
    ties[place[row]].push_back({place[column], coupling});
    ties[place[column]].push_back({place[row], coupling.transpose()});
  }
  return ties;
}

// Blocks that hang together, a few at a time, breadth first.
template <int size>
void SweepsOf<size>::find_patches(std::vector<std::vector<Tie>> ties) {
  tied_.clear();
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
      for (const Tie& tie : ties[patch.blocks[k]]) {
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
      for (const Tie& tie : ties[block])
        if (patch_of_[tie.other] == own)
          matrix.template block<size, size>(k * size, rank_[tie.other] * size) = tie.k;
      std::erase_if(ties[block], [&](const Tie& tie) { return patch_of_[tie.other] == own; });
      if (!ties[block].empty()) tied_.push_back({block, own, std::move(ties[block])});
    }
    patch.inverse = matrix.inverse();
    for (Eigen::Index k = 0; k < members; ++k)
      for (int dof = problem_->dofs[blocks_[patch.blocks[k]]]; dof < size; ++dof)
        patch.inverse.col(k * size + dof).setZero();
  }
}

template <int size>
bool SweepsOf<size>::bonded() const {
  size_t patches = 0;
  for (size_t t = 0; t < tied_.size(); ++t) patches += t == 0 || tied_[t].patch != tied_[t - 1].patch;
  return 2 * patches > patches_.size();
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
  link.law = ContactLaw(link.nn + 1 / row.kn, link.ns, link.ss + 1 / row.ks, row.friction, row.cohesion);
  link.contact = contact;
}

template <int size>
void SweepsOf<size>::rebuild() {
  std::vector<Column> sum = force_;
  for (size_t k = 0; k < contacts_.size(); ++k) {
    const Link& link = contacts_[k];
    const auto [n, t] = forces_[k];
    if (n == 0 && t == 0) continue;
    sum[link.i] += n * link.normal_i - t * link.shear_i;
    sum[link.j] += n * link.normal_j - t * link.shear_j;
  }
  for (size_t t = 0; t < tied_.size(); ++t) sum[tied_[t].block] += bond_[t];
  using OfPatch = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, int(most_in_patch) * size, 1>;
  OfPatch forces, motions;
  for (const Patch& patch : patches_) {
    if (patch.blocks.size() == 1) {
      motion_[patch.blocks[0]].noalias() = patch.inverse.template topLeftCorner<size, size>() * sum[patch.blocks[0]];
      continue;
    }
    forces.resize(patch.inverse.cols());
    for (const int b : patch.blocks) forces.template segment<size>(rank_[b] * size) = sum[b];
    motions.noalias() = patch.inverse * forces;
    for (const int b : patch.blocks) motion_[b] = motions.template segment<size>(rank_[b] * size);
  }
}

template <int size>
void SweepsOf<size>::relax(size_t tied) {
  const Tied& own = tied_[tied];
  Column force = Column::Zero();
  for (const Tie& tie : own.ties) force -= tie.k * motion_[tie.other];
  const Column change = force - bond_[tied];
  bond_[tied] = force;
  const Patch& patch = patches_[own.patch];
  for (const int moved : patch.blocks)
    motion_[moved] += patch.inverse.template block<size, size>(rank_[moved] * size, rank_[own.block] * size) * change;
}

template <int size>
void SweepsOf<size>::settle(const Link& link, Forces& forces) {
  const Column &di = motion_[link.i], &dj = motion_[link.j];
  const double gap = link.gap0 + factor_ * (link.normal_i.dot(di) + link.normal_j.dot(dj));
  if (forces.n == 0 && gap >= 0 && link.law.cohesion == 0) return;
  const double slide = link.slide0 + factor_ * (link.shear_i.dot(di) + link.shear_j.dot(dj));
  const Forces now = link.law.meet(gap - link.nn * forces.n + link.ns * forces.t, slide - link.ns * forces.n + link.ss * forces.t);
  if (now.n == forces.n && now.t == forces.t) return;
  move(link, now.n - forces.n, now.t - forces.t);
  forces = now;
}

template <int size>
void SweepsOf<size>::move(const Link& link, double dn, double dt) {
  motion_[link.i] += dn * link.moved_ni - dt * link.moved_si;
  motion_[link.j] += dn * link.moved_nj - dt * link.moved_sj;
  for (int k = link.with_begin; k < link.with_end; ++k) motion_[with_[k].block] += dn * with_[k].n - dt * with_[k].s;
}

template <int size>
void SweepsOf<size>::sweep(bool backwards) {
  if (backwards) {
    for (size_t t = tied_.size(); t-- > 0;) relax(t);
    for (size_t k = contacts_.size(); k-- > 0;) settle(contacts_[k], forces_[k]);
  } else {
    for (size_t k = 0; k < contacts_.size(); ++k) settle(contacts_[k], forces_[k]);
    for (size_t t = 0; t < tied_.size(); ++t) relax(t);
  }
}

template <int size>
struct SweepsOf<size>::Change {  // of a pair of sweeps, N²
  double change = 0, level = 0;
  double turned = 0;  // > 0: against the change since the pair before
};

template <int size>
typename SweepsOf<size>::Change SweepsOf<size>::change(const State& from, const State& last) const {
  Change sum;
  for (size_t k = 0; k < forces_.size(); ++k) {
    const Forces now = forces_[k];
    const double dn = now.n - from.forces[k].n, dt = now.t - from.forces[k].t;
    sum.change += dn * dn + dt * dt;
    sum.level += now.n * now.n;
    sum.turned -= dn * (now.n - last.forces[k].n) + dt * (now.t - last.forces[k].t);
  }
  for (size_t l = 0; l < bond_.size(); ++l) {
    const Column db = bond_[l] - from.bond[l];
    sum.change += db.squaredNorm();
    sum.level += bond_[l].squaredNorm();
    sum.turned -= db.dot(bond_[l] - last.bond[l]);
  }
  return sum;
}

// Forces go on along their change since `last`, motions along theirs, less what contacts cannot carry; `anew`: motions are added up from
// the forces.
template <int size>
void SweepsOf<size>::carry_on(const State& last, double momentum, bool anew) {
  for (size_t t = 0; t < bond_.size(); ++t) bond_[t] += momentum * (bond_[t] - last.bond[t]);
  for (size_t l = 0; l < motion_.size(); ++l) motion_[l] += momentum * (motion_[l] - last.motion[l]);
  for (size_t k = 0; k < forces_.size(); ++k) {
    const Forces now = forces_[k], before = last.forces[k];
    const Forces asked = {now.n + momentum * (now.n - before.n), now.t + momentum * (now.t - before.t)};
    const Forces carried = forces_[k] = contacts_[k].law.carried(asked);
    if (carried.n != asked.n || carried.t != asked.t) move(contacts_[k], carried.n - asked.n, carried.t - asked.t);
  }
  if (anew) rebuild();
}

template <int size>
void SweepsOf<size>::mix(const State& from, Mixing& mixing) {
  const Eigen::Index count = Eigen::Index(contacts_.size());
  Vector x(2 * count), change(2 * count);
  for (Eigen::Index k = 0; k < count; ++k) {
    x[k] = from.forces[size_t(k)].n;
    x[count + k] = from.forces[size_t(k)].t;
    change[k] = forces_[size_t(k)].n - x[k];
    change[count + k] = forces_[size_t(k)].t - x[count + k];
  }
  const Vector& next = mixing.next(x, change);
  for (Eigen::Index k = 0; k < count; ++k)
    if (Forces& forces = forces_[size_t(k)]; forces.n > 0)  // what has opened stays open
      forces = contacts_[size_t(k)].law.carried({next[k], next[count + k]});
  rebuild();
}

template <int size>
Sweeping::Progress SweepsOf<size>::run(int most, double enough, int worth, Carry carry, std::vector<double>& normal,
                                           std::vector<double>& shear, Vector& d) {
  const auto& rows = problem_->contacts.rows();
  const int blocks = int(blocks_.size());
  forces_.resize(contacts_.size());
  for (size_t k = 0; k < contacts_.size(); ++k) {
    Link& link = contacts_[k];
    link.gap0 = rows[link.contact].gap0;
    link.slide0 = rows[link.contact].slide0;
    forces_[k] = {normal[link.contact], shear[link.contact]};
  }
  for (int l = 0; l < blocks; ++l) {
    motion_[l].setZero();
    motion_[l].head(problem_->dofs[blocks_[l]]) = d.segment(problem_->dof_begin[blocks_[l]], problem_->dofs[blocks_[l]]);
  }
  bond_.assign(tied_.size(), Column::Zero());
  for (size_t t = 0; t < tied_.size(); ++t)
    for (const Tie& tie : tied_[t].ties) bond_[t] -= tie.k * motion_[tie.other];
  rebuild();
  State from, last{forces_, bond_, motion_};  // before the present pair; after the one before it
  Progress progress;
  Mixing mixing;
  double theta = 1, before = 0;
  double decade = 0;  // change ten pairs ago
  int since = 0;
  while (progress.pairs < most) {
    from.forces = forces_;
    from.bond = bond_;
    sweep(false);
    sweep(true);
    ++progress.pairs;
    const Change now = change(from, last);
    progress.change = now.level > 0 ? std::sqrt(now.change / now.level) : 0;
    progress.moved = std::sqrt(now.change);
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
    if (now.turned > 0 || (now.change > before && since > least_run)) {
      theta = 1;
      momentum = 0;
      since = 0;
    }
    before = now.change;
    State& reached = from;
    reached.forces = forces_;
    reached.bond = bond_;
    reached.motion = motion_;
    if (momentum > 0) carry_on(last, momentum, progress.pairs % rebuilt_every == 0);
    std::swap(reached, last);
  }
  rebuild();
  for (size_t k = 0; k < contacts_.size(); ++k) {
    normal[contacts_[k].contact] = forces_[k].n;
    shear[contacts_[k].contact] = forces_[k].t;
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
