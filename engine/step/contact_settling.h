#pragma once
// What a sweep does at each contact: it gets the forces that meet its law with all others held, and its blocks move by
// them. Blocks move in axes and units of their own (contact_sweeps.h); all numbers of a block or contact lie in whole
// registers and lines of the cache.
#include <array>
#include <iterator>
#include <vector>

#include "model/model.h"
#include "step/swept_law.h"

namespace talus {

template <int size>
struct alignas(64) Lanes {  // a column of a block's unknowns, filled up with zeros
  double v[(size + 7) / 8 * 8];

  static Lanes of(const ColumnOf<size>& column) {
    Lanes lanes{};
    std::copy_n(column.data(), size, lanes.v);
    return lanes;
  }
  Eigen::Map<ColumnOf<size>> column() { return Eigen::Map<ColumnOf<size>>(v); }
};

// Motion of a block under unit forces of a contact, in single precision, for half the memory to go through: it is for
// what a contact's force changes by, and motions are added up from the forces every few pairs.
template <int size>
struct alignas(64) SweptMotion {
  float n[(size + 7) / 8 * 8], s[(size + 7) / 8 * 8];
};

template <int size>
TALUS_WITHIN const Eight& eight(const Lanes<size>& lanes, size_t k) {
  return reinterpret_cast<const Eight&>(lanes.v[8 * k]);
}

// motion += dn n - dt s.
template <int size>
TALUS_WITHIN void go(const Lanes<size>& n, const Lanes<size>& s, double dn, double dt, Lanes<size>& motion) {
  for (size_t k = 0; k < std::size(motion.v) / 8; ++k)
    reinterpret_cast<Eight&>(motion.v[8 * k]) += dn * eight(n, k) - dt * eight(s, k);
}

template <int size>
TALUS_WITHIN void go(const SweptMotion<size>& moved, double dn, double dt, Lanes<size>& motion) {
  for (size_t k = 0; k < std::size(motion.v); k += 8) {
    const Eight n = __builtin_convertvector(reinterpret_cast<const EightFloats&>(moved.n[k]), Eight),
                s = __builtin_convertvector(reinterpret_cast<const EightFloats&>(moved.s[k]), Eight);
    reinterpret_cast<Eight&>(motion.v[k]) += dn * n - dt * s;
  }
}

// a·x + b·y.
template <int size>
TALUS_WITHIN double along(const Lanes<size>& a, const Lanes<size>& x, const Lanes<size>& b, const Lanes<size>& y) {
  Eight sum = eight(a, 0) * eight(x, 0) + eight(b, 0) * eight(y, 0);
  for (size_t k = 1; k < std::size(a.v) / 8; ++k) sum += eight(a, k) * eight(x, k) + eight(b, k) * eight(y, k);
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

template <int size>
// gap and slide under unit displacements of both blocks; where a block's matrix is 1, its motion under unit forces
struct SweptRows {
  Lanes<size> ni, nj, si, sj;
};

template <int size>
struct SweptContact {
  int i, j;             // blocks; the last one stands for all that is held
  int rows;             // into the rows
  double gap0, slide0;  // m
  SweptLaw law;
  double nn, ns, ss;  // m/N: gap and slide under unit forces, without the contact's own compliance
  // blocks that it moves, where they are bonded to others; else its own two go along its rows
  int moved_begin, moved_end;
  int contact;  // of the problem
};

// Four contacts that move no block in common, which are put right together: one after the other they would wait for
// each other's arithmetic. What a group is short of is filled up with contacts of nothing.
template <int size>
struct SweptGroup {
  std::array<int, 4> contact, i, j, rows, moved_begin, moved_end;
  Four gap0, slide0, nn, ns, ss;
  FourLaws law;

  static SweptGroup of_nothing(int contact, int block, int rows);
  void put(size_t at, int number, const SweptContact<size>& contact);
};

template <int size>
struct SweepView {  // all that a sweep over contacts reads and writes
  const SweptContact<size>* contacts;
  int count;
  const SweptRows<size>* rows;
  const SweptMotion<size>* moved;
  const int* moved_block;
  ContactForces* forces;  // one more than there are contacts
  Lanes<size>* motion;
  double factor;
};

// What a contact moves goes on, under so much more force: the blocks that are listed, or none are and its own two do.
template <int size>
TALUS_WITHIN void move(const SweepView<size>& view, int i, int j, int rows, int moved_begin, int moved_end, double dn,
                       double dt) {
  if (moved_begin == moved_end) {
    const SweptRows<size>& along = view.rows[rows];
    go(along.ni, along.si, dn, dt, view.motion[i]);
    go(along.nj, along.sj, dn, dt, view.motion[j]);
    return;
  }
  for (int k = moved_begin; k < moved_end; ++k) go(view.moved[k], dn, dt, view.motion[view.moved_block[k]]);
}

// One group after the other, forwards or backwards.
void settle_all(const SweepView<first_order_dofs>& view, const std::vector<SweptGroup<first_order_dofs>>& groups,
                bool backwards);
void settle_all(const SweepView<second_order_dofs>& view, const std::vector<SweptGroup<second_order_dofs>>& groups,
                bool backwards);

}  // namespace talus
