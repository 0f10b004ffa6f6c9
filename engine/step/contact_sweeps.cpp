#include "step/contact_sweeps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

// Pairs of sweeps after which a restart of the momentum by growth of the change is allowed: it takes a few to build up.
constexpr int least_run = 5;
// Pairs after which all contacts are looked at, not those alone that press or may soon, and motions are added up anew:
// carried on with the forces they gather rounding, which stiff rigid walls answer with more sweeps.
constexpr int rebuilt_every = 10;
// of these pairs, the last; in the others the contacts that still change, where these are few
constexpr int looked_at_all = 2;
constexpr double still_part = 0.1, most_changing = 0.6;  // of all change, in squares; of all contacts
constexpr double ahead = 2;  // times that way: contacts that would close in it may soon press

}  // namespace

template <int size>
void SweepsOf<size>::rebuild() {
  std::vector<Lanes<size>>& sum = motion_;
  sum = force_;
  for (size_t k = 0; k < contacts_.size(); ++k) {
    const auto [n, t] = forces_[k];
    if (n == 0 && t == 0) continue;
    const Link& link = contacts_[k];
    const SweptRows<size>& rows = rows_[link.rows];
    go(rows.ni, rows.si, n, t, sum[link.i]);
    go(rows.nj, rows.sj, n, t, sum[link.j]);
  }
  for (size_t t = 0; t < tied_.size(); ++t) sum[tied_[t].block].column() += to_own_[tied_[t].block] * bond_[t];
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
    motion_[moved].column() +=
        patch.inverse.template block<size, size>(rank_[moved] * size, rank_[own.block] * size) * change;
}

// Contacts that press, or would by going on as since they were last looked at: others keep to their place for the next
// few pairs.
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
    if (first || forces_[k].n != 0 || forces_[k].t != 0 || link.law.cohesion > 0 || gap + ahead * (gap - gap_[k]) < 0 ||
        gap < 0)
      active.push_back(int(k));
    gap_[k] = gap;
  }
  all_ = true;
  if (!first && active == active_.contacts) return;
  kept_whole_ = 0;
  active_.groups = grouped(active);
  active_.contacts = std::move(active);
}

// After a pair that looked at all and changed them by so much, N². After a step of Newton's one contact in ten makes
// all the change but for a tenth, in squares: those, and what is beside them, are swept alone for a while. What that
// changes the others by is seen when all are looked at again.
template <int size>
void SweepsOf<size>::look_at_changing(const State& from, double change) {
  if (!tied_.empty()) return;
  const double enough = still_part * change / double(active_.contacts.size());
  std::vector<char> changes(blocks_.size() + 1, 0);
  for (const int contact : active_.contacts) {
    const Link& link = contacts_[size_t(contact)];
    const ContactForces now = forces_[size_t(contact)], before = from.forces[size_t(contact)];
    const double dn = now.n - before.n, dt = now.t - before.t;
    if (dn * dn + dt * dt > enough) changes[size_t(link.i)] = changes[size_t(link.j)] = 1;
  }
  changes.back() = 0;  // what is held
  std::vector<int> some;
  for (const int contact : active_.contacts) {
    const Link& link = contacts_[size_t(contact)];
    if (changes[size_t(link.i)] || changes[size_t(link.j)]) some.push_back(contact);
  }
  if (double(some.size()) > most_changing * double(active_.contacts.size())) return;
  changing_.groups = grouped(some);
  changing_.blocks = moved_by(some);
  changing_.contacts = std::move(some);
  all_ = false;
  kept_whole_ = 0;
}

template <int size>
std::vector<int> SweepsOf<size>::moved_by(const std::vector<int>& contacts) const {
  std::vector<char> moved(blocks_.size() + 1, 0);
  for (const int contact : contacts) {
    const Link& link = contacts_[size_t(contact)];
    moved[size_t(link.i)] = moved[size_t(link.j)] = 1;
    for (int k = link.moved_begin; k < link.moved_end; ++k) moved[size_t(moved_block_[size_t(k)])] = 1;
  }
  std::vector<int> blocks;
  for (size_t l = 0; l < blocks_.size(); ++l)
    if (moved[l]) blocks.push_back(int(l));
  return blocks;
}

template <int size>
void SweepsOf<size>::keep_forces(State& to) const {
  to.bond = bond_;
  if (!keeps_swept()) {
    to.forces = forces_;
    return;
  }
  for (const int contact : swept().contacts) to.forces[size_t(contact)] = forces_[size_t(contact)];
}

template <int size>
void SweepsOf<size>::keep(State& to) const {
  keep_forces(to);
  if (!keeps_swept() || all_) {
    to.motion = motion_;
    return;
  }
  for (const int block : changing_.blocks) to.motion[size_t(block)] = motion_[size_t(block)];
}

