#include "step/contact_sweeps.h"

#include <Eigen/Cholesky>
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
// Pairs after which all contacts are looked at, not those alone that press or may soon, and motions are added up anew: carried on with
// the forces they gather rounding, which stiff rigid walls answer with more sweeps.
constexpr int rebuilt_every = 10;
constexpr double ahead = 2;  // times that way: contacts that would close in it may soon press

template <int n>
ColumnOf<n> padded(const Row& row, int size) {
  ColumnOf<n> column = ColumnOf<n>::Zero();
  for (int k = 0; k < size; ++k) column[k] = row[size_t(k)];
  return column;
}

template <int n>
MatrixOf<n> inverse_of_lower(const MatrixOf<n>& lower) {
  MatrixOf<n> inverse = MatrixOf<n>::Zero();
  for (int column = 0; column < n; ++column)
    for (int row = column; row < n; ++row) {
      double left = row == column ? 1 : 0;
      for (int k = column; k < row; ++k) left -= lower(row, k) * inverse(k, column);
      inverse(row, column) = left / lower(row, row);
    }
  return inverse;
}

}  // namespace

template <int size>
void SweepsOf<size>::start(const ContactProblem& problem) {
  problem_ = &problem;
  const System& system = problem.system;
  factor_ = problem.contacts.factor();
  contacts_.clear();
  rows_.clear();
  moved_.clear();
  moved_block_.clear();
  blocks_.clear();
  lower_.clear();
  to_own_.clear();
  patches_.clear();
  std::vector<int> place(problem.blocks.size(), -1);
  for (size_t b = 0; b < place.size(); ++b)
    if (problem.dofs[b] > 0) {
      place[b] = int(blocks_.size());
      blocks_.push_back(int(b));
      Matrix own = Matrix::Identity();
      system.matrix.diagonal(int(b), own);
      const Eigen::LLT<Matrix> factored(own);
      lower_.push_back(factored.info() == Eigen::Success ? Matrix(factored.matrixL()) : Matrix(Matrix::Identity()));
      to_own_.push_back(inverse_of_lower<size>(lower_.back()));
    }
  const size_t count = blocks_.size();
  force_.assign(count + 1, Lanes<size>{});
  motion_.assign(count + 1, Lanes<size>{});
  for (size_t l = 0; l < count; ++l) {
    Column force = Column::Zero();
    force.head(problem.dofs[blocks_[l]]) = system.force.segment(problem.dof_begin[blocks_[l]], problem.dofs[blocks_[l]]);
    force_[l] = Lanes<size>::of(to_own_[l] * force);
  }
  find_patches(find_ties(place));
  const auto& rows = problem.contacts.rows();
  contacts_.reserve(rows.size());
  rows_.reserve(rows.size());
  for (size_t k = 0; k < rows.size(); ++k)
    if (rows[k].near && (place[rows[k].i] >= 0 || place[rows[k].j] >= 0)) add_link(rows[k], int(k), place);
  put_in_order();
  pack();
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
    const int a = place[row], b = place[column];
    ties[a].push_back({b, coupling * to_own_[b].transpose()});
    ties[b].push_back({a, coupling.transpose() * to_own_[a].transpose()});
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
    Matrix part;
    for (Eigen::Index k = 0; k < members; ++k) {
      const int block = patch.blocks[k];
      part.setIdentity();
      problem_->system.matrix.diagonal(blocks_[block], part);
      matrix.template block<size, size>(k * size, k * size) = to_own_[block] * part * to_own_[block].transpose();
      for (const Tie& tie : ties[block])
        if (patch_of_[tie.other] == own)
          matrix.template block<size, size>(k * size, rank_[tie.other] * size) = to_own_[block] * tie.k;
      std::erase_if(ties[block], [&](const Tie& tie) { return patch_of_[tie.other] == own; });
      if (!ties[block].empty()) tied_.push_back({block, own, std::move(ties[block])});
    }
    patch.unit = members == 1 && !lower_[first].isIdentity(0);
    patch.inverse = patch.unit ? std::move(matrix) : Eigen::MatrixXd(matrix.inverse());
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
  link.rows = int(rows_.size());
  SweptRows<size>& rows = rows_.emplace_back();
  const auto in_own_axes = [&](const Row& of, int block, int dofs) {
    return block == held ? Lanes<size>{} : Lanes<size>::of(to_own_[block] * padded<size>(of, dofs));
  };
  rows = {in_own_axes(row.normal_i, link.i, row.size_i), in_own_axes(row.normal_j, link.j, row.size_j),
          in_own_axes(row.shear_i, link.i, row.size_i), in_own_axes(row.shear_j, link.j, row.size_j)};
  link.moved_begin = int(moved_.size());
  const auto unit = [&](int block) { return block == held || patches_[patch_of_[block]].unit; };
  const SweptRows<size> moved = unit(link.i) && unit(link.j) ? rows : add_moved(link);
  link.moved_end = int(moved_.size());
  link.nn = factor_ * along(rows.ni, moved.ni, rows.nj, moved.nj);
  link.ns = factor_ * along(rows.ni, moved.si, rows.nj, moved.sj);
  link.ss = factor_ * along(rows.si, moved.si, rows.sj, moved.sj);
  link.law = SweptLaw(link.nn + 1 / row.kn, link.ns, link.ss + 1 / row.ks, row.friction, row.cohesion);
  link.contact = contact;
}

