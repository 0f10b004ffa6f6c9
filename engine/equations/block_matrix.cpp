#include "equations/block_matrix.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace talus {

bool BlockMatrix::set_pattern(const std::vector<int>& sizes, std::vector<std::pair<int, int>> pairs) {
  std::vector<int> all(sizes.size());
  std::iota(all.begin(), all.end(), 0);
  return set_pattern(sizes, std::move(pairs), std::move(all));
}

bool BlockMatrix::set_pattern(const std::vector<int>& sizes, std::vector<std::pair<int, int>> pairs,
                              std::vector<int> with_entries) {
  for (auto& [a, b] : pairs)
    if (a < b) std::swap(a, b);
  std::erase_if(pairs,
                [&](const auto& p) { return p.first == p.second || sizes[p.first] == 0 || sizes[p.second] == 0; });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  if (sizes == sizes_ && pairs == pairs_ && with_entries == with_entries_) return false;
  sizes_ = sizes;
  with_entries_ = std::move(with_entries);
  pairs_ = std::move(pairs);

  const int blocks = int(sizes_.size());
  begin_.assign(blocks + 1, 0);
  for (int b = 0; b < blocks; ++b) begin_[b + 1] = begin_[b] + sizes_[b];
  pair_begin_.assign(blocks + 1, 0);
  for (const auto& [column, row] : pairs_) ++pair_begin_[column + 1];
  for (int b = 0; b < blocks; ++b) pair_begin_[b + 1] += pair_begin_[b];

  pair_offset_.resize(pairs_.size());
  above_.assign(blocks, -1);
  size_t count = 0;
  for (const int b : with_entries_) {
    above_[b] = 0;
    for (int p = pair_begin_[b]; p < pair_begin_[b + 1]; ++p) {
      pair_offset_[p] = above_[b];
      above_[b] += sizes_[pairs_[p].second];
    }
    count += size_t(sizes_[b]) * size_t(above_[b]) + size_t(sizes_[b]) * size_t(sizes_[b] + 1) / 2;
  }
  column_begin_.clear();
  column_begin_.reserve(size_t(begin_[blocks]) + 1);
  row_index_.resize(count);
  int* row = row_index_.data();
  for (const int b : with_entries_) {
    column_begin_.resize(size_t(begin_[b]), int(row - row_index_.data()));  // columns without entries
    for (int j = 0; j < sizes_[b]; ++j) {
      column_begin_.push_back(int(row - row_index_.data()));
      for (int p = pair_begin_[b]; p < pair_begin_[b + 1]; ++p)
        for (int i = 0; i < sizes_[pairs_[p].second]; ++i) *row++ = begin_[pairs_[p].second] + i;
      for (int i = 0; i <= j; ++i) *row++ = begin_[b] + i;
    }
  }
  column_begin_.resize(size_t(begin_[blocks]) + 1, int(count));
  values.assign(count, 0.0);
  return true;
}

bool BlockMatrix::take_part(const BlockMatrix& whole, const std::vector<int>& blocks, const std::vector<int>& place) {
  std::vector<int> sizes;
  std::vector<std::pair<int, int>> pairs;
  for (const int b : blocks) {
    sizes.push_back(whole.sizes_[b]);
    for (int p = whole.pair_begin_[b]; p < whole.pair_begin_[b + 1]; ++p)
      pairs.push_back({place[b], place[whole.pairs_[p].second]});
  }
  const bool changed = set_pattern(sizes, std::move(pairs));
  double* to = values.data();
  for (const int b : blocks) {  // a block's columns lie together, and in the same order
    const int first = whole.begin_[b];
    const double* const from = whole.values.data();
    to = std::copy(from + whole.column_begin_[first], from + whole.column_begin_[first + whole.sizes_[b]], to);
  }
  return changed;
}

BlockMatrix::Slot BlockMatrix::slot(int a, int b) const {
  if (a == b) return above_[a] < 0 ? Slot{} : Slot{a, a, above_[a]};
  const auto [row, column] = std::minmax(a, b);
  const auto first = pairs_.begin() + pair_begin_[column], last = pairs_.begin() + pair_begin_[column + 1];
  const auto found = std::lower_bound(first, last, std::pair<int, int>(column, row));
  if (found == last || found->second != row) return {};
  return {row, column, pair_offset_[found - pairs_.begin()]};
}

void BlockMatrix::add_outer(const Slot& slot, double factor, const double* u, const double* v) {
  assert(slot.row >= 0);
  const int rows = sizes_[slot.row], columns = sizes_[slot.column], first = begin_[slot.column];
  const bool diagonal = slot.row == slot.column;
  for (int j = 0; j < columns; ++j) {
    double* const to = &values[column_begin_[first + j] + slot.offset];
    const double scale = factor * v[j];
    const int count = diagonal ? j + 1 : rows;
    for (int i = 0; i < count; ++i) to[i] += scale * u[i];
  }
}

void BlockMatrix::multiply(const Vector& x, Vector& y) const {
  for (const int b : with_entries_)
    for (int j = begin_[b]; j < begin_[b + 1]; ++j) {
      const int diagonal = column_begin_[j + 1] - 1;
      const double xj = x[j];
      double sum = values[diagonal] * xj;
      for (int k = column_begin_[j]; k < diagonal; ++k) {
        const int i = row_index_[k];
        y[i] += values[k] * xj;
        sum += values[k] * x[i];
      }
      y[j] += sum;
    }
}

int BlockMatrix::block_of_unknown(int unknown) const {
  return int(std::upper_bound(begin_.begin(), begin_.end(), unknown) - begin_.begin()) - 1;
}

}  // namespace talus
