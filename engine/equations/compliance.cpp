#include "equations/compliance.h"

#include <algorithm>
#include <utility>

namespace talus {

namespace {

// The first unknown below each supernode in the elimination tree, whose order is a postorder: what reaches a supernode
// begins between there and its last column.
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

Compliance::Compliance(const SupernodalFactor& factor)
    : factor_(factor), place_(factor.order.size()), below_(first_below(factor)) {
  for (size_t k = 0; k < place_.size(); ++k) place_[size_t(factor.order[k])] = int(k);
}

Eigen::Index Compliance::Part::until(int unknown) const {
  return std::lower_bound(begin.begin(), begin.end(), unknown) - begin.begin();
}

Compliance::Part Compliance::sort(const std::vector<SparseColumn>& columns) const {
  std::vector<std::pair<int, int>> order;
  for (size_t c = 0; c < columns.size(); ++c) {
    int begin = int(place_.size());
    for (const int unknown : columns[c].unknowns) begin = std::min(begin, place_[size_t(unknown)]);
    order.push_back({begin, int(c)});
  }
  std::sort(order.begin(), order.end());
  Part part;
  part.x.setZero(Eigen::Index(place_.size()), Eigen::Index(columns.size()));
  for (const auto& [begin, c] : order) {
    const SparseColumn& column = columns[size_t(c)];
    for (size_t k = 0; k < column.unknowns.size(); ++k)
      part.x(place_[size_t(column.unknowns[k])], Eigen::Index(part.begin.size())) += column.values[k];
    part.begin.push_back(begin);
    part.sorted.push_back(int(w_.rows()) + c);
  }
  return part;
}

void Compliance::add(const std::vector<SparseColumn>& columns) {
  Part& own = parts_.emplace_back(sort(columns));
  const Eigen::Index before = w_.rows(), count = before + Eigen::Index(columns.size());
  std::vector<Eigen::MatrixXd> shared;  // of each part with this one, in their orders
  for (const Part& part : parts_) shared.push_back(Eigen::MatrixXd::Zero(part.x.cols(), own.x.cols()));
  Eigen::MatrixXd taken;
  for (size_t s = 0; s + 1 < factor_.first.size(); ++s) {
    const int first = factor_.first[s], next = factor_.first[s + 1];
    const Eigen::Index low = own.until(below_[s]), some = own.until(next) - low;
    if (some == 0) continue;
    const Eigen::Index size = next - first, height = factor_.row_begin[s + 1] - factor_.row_begin[s];
    const Eigen::Map<const Eigen::MatrixXd> l(factor_.values.data() + factor_.value_begin[s], height, size);
    auto x = own.x.block(first, low, size, some);
    l.topRows(size).triangularView<Eigen::Lower>().solveInPlace(x);
    shared.back().block(low, low, some, some).selfadjointView<Eigen::Lower>().rankUpdate(x.transpose());
    for (size_t p = 0; p + 1 < parts_.size(); ++p) {
      const Eigen::Index from = parts_[p].until(below_[s]), others = parts_[p].until(next) - from;
      if (others > 0)
        shared[p].block(from, low, others, some).noalias() +=
            parts_[p].x.block(first, from, size, others).transpose() * x;
    }
    taken.noalias() = l.bottomRows(height - size) * x;
    const int* const rows = factor_.rows.data() + factor_.row_begin[s] + size;
    for (Eigen::Index c = 0; c < some; ++c)
      for (Eigen::Index k = 0; k < height - size; ++k) own.x(rows[k], low + c) -= taken(k, c);
  }
  shared.back() = Eigen::MatrixXd(shared.back().selfadjointView<Eigen::Lower>());
  w_.conservativeResize(count, count);
  for (size_t p = 0; p < parts_.size(); ++p) {
    w_(parts_[p].sorted, own.sorted) = shared[p];
    w_(own.sorted, parts_[p].sorted) = shared[p].transpose();
  }
}

}  // namespace talus
