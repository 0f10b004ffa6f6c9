#include "equations/supernodal_solve.h"

#include "equations/simd.h"

namespace talus {

namespace {

constexpr int at_once = 8;  // numbers that are read at once

using Wide = Register<double>::Whole;

TALUS_WITHIN Wide& at(double* from) {
  return reinterpret_cast<Wide&>(*from);
}
TALUS_WITHIN const Wide& at(const double* from) {
  return reinterpret_cast<const Wide&>(*from);
}

// Columns of the factor: `height` values each, from the rows of its own columns on. Most have six columns and twenty to
// forty rows: what is beyond the last row is read and left with them, the beginning of the next column, and the rows of
// w go on with zeros. Where `to_the_end` no column follows.
template <bool to_the_end>
struct Supernode {
  int columns, height;
  const double *values, *inverse;  // and 1 / its diagonal

  TALUS_WITHIN const double* column(int j) const { return values + size_t(j) * size_t(height); }

  // L⁻¹ of what is in w, whose first `columns` come to `own` and whose others get what these take from them.
  TALUS_WITHIN void forward(double* w, double* own) const {
    int j = 0;
    for (; j + 4 <= columns; j += 4) forward_by<4>(j, w, own);
    for (; j + 2 <= columns; j += 2) forward_by<2>(j, w, own);
    if (j < columns) forward_by<1>(j, w, own);
  }
  // L⁻ᵀ of the first `columns` of w, whose others are known; to `own` too.
  TALUS_WITHIN void backward(double* w, double* own) const {
    int j = columns;
    if (j % 2 != 0) backward_by<1>(--j, w, own);
    if (j % 4 != 0) backward_by<2>(j -= 2, w, own);
    while (j > 0) backward_by<4>(j -= 4, w, own);
  }

 private:
  // So many columns for each time that w is read.
  template <int count>
  TALUS_WITHIN void forward_by(int j, double* w, double* own) const {
    const double* l[count];
    double x[count];
    for (int m = 0; m < count; ++m) {
      l[m] = column(j + m);
      double left = w[j + m];
      for (int k = 0; k < m; ++k) left -= l[k][j + m] * x[k];
      own[j + m] = x[m] = left * inverse[j + m];
    }
    int i = j + count;
    for (; to_the_end ? i + at_once <= height : i < height; i += at_once) {
      Wide below = at(w + i);
      for (int m = 0; m < count; ++m) below -= at(l[m] + i) * x[m];
      at(w + i) = below;
    }
    for (; to_the_end && i < height; ++i)
      for (int m = 0; m < count; ++m) w[i] -= l[m][i] * x[m];
  }
  template <int count>
  TALUS_WITHIN void backward_by(int j, double* w, double* own) const {
    const double* l[count];
    Wide parts[4] = {};
    for (int m = 0; m < count; ++m) l[m] = column(j + m);
    int i = j + count;
    for (; to_the_end ? i + at_once <= height : i < height; i += at_once)
      for (int m = 0; m < count; ++m) parts[m] += at(l[m] + i) * at(w + i);
    Register<double>::Half sums;
    sum_up<double>(parts, sums);
    for (; to_the_end && i < height; ++i)
      for (int m = 0; m < count; ++m) sums[m] += l[m][i] * w[i];
    for (int m = count; m-- > 0;) {
      double left = w[j + m] - sums[m];
      for (int k = m + 1; k < count; ++k) left -= l[m][j + k] * w[j + k];
      own[j + m] = w[j + m] = left * inverse[j + m];
    }
  }
};

// A supernode of the factor, with y and room for its rows and `at_once` more, as behind y.
template <bool last>
struct Place {
  Supernode<last> node;
  const int* rows;
  double *own, *part;

  TALUS_WITHIN Place(const SupernodalFactor& whole, size_t s, const double* inverse, double* y, double* room)
      : node{whole.first[s + 1] - whole.first[s], whole.row_begin[s + 1] - whole.row_begin[s],
             whole.values.data() + whole.value_begin[s], inverse + whole.first[s]},
        rows(whole.rows.data() + whole.row_begin[s]),
        own(y + whole.first[s]),
        part(room) {
    for (int k = 0; k < node.columns; k += at_once) at(part + k) = at(own + k);
  }
  TALUS_WITHIN void forward(double* y) const {
    for (int k = node.columns; k < node.height; k += at_once) at(part + k) = Wide{};
    node.forward(part, own);
    for (int k = node.columns; k < node.height; ++k) y[rows[k]] += part[k];
  }
  TALUS_WITHIN void backward(const double* y) const {
    for (int k = node.columns; k < node.height; ++k) part[k] = y[rows[k]];
    at(part + node.height) = Wide{};
    node.backward(part, own);
  }
};

// y becomes (L Lᵀ)⁻¹ y.
TALUS_WIDE void substitute(const SupernodalFactor& whole, const double* inverse, double* y, double* part) {
  const size_t last = whole.first.size() - 2;
  for (size_t s = 0; s < last; ++s) Place<false>(whole, s, inverse, y, part).forward(y);
  Place<true>(whole, last, inverse, y, part).forward(y);
  Place<true>(whole, last, inverse, y, part).backward(y);
  for (size_t s = last; s-- > 0;) Place<false>(whole, s, inverse, y, part).backward(y);
}

}  // namespace

void SupernodalSolve::take(const SupernodalFactor& factor) {
  whole_ = factor;
  inverse_.resize(factor.order.size());
  y_.resize(factor.order.size() + at_once);
  part_.resize(factor.order.size() + at_once);
  for (size_t s = 0; s + 1 < factor.first.size(); ++s) {
    const size_t height = size_t(factor.row_begin[s + 1] - factor.row_begin[s]), first = size_t(factor.first[s]);
    for (size_t k = first; k < size_t(factor.first[s + 1]); ++k)
      inverse_[k] = 1 / factor.values[size_t(factor.value_begin[s]) + (k - first) * (height + 1)];
  }
}

void SupernodalSolve::solve(const Vector& b, Vector& x) {
  const auto& order = whole_.order;
  x.resize(b.size());
  for (size_t k = 0; k < order.size(); ++k) y_[k] = b[order[k]];
  substitute(whole_, inverse_.data(), y_.data(), part_.data());
  for (size_t k = 0; k < order.size(); ++k) x[order[k]] = y_[k];
}

}  // namespace talus
