#pragma once
// A symmetric sparse matrix of dense blocks of any size, kept as the upper triangle by scalar columns (which CHOLMOD
// reorders with one transposition, the lower one with two). The pattern comes from pairs of blocks; values are added
// through slots found once.
#include <Eigen/Core>
#include <cassert>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace talus {

using Vector = Eigen::VectorXd;

class BlockMatrix {
 public:
  // sizes: unknowns of each block (0 allowed). pairs: blocks that may couple, in any order, repeats allowed.
  // Returns whether the pattern changed; slots stay valid while it does not.
  bool set_pattern(const std::vector<int>& sizes, std::vector<std::pair<int, int>> pairs);
  // The same where only the blocks `with_entries` (rising) have any; the unknowns of all are numbered.
  bool set_pattern(const std::vector<int>& sizes, std::vector<std::pair<int, int>> pairs,
                   std::vector<int> with_entries);
  // Becomes the part of `whole` that `blocks` (rising) make up, which couple to no others. place: number of each of
  // them in the part. Returns whether the pattern changed.
  bool take_part(const BlockMatrix& whole, const std::vector<int>& blocks, const std::vector<int>& place);

  // Where the (row block, column block) submatrix lies; row < column, or equal for the diagonal. Negative: nowhere, as
  // of a block without entries or a pair that was not given.
  struct Slot {
    int row = -1, column = -1;
    int offset = 0;  // rows above the submatrix among the column's entries
  };
  Slot slot(int a, int b) const;

  // K(row, column) += m, where m(i, j) belongs to row unknown i and column unknown j (or transposed, when
  // the pair was given in the other order). Only the upper triangle of a diagonal block is read.
  template <typename Derived>
  void add(const Slot& slot, bool transposed, const Eigen::MatrixBase<Derived>& m) {
    if (transposed)
      add(slot, m.transpose().eval());
    else
      add(slot, m.derived());
  }
  // K(row, column) += factor * u vᵀ for contact rows.
  void add_outer(const Slot& slot, double factor, const double* u, const double* v);

  // The columns of a block: nought but for m on the diagonal, of which the upper triangle is read.
  template <typename Derived>
  void begin(int block, const Eigen::MatrixBase<Derived>& m) {
    const int size = sizes_[size_t(block)], above = above_[size_t(block)];
    // past the end for a block without unknowns
    double* to = values.data() + column_begin_[size_t(begin_[size_t(block)])];
    for (int j = 0; j < size; ++j) {
      to = std::fill_n(to, above, 0.0);
      for (int i = 0; i <= j; ++i) *to++ = m(i, j);
    }
  }
  // y += K x
  void multiply(const Vector& x, Vector& y) const;
  // The part of x·K y that the columns of a block with entries hold, and those rows that mirror them. own: the block's
  // x and y, as a pair of what can be indexed; others(block): those of one that it is coupled to.
  template <class Pair, class Others>
  double form(int block, const Pair& own, Others&& others) const;

  // The submatrix on the diagonal, both triangles; `m` has at least the block's size.
  template <typename Derived>
  void diagonal(int block, Eigen::MatrixBase<Derived>& m) const {
    const int size = sizes_[block], first = begin_[block];
    for (int j = 0; j < size; ++j)
      for (int i = 0; i <= j; ++i) m(i, j) = m(j, i) = values[column_begin_[first + j] + above_[block] + i];
  }

  // The submatrix of a pair, row < column; `m` has at least its size.
  template <typename Derived>
  void part(int row, int column, Eigen::MatrixBase<Derived>& m) const {
    const Slot at = slot(row, column);
    const int first = begin_[column];
    for (int j = 0; j < sizes_[column]; ++j)
      for (int i = 0; i < sizes_[row]; ++i) m(i, j) = values[column_begin_[first + j] + at.offset + i];
  }

  int dimension() const { return int(column_begin_.size()) - 1; }
  int block_count() const { return int(sizes_.size()); }
  int block_of_unknown(int unknown) const;
  const std::vector<int>& column_begin() const { return column_begin_; }
  const std::vector<int>& row_index() const { return row_index_; }
  const std::vector<int>& sizes() const { return sizes_; }
  const std::vector<int>& block_begin() const { return begin_; }
  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }  // (column, row), sorted, row < column

  std::vector<double> values;

 private:
  template <typename Derived>
  void add(const Slot& slot, const Derived& m) {
    assert(slot.row >= 0);
    const int rows = sizes_[slot.row], columns = sizes_[slot.column], first = begin_[slot.column];
    const bool diagonal = slot.row == slot.column;
    const int* const begin = &column_begin_[first];
    for (int j = 0; j < columns; ++j) {
      double* const to = &values[begin[j] + slot.offset];
      if (!diagonal && rows == m.rows()) {  // whole columns, mostly of a size that is known
        Eigen::Map<Eigen::Matrix<double, Derived::RowsAtCompileTime, 1>>(to, rows) += m.col(j);
        continue;
      }
      const int count = diagonal ? j + 1 : rows;
      for (int i = 0; i < count; ++i) to[i] += m(i, j);
    }
  }

  std::vector<int> sizes_, begin_;          // unknowns, first unknown
  std::vector<int> with_entries_;           // blocks
  std::vector<std::pair<int, int>> pairs_;  // sorted (column, row)
  std::vector<int> pair_begin_;             // first pair of a column block
  std::vector<int> pair_offset_, above_;    // rows above a pair's submatrix in the column; above a block's own
  std::vector<int> column_begin_, row_index_;
};

template <class Pair, class Others>
double BlockMatrix::form(int block, const Pair& own, Others&& others) const {
  const int size = sizes_[size_t(block)], above = above_[size_t(block)];
  const double* const first = values.data() + column_begin_[size_t(begin_[size_t(block)])];
  const auto column = [&](int j) { return first + j * above + j * (j + 1) / 2; };
  const auto& [x, y] = own;
  double sum = 0;
  const auto add = [&](const double* entries, int rows, const auto& beside, int j) {
    const auto& [beside_x, beside_y] = beside;
    double kx = 0, ky = 0;
    for (int i = 0; i < rows; ++i) {
      kx += entries[i] * beside_x[i];
      ky += entries[i] * beside_y[i];
    }
    sum += x[j] * ky + y[j] * kx;
  };
  for (int j = 0; j < size; ++j) {
    const double* const entries = column(j) + above;
    add(entries, j, own, j);
    sum += entries[j] * x[j] * y[j];
  }
  for (int p = pair_begin_[size_t(block)]; p < pair_begin_[size_t(block) + 1]; ++p) {
    const int row = pairs_[size_t(p)].second;
    const auto beside = others(row);
    for (int j = 0; j < size; ++j) add(column(j) + pair_offset_[size_t(p)], sizes_[size_t(row)], beside, j);
  }
  return sum;
}

}  // namespace talus