// What a contact on bonded blocks moves: all of their patches. Of the motions those of its own two blocks.
template <int size>
SweptRows<size> SweepsOf<size>::add_moved(const Link& link) {
  const int held = int(blocks_.size());
  SweptRows<size> rows = rows_[link.rows];
  struct Moved {
    int block;
    Lanes<size> n, s;
  };
  std::vector<Moved> all;
  for (const auto& [block, normal, shear] : {std::tuple{link.i, &rows.ni, &rows.si}, {link.j, &rows.nj, &rows.sj}}) {
    if (block == held) continue;
    const Patch& patch = patches_[patch_of_[block]];
    for (const int other : patch.blocks) {
      const auto inverse = patch.inverse.template block<size, size>(rank_[other] * size, rank_[block] * size);
      auto own = std::find_if(all.begin(), all.end(), [&](const Moved& moved) { return moved.block == other; });
      if (own == all.end()) own = all.insert(own, {other, {}, {}});
      own->n.column() += inverse * normal->column();
      own->s.column() += inverse * shear->column();
    }
  }
  SweptRows<size> of_own{};
  for (const Moved& moved : all) {
    SweptMotion<size>& motion = moved_.emplace_back();
    std::copy(std::begin(moved.n.v), std::end(moved.n.v), motion.n);
    std::copy(std::begin(moved.s.v), std::end(moved.s.v), motion.s);
    moved_block_.push_back(moved.block);
    if (moved.block == link.i) of_own.ni = moved.n, of_own.si = moved.s;
    if (moved.block == link.j) of_own.nj = moved.n, of_own.sj = moved.s;
  }
  return of_own;
}

// From one end of the island to the other: on its way a sweep takes along what it has found, where in any other order it goes from
// neighbour to neighbour a sweep each time.
template <int size>
void SweepsOf<size>::put_in_order() {
  if (contacts_.empty()) return;
  const auto place = [&](const Link& link) -> const Vec2& { return problem_->model->vertex[problem_->before(size_t(link.contact)).global_vertex]; };
  Vec2 low = place(contacts_[0]), high = low;
  for (const Link& link : contacts_) {
    low = low.cwiseMin(place(link));
    high = high.cwiseMax(place(link));
  }
  Eigen::Index longer = 0;
  (high - low).maxCoeff(&longer);
  std::stable_sort(contacts_.begin(), contacts_.end(), [&](const Link& a, const Link& b) { return place(a)[longer] < place(b)[longer]; });
}

// Rows and what is moved in the order in which sweeps come by.
template <int size>
void SweepsOf<size>::pack() {
  std::vector<SweptRows<size>> rows;
  std::vector<SweptMotion<size>> moved;
  std::vector<int> moved_block;
  rows.reserve(rows_.size() + 1);
  moved.reserve(moved_.size());
  moved_block.reserve(moved_.size());
  for (Link& link : contacts_) {
    rows.push_back(rows_[link.rows]);
    link.rows = int(rows.size()) - 1;
    const int begin = link.moved_begin, end = link.moved_end;
    link.moved_begin = int(moved.size());
    moved.insert(moved.end(), moved_.begin() + begin, moved_.begin() + end);
    moved_block.insert(moved_block.end(), moved_block_.begin() + begin, moved_block_.begin() + end);
    link.moved_end = int(moved.size());
  }
  rows.push_back({});
  rows_ = std::move(rows);
  moved_ = std::move(moved);
  moved_block_ = std::move(moved_block);
}