// As they come: each into the first of the last few groups that has room for it and comes after all that move a block,
// or a patch, that it moves.
template <int size>
std::vector<SweptGroup<size>> SweepsOf<size>::grouped(const std::vector<int>& contacts) const {
  constexpr int filled_at_once = 8;
  const int held = int(blocks_.size()), none = int(contacts_.size());
  std::vector<SweptGroup<size>> groups;
  groups.reserve(contacts.size() / 3);
  std::vector<int> filled;                    // contacts of each group
  std::vector<int> next(patches_.size(), 0);  // of each patch, the first group that comes after all that move it
  for (const int k : contacts) {
    const Link& link = contacts_[size_t(k)];
    const int a = patch_of_[size_t(link.i)], b = patch_of_[size_t(link.j)];
    int g = std::max(0, int(groups.size()) - filled_at_once);
    for (const int patch : {a, b})
      if (patch >= 0) g = std::max(g, next[size_t(patch)]);
    while (g < int(groups.size()) && filled[size_t(g)] == 4) ++g;
    if (g == int(groups.size())) {
      groups.push_back(SweptGroup<size>::of_nothing(none, held, int(rows_.size()) - 1));
      filled.push_back(0);
    }
    for (const int patch : {a, b})
      if (patch >= 0) next[size_t(patch)] = g + 1;
    groups[size_t(g)].put(size_t(filled[size_t(g)]++), k, link);
  }
  return groups;
}

template <int size>
void SweepsOf<size>::sweep(bool backwards) {
  if (backwards)
    for (size_t t = tied_.size(); t-- > 0;) relax(t);
  settle_all(view(), swept().groups, backwards);
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
  for (const int contact : swept().contacts) {
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

// Forces go on along their change since `last`, motions along theirs, less what contacts cannot carry; `anew`: motions
// are added up from the forces.
template <int size>
void SweepsOf<size>::carry_on(const State& last, double momentum, bool anew) {
  for (size_t t = 0; t < bond_.size(); ++t) bond_[t] += momentum * (bond_[t] - last.bond[t]);
  const auto go_on = [&](size_t l) { go(motion_[l], last.motion[l], momentum, momentum, motion_[l]); };
  if (all_)
    for (size_t l = 0; l < motion_.size(); ++l) go_on(l);
  else
    for (const int block : changing_.blocks) go_on(size_t(block));
  for (const int contact : swept().contacts) {
    const auto k = size_t(contact);
    const ContactForces now = forces_[k], before = last.forces[k];
    const ContactForces asked = {now.n + momentum * (now.n - before.n), now.t + momentum * (now.t - before.t)};
    const ContactForces carried = forces_[k] = contacts_[k].law.carried(asked);
    if (carried.n != asked.n || carried.t != asked.t) {
      const Link& link = contacts_[k];
      move(view(), link.i, link.j, link.rows, link.moved_begin, link.moved_end, carried.n - asked.n,
           carried.t - asked.t);
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
Sweeping::Progress SweepsOf<size>::run(const End& end, Carry carry, std::vector<double>& normal,
                                       std::vector<double>& shear, Vector& d) {
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
    keep_forces(from);
    sweep(false);
    sweep(true);
    ++progress.pairs;
    const Change now = change(from, last);
    progress.change = now.level > 0 ? std::sqrt(now.change / now.level) : 0;
    progress.moved = std::sqrt(now.change);
    if (progress.pairs == end.most) break;
    const bool done = progress.change <= end.enough && all_, again = progress.pairs % rebuilt_every == 0;
    if (done && active_.contacts.size() == contacts_.size()) break;
    if (done || again) {
      watch();
      if (done && none_closes()) break;
    }
    const bool before_all = all_;
    if (again && carry == Carry::momentum) look_at_changing(from, now.change);
    if (progress.pairs % rebuilt_every == rebuilt_every - looked_at_all) all_ = true;
    if (end.worth > 0 && progress.pairs % 10 == 0) {
      const bool on_the_way =
          decade == 0 || progress.change < decade * std::pow(end.enough / progress.change, 10.0 / end.worth);
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
    before = all_ == before_all ? now.change : std::numeric_limits<double>::infinity();
    State& reached = from;
    keep(reached);
    ++kept_whole_;
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
  for (const int contact : swept().contacts) {
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

template Sweeping::Progress SweepsOf<first_order_dofs>::run(const End&, Carry, std::vector<double>&,
                                                            std::vector<double>&, Vector&);
template Sweeping::Progress SweepsOf<second_order_dofs>::run(const End&, Carry, std::vector<double>&,
                                                             std::vector<double>&, Vector&);

}  // namespace talus
