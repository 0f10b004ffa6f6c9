#include "step/contact_settling.h"

namespace talus {

namespace {

template <int size>
using FourColumns = std::array<const Lanes<size>*, 4>;

// a·x + b·y of four pairs of columns.
template <int size>
TALUS_WITHIN void four_along(const FourColumns<size>& a, const FourColumns<size>& x, const FourColumns<size>& b,
                             const FourColumns<size>& y, Four& sums) {
  Register<double>::Whole parts[4];
  for (size_t c = 0; c < 4; ++c) {
    parts[c] = eight(*a[c], 0) * eight(*x[c], 0) + eight(*b[c], 0) * eight(*y[c], 0);
    for (size_t k = 1; k < std::size(a[c]->v) / 8; ++k)
      parts[c] += eight(*a[c], k) * eight(*x[c], k) + eight(*b[c], k) * eight(*y[c], k);
  }
  sum_up<double>(parts, sums);
}

template <int size>
TALUS_WITHIN void settle(const SweepView<size>& view, const SweptGroup<size>& group) {
  FourColumns<size> ni, nj, si, sj, zi, zj;
  Four n, t, gap, slide;
  for (size_t c = 0; c < 4; ++c) {
    const SweptRows<size>& rows = view.rows[group.rows[c]];
    ni[c] = &rows.ni;
    nj[c] = &rows.nj;
    si[c] = &rows.si;
    sj[c] = &rows.sj;
    zi[c] = &view.motion[group.i[c]];
    zj[c] = &view.motion[group.j[c]];
    n[c] = view.forces[group.contact[c]].n;
    t[c] = view.forces[group.contact[c]].t;
  }
  four_along<size>(ni, zi, nj, zj, gap);
  four_along<size>(si, zi, sj, zj, slide);
  gap = group.gap0 + view.factor * gap - group.nn * n + group.ns * t;
  slide = group.slide0 + view.factor * slide - group.ns * n + group.ss * t;
  Four next_n, next_t;
  group.law.meet(gap, slide, next_n, next_t);
  const auto found = next_n == next_n;
  if (!(found[0] & found[1] & found[2] & found[3])) [[unlikely]]
    for (size_t c = 0; c < 4; ++c)
      if (!found[c] && group.contact[c] < view.count) {
        const ContactForces now = view.contacts[group.contact[c]].law.meet(gap[c], slide[c]);
        next_n[c] = now.n;
        next_t[c] = now.t;
      }
  const Four dn = next_n - n, dt = next_t - t;
  for (size_t c = 0; c < 4; ++c) {
    view.forces[group.contact[c]] = {next_n[c], next_t[c]};
    move(view, group.i[c], group.j[c], group.rows[c], group.moved_begin[c], group.moved_end[c], dn[c], dt[c]);
  }
}

template <int size>
TALUS_WITHIN void settle_in_turn(const SweepView<size>& view, const std::vector<SweptGroup<size>>& groups,
                                 bool backwards) {
  if (backwards)
    for (size_t k = groups.size(); k-- > 0;) settle(view, groups[k]);
  else
    for (const SweptGroup<size>& group : groups) settle(view, group);
}

}  // namespace

TALUS_WIDE void settle_all(const SweepView<first_order_dofs>& view,
                           const std::vector<SweptGroup<first_order_dofs>>& groups, bool backwards) {
  settle_in_turn(view, groups, backwards);
}
TALUS_WIDE void settle_all(const SweepView<second_order_dofs>& view,
                           const std::vector<SweptGroup<second_order_dofs>>& groups, bool backwards) {
  settle_in_turn(view, groups, backwards);
}

template <int size>
SweptGroup<size> SweptGroup<size>::of_nothing(int contact, int block, int rows) {
  SweptGroup group{};
  group.contact.fill(contact);
  for (auto* numbers : {&group.i, &group.j}) numbers->fill(block);
  group.rows.fill(rows);
  group.gap0 += 1;
  group.law = FourLaws::open();
  return group;
}

template <int size>
void SweptGroup<size>::put(size_t at, int number, const SweptContact<size>& own) {
  contact[at] = number;
  i[at] = own.i;
  j[at] = own.j;
  rows[at] = own.rows;
  moved_begin[at] = own.moved_begin;
  moved_end[at] = own.moved_end;
  gap0[at] = own.gap0;
  slide0[at] = own.slide0;
  nn[at] = own.nn;
  ns[at] = own.ns;
  ss[at] = own.ss;
  law.put(at, own.law);
}

template struct SweptGroup<first_order_dofs>;
template struct SweptGroup<second_order_dofs>;

}  // namespace talus