template <int size>
void SweepsOf<size>::rebuild() {
  std::vector<Lanes<size>>& sum = motion_;
  sum = force_;
  for (size_t k = 0; k < contacts_.size(); ++k) {
    const Link& link = contacts_[k];
    const auto [n, t] = forces_[k];
    if (n == 0 && t == 0) continue;
    const SweptRows<size>& rows = rows_[link.rows];
    go(rows.ni, rows.si, n, t, sum[link.i]);
    go(rows.nj, rows.sj, n, t, sum[link.j]);
  }
  for (size_t t = 0; t < tied_.size(); ++t)
    sum[tied_[t].block].column() += to_own_[tied_[t].block] * bond_[t];
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, int(most_in_patch) * size, 1> forces, motions;
  for (const Patch& patch : patches_) {
    if (patch.unit) continue;
    forces.resize(patch.inverse.cols());
    for (const int b : patch.blocks) forces.template segment<size>(rank_[b] * size) = sum[b].column();
    motions.noalias() = patch.inverse * forces;
    for (const int b : patch.blocks) motion_[b].column() = motions.template segment<size>(rank_[b] * size);
  }
}

template <int size>
void SweepsOf<size>::relax(size_t tied) {
  const Tied& own = tied_[tied];
  Column force = Column::Zero();
  for (const Tie& tie : own.ties) force -= tie.k * motion_[tie.other].column();
  const Column change = to_own_[own.block] * (force - bond_[tied]);
  bond_[tied] = force;
  const Patch& patch = patches_[own.patch];
  for (const int moved : patch.blocks)
    motion_[moved].column() += patch.inverse.template block<size, size>(rank_[moved] * size, rank_[own.block] * size) * change;
}

// Contacts that press, or would by going on as since they were last looked at: others keep to their place for the next few pairs.
template <int size>
void SweepsOf<size>::watch() {
  std::vector<int> active;
  active.reserve(contacts_.size());
  const bool first = gap_.size() != contacts_.size();
  gap_.resize(contacts_.size());
  for (size_t k = 0; k < contacts_.size(); ++k) {
    const Link& link = contacts_[k];
    const SweptRows<size>& rows = rows_[link.rows];
    const double gap = link.gap0 + factor_ * along(rows.ni, motion_[link.i], rows.nj, motion_[link.j]);
    if (first || forces_[k].n != 0 || forces_[k].t != 0 || link.law.cohesion > 0 || gap + ahead * (gap - gap_[k]) < 0 || gap < 0)
      active.push_back(int(k));
    gap_[k] = gap;
  }
  if (!first && active == active_) return;
  active_ = std::move(active);
  group();
}

// As they come: each into the first of the last few groups that has room for it and moves no block, nor a patch, that it moves.
template <int size>
void SweepsOf<size>::group() {
  constexpr size_t filled_at_once = 8;
  const int held = int(blocks_.size()), none = int(contacts_.size());
  groups_.clear();
  std::vector<size_t> filled;  // of each group
  size_t first = 0;
  for (const int k : active_) {
    const Link& link = contacts_[size_t(k)];
    const auto takes = [&](size_t g) {
      const SweptGroup<size>& group = groups_[g];
      const auto moves = [&](int block) {
        const auto same = [&](int other) { return patch_of_[size_t(other)] == patch_of_[size_t(block)]; };
        return block != held && (std::any_of(group.i.begin(), group.i.end(), same) || std::any_of(group.j.begin(), group.j.end(), same));
      };
      return filled[g] < 4 && !moves(link.i) && !moves(link.j);
    };
    size_t g = first;
    while (g < groups_.size() && !takes(g)) ++g;
    if (g == groups_.size()) {
      groups_.push_back(SweptGroup<size>::of_nothing(none, held, int(rows_.size()) - 1));
      filled.push_back(0);
      if (groups_.size() > first + filled_at_once) ++first;
    }
    groups_[g].put(filled[g]++, k, link);
  }
}

template <int size>
void SweepsOf<size>::sweep(bool backwards) {
  if (backwards)
    for (size_t t = tied_.size(); t-- > 0;) relax(t);
  settle_all(view(), groups_, backwards);
  if (!backwards)
    for (size_t t = 0; t < tied_.size(); ++t) relax(t);
}

template <int size>
struct SweepsOf<size>::Change {  // of a pair of sweeps, N²
  double change = 0, level = 0;
  double turned = 0;  // > 0: against the change since the pair before
};

