#include "equations/compliance.h"

#include <algorithm>
#include <numeric>

namespace talus {

namespace {

// The first unknown below each supernode in the elimination tree, whose order is a postorder: what reaches a supernode begins between
// there and its last column.
std::vector<int> first_below(const SupernodalFactor& factor) {
  const size_t count = factor.first.size() - 1;
  std::vector<int> below(factor.first.begin(), factor.first.end() - 1), of_column(factor.order.size());
  for (size_t s = 0; s < count; ++s)
    std::fill(of_column.begin() + factor.first[s], of_column.begin() + factor.first[s + 1], int(s));
  for (size_t s = 0; s < count; ++s) {
    const int own = factor.first[s + 1] - factor.first[s];
    if (factor.row_begin[s + 1] - factor.row_begin[s] == own) continue;  // a root
    int& parent = below[size_t(of_column[size_t(factor.rows[size_t(factor.row_begin[s] + own)])])];
    parent = std::min(parent, below[s]);
  }
  return below;
}

}  // namespace

Eigen::MatrixXd compliance(const SupernodalFactor& factor, const std::vector<SparseColumn>& columns) {
  const size_t unknowns = factor.order.size(), count = columns.size();
  std::vector<int> place(unknowns);
  for (size_t k = 0; k < unknowns; ++k) place[size_t(factor.order[k])] = int(k);
  std::vector<int> begin(count, int(unknowns)), sorted(count);
  for (size_t c = 0; c < count; ++c)
    for (const int unknown : columns[c].unknowns) begin[c] = std::min(begin[c], place[size_t(unknown)]);
  std::iota(sorted.begin(), sorted.end(), 0);
  std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return begin[size_t(a)] < begin[size_t(b)]; });

  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(Eigen::Index(unknowns), Eigen::Index(count));
  for (size_t c = 0; c < count; ++c) {
    const SparseColumn& column = columns[size_t(sorted[c])];
    for (size_t k = 0; k < column.unknowns.size(); ++k)
      x(place[size_t(column.unknowns[k])], Eigen::Index(c)) += column.values[k];
  }
  Eigen::MatrixXd in_order = Eigen::MatrixXd::Zero(Eigen::Index(count), Eigen::Index(count)), taken;
  const std::vector<int> below = first_below(factor);
  const auto until = [&](int unknown) {  // columns that begin before it
    return std::partition_point(sorted.begin(), sorted.end(), [&](int c) { return begin[size_t(c)] < unknown; }) - sorted.begin();
  };
  for (size_t s = 0; s + 1 < factor.first.size(); ++s) {
    const Eigen::Index low = until(below[s]), some = until(factor.first[s + 1]) - low;
    if (some == 0) continue;
    const Eigen::Index own = factor.first[s + 1] - factor.first[s], height = factor.row_begin[s + 1] - factor.row_begin[s];
    const Eigen::Map<const Eigen::MatrixXd> l(factor.values.data() + factor.value_begin[s], height, own);
    auto part = x.block(factor.first[s], low, own, some);
    l.topRows(own).triangularView<Eigen::Lower>().solveInPlace(part);
    in_order.block(low, low, some, some).selfadjointView<Eigen::Lower>().rankUpdate(part.transpose());
    taken.noalias() = l.bottomRows(height - own) * part;
    const int* const rows = factor.rows.data() + factor.row_begin[s] + own;
    for (Eigen::Index c = 0; c < some; ++c)
      for (Eigen::Index k = 0; k < height - own; ++k) x(rows[k], low + c) -= taken(k, c);
  }
  Eigen::MatrixXd w(count, count);
  for (size_t a = 0; a < count; ++a)
    for (size_t b = 0; b <= a; ++b)
      w(sorted[a], sorted[b]) = w(sorted[b], sorted[a]) = in_order(Eigen::Index(a), Eigen::Index(b));
  return w;
}

}  // namespace talus