template <int size>
typename SweepsOf<size>::Change SweepsOf<size>::change(const State& from, const State& last) const {
  Change sum;
  for (const int contact : active_) {
    const auto k = size_t(contact);
    const ContactForces now = forces_[k];
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
  for (size_t l = 0; l < motion_.size(); ++l) go(motion_[l], last.motion[l], momentum, momentum, motion_[l]);
  for (const int contact : active_) {
    const auto k = size_t(contact);
    const ContactForces now = forces_[k], before = last.forces[k];
    const ContactForces asked = {now.n + momentum * (now.n - before.n), now.t + momentum * (now.t - before.t)};
    const ContactForces carried = forces_[k] = contacts_[k].law.carried(asked);
    if (carried.n != asked.n || carried.t != asked.t) {
      const Link& link = contacts_[k];
      move(view(), link.i, link.j, link.rows, link.moved_begin, link.moved_end, carried.n - asked.n, carried.t - asked.t);
    }
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
    if (ContactForces& forces = forces_[size_t(k)]; forces.n > 0)  // what has opened stays open
      forces = contacts_[size_t(k)].law.carried({next[k], next[count + k]});
  rebuild();
}

template <int size>
void SweepsOf<size>::take(const std::vector<double>& normal, const std::vector<double>& shear, const Vector& d) {
  const auto& rows = problem_->contacts.rows();
  forces_.assign(contacts_.size() + 1, {});
  for (size_t k = 0; k < contacts_.size(); ++k) {
    Link& link = contacts_[k];
    link.gap0 = rows[link.contact].gap0;
    link.slide0 = rows[link.contact].slide0;
    forces_[k] = {normal[link.contact], shear[link.contact]};
  }
  bond_.assign(tied_.size(), Column::Zero());
  if (!tied_.empty()) {
    for (size_t l = 0; l < blocks_.size(); ++l) {
      Column motion = Column::Zero();
      motion.head(problem_->dofs[blocks_[l]]) = d.segment(problem_->dof_begin[blocks_[l]], problem_->dofs[blocks_[l]]);
      motion_[l] = Lanes<size>::of(Column(lower_[l].transpose() * motion));
    }
    for (size_t t = 0; t < tied_.size(); ++t)
      for (const Tie& tie : tied_[t].ties) bond_[t] -= tie.k * motion_[tie.other].column();
  }
  rebuild();
  gap_.clear();
}

template <int size>
Sweeping::Progress SweepsOf<size>::run(const End& end, Carry carry, std::vector<double>& normal, std::vector<double>& shear, Vector& d) {
  take(normal, shear, d);
  watch();
  state_.assign(contacts_.size(), 0);
  changed_states();
  State from, last{forces_, bond_, motion_};  // before the present pair; after the one before it
  Progress progress;
  Mixing mixing;
  double theta = 1, before = 0;
  double decade = 0;  // change ten pairs ago
  int since = 0;
  while (progress.pairs < end.most) {
    from.forces = forces_;
    from.bond = bond_;
    sweep(false);
    sweep(true);
    ++progress.pairs;
    const Change now = change(from, last);
    progress.change = now.level > 0 ? std::sqrt(now.change / now.level) : 0;
    progress.moved = std::sqrt(now.change);
    if (progress.pairs == end.most) break;
    const bool done = progress.change <= end.enough;
    if (done && active_.size() == contacts_.size()) break;
    if (done || progress.pairs % rebuilt_every == 0) {
      watch();
      if (done && none_closes()) break;
    }
    if (end.worth > 0 && progress.pairs % 10 == 0) {
      const bool on_the_way = decade == 0 || progress.change < decade * std::pow(end.enough / progress.change, 10.0 / end.worth);
      if (const int changed = changed_states(); !on_the_way && changed <= end.changing) break;
      decade = progress.change;
    }
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
  for (size_t l = 0; l < blocks_.size(); ++l) {
    const int dofs = problem_->dofs[blocks_[l]];
    const Column motion = to_own_[l].transpose() * motion_[l].column();
    d.segment(problem_->dof_begin[blocks_[l]], dofs) = motion.head(dofs);
  }
  return progress;
}

template <int size>
int SweepsOf<size>::changed_states() {
  int changed = 0;
  for (const int contact : active_) {
    const auto k = size_t(contact);
    const char state = contacts_[k].law.state(forces_[k]);
    changed += state != state_[k];
    state_[k] = state;
  }
  return changed;
}

// Of contacts without force, all of which were looked at just now.
template <int size>
bool SweepsOf<size>::none_closes() const {
  for (size_t k = 0; k < contacts_.size(); ++k)
    if (gap_[k] < 0 && forces_[k].n == 0) return false;
  return true;
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
