#include "equations/supernodal_solve.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "equations/simd.h"

namespace talus {

namespace {

constexpr int wide = 8;  // numbers that are read at once

template <class Scalar>
struct Register;
template <>
struct Register<float> {
  using Whole = float __attribute__((vector_size(32), aligned(4), may_alias));
  using Half = float __attribute__((vector_size(16)));
};
template <>
struct Register<double> {
  using Whole = double __attribute__((vector_size(64), aligned(8), may_alias));
  using Half = double __attribute__((vector_size(32)));
};
template <class Scalar>
using Wide = Register<Scalar>::Whole;

template <class Scalar>
TALUS_WITHIN Wide<Scalar>& at(Scalar* from) {
  return reinterpret_cast<Wide<Scalar>&>(*from);
}
template <class Scalar>
TALUS_WITHIN const Wide<Scalar>& at(const Scalar* from) {
  return reinterpret_cast<const Wide<Scalar>&>(*from);
}

// The sum of each of the four.
template <class Scalar>
TALUS_WITHIN void sum_up(const Wide<Scalar> (&parts)[4], Scalar (&sums)[4]) {
  using Half = Register<Scalar>::Half;
  Half half[4];
  for (int m = 0; m < 4; ++m)
    half[m] = __builtin_shufflevector(parts[m], parts[m], 0, 1, 2, 3) +
              __builtin_shufflevector(parts[m], parts[m], 4, 5, 6, 7);
  const Half first =
      __builtin_shufflevector(half[0], half[1], 0, 4, 2, 6) + __builtin_shufflevector(half[0], half[1], 1, 5, 3, 7);
  const Half second =
      __builtin_shufflevector(half[2], half[3], 0, 4, 2, 6) + __builtin_shufflevector(half[2], half[3], 1, 5, 3, 7);
  const Half all =
      __builtin_shufflevector(first, second, 0, 1, 4, 5) + __builtin_shufflevector(first, second, 2, 3, 6, 7);
  for (int m = 0; m < 4; ++m) sums[m] = all[m];
}

// Columns of the factor: `height` values each, from the rows of its own columns on. Most have six columns and twenty to
// forty rows: what is beyond the last row is read and left with them, the beginning of the next column, and the rows of
// w go on with zeros. Where `to_the_end` no column follows.
template <class Scalar, bool to_the_end>
struct Supernode {
  int columns, height;
  const Scalar *values, *inverse;  // and 1 / its diagonal

  TALUS_WITHIN const Scalar* column(int j) const { return values + size_t(j) * size_t(height); }

  // L⁻¹ of what is in w, whose first `columns` come to `own` and whose others get what these take from them.
  TALUS_WITHIN void forward(Scalar* w, Scalar* own) const {
    int j = 0;
    for (; j + 4 <= columns; j += 4) forward_by<4>(j, w, own);
    for (; j + 2 <= columns; j += 2) forward_by<2>(j, w, own);
    if (j < columns) forward_by<1>(j, w, own);
  }
  // L⁻ᵀ of the first `columns` of w, whose others are known; to `own` too.
  TALUS_WITHIN void backward(Scalar* w, Scalar* own) const {
    int j = columns;
    if (j % 2 != 0) backward_by<1>(--j, w, own);
    if (j % 4 != 0) backward_by<2>(j -= 2, w, own);
    while (j > 0) backward_by<4>(j -= 4, w, own);
  }

 private:
  // So many columns for each time that w is read.
  template <int count>
  TALUS_WITHIN void forward_by(int j, Scalar* w, Scalar* own) const {
    const Scalar* l[count];
    Scalar x[count];
    for (int m = 0; m < count; ++m) {
      l[m] = column(j + m);
      Scalar left = w[j + m];
      for (int k = 0; k < m; ++k) left -= l[k][j + m] * x[k];
      own[j + m] = x[m] = left * inverse[j + m];
    }
    int i = j + count;
    for (; to_the_end ? i + wide <= height : i < height; i += wide) {
      Wide<Scalar> below = at(w + i);
      for (int m = 0; m < count; ++m) below -= at(l[m] + i) * x[m];
      at(w + i) = below;
    }
    for (; to_the_end && i < height; ++i)
      for (int m = 0; m < count; ++m) w[i] -= l[m][i] * x[m];
  }
  template <int count>
  TALUS_WITHIN void backward_by(int j, Scalar* w, Scalar* own) const {
    const Scalar* l[count];
    Wide<Scalar> parts[4] = {};
    for (int m = 0; m < count; ++m) l[m] = column(j + m);
    int i = j + count;
    for (; to_the_end ? i + wide <= height : i < height; i += wide)
      for (int m = 0; m < count; ++m) parts[m] += at(l[m] + i) * at(w + i);
    Scalar sums[4];
    sum_up<Scalar>(parts, sums);
    for (; to_the_end && i < height; ++i)
      for (int m = 0; m < count; ++m) sums[m] += l[m][i] * w[i];
    for (int m = count; m-- > 0;) {
      Scalar left = w[j + m] - sums[m];
      for (int k = m + 1; k < count; ++k) left -= l[m][j + k] * w[j + k];
      own[j + m] = w[j + m] = left * inverse[j + m];
    }
  }
};

// A supernode of the factor, with y and room for its rows and `wide` more, as behind y.
template <class Scalar, bool last>
struct Place {
  Supernode<Scalar, last> node;
  const int* rows;
  Scalar *own, *part;

  TALUS_WITHIN Place(const SupernodalFactor& whole, size_t s, const Scalar* values, const Scalar* inverse, Scalar* y,
                     Scalar* room)
      : node{whole.first[s + 1] - whole.first[s], whole.row_begin[s + 1] - whole.row_begin[s],
             values + whole.value_begin[s], inverse + whole.first[s]},
        rows(whole.rows.data() + whole.row_begin[s]),
        own(y + whole.first[s]),
        part(room) {
    for (int k = 0; k < node.columns; k += wide) at(part + k) = at(own + k);
  }
  TALUS_WITHIN void forward(Scalar* y) const {
    for (int k = node.columns; k < node.height; k += wide) at(part + k) = Wide<Scalar>{};
    node.forward(part, own);
    for (int k = node.columns; k < node.height; ++k) y[rows[k]] += part[k];
  }
  TALUS_WITHIN void backward(const Scalar* y) const {
    for (int k = node.columns; k < node.height; ++k) part[k] = y[rows[k]];
    at(part + node.height) = Wide<Scalar>{};
    node.backward(part, own);
  }
};

// y becomes (L Lᵀ)⁻¹ y, by supernodes of which each leads to others among them.
template <class Scalar>
TALUS_WITHIN void substitute_in(const SupernodalFactor& whole, std::span<const int> supernodes, const Scalar* values,
                                const Scalar* inverse, Scalar* y, Scalar* part) {
  const bool with_last = size_t(supernodes.back()) == whole.first.size() - 2;
  const size_t last = whole.first.size() - 2, others = supernodes.size() - with_last;
  for (size_t k = 0; k < others; ++k)
    Place<Scalar, false>(whole, size_t(supernodes[k]), values, inverse, y, part).forward(y);
  if (with_last) {
    Place<Scalar, true>(whole, last, values, inverse, y, part).forward(y);
    Place<Scalar, true>(whole, last, values, inverse, y, part).backward(y);
  }
  for (size_t k = others; k-- > 0;)
    Place<Scalar, false>(whole, size_t(supernodes[k]), values, inverse, y, part).backward(y);
}

TALUS_WIDE void substitute(const SupernodalFactor& whole, std::span<const int> supernodes, const float* values,
                           const float* inverse, float* y, float* part) {
  substitute_in(whole, supernodes, values, inverse, y, part);
}
TALUS_WIDE void substitute(const SupernodalFactor& whole, std::span<const int> supernodes, const double* values,
                           const double* inverse, double* y, double* part) {
  substitute_in(whole, supernodes, values, inverse, y, part);
}

}  // namespace

FactorPart part_of(const SupernodalFactor& factor, std::span<const int> unknowns) {
  const size_t count = factor.first.size() - 1;
  // of unknowns; of places in the factor's order
  std::vector<char> wanted(factor.order.size(), 0), reached(factor.order.size(), 0);
  for (const int unknown : unknowns) wanted[size_t(unknown)] = 1;
  FactorPart part;
  for (size_t s = 0; s < count; ++s) {
    const int first = factor.first[s], end = factor.first[s + 1], row = factor.row_begin[s] + end - first;
    bool any = false;
    for (int k = first; k < end; ++k) any = any || reached[size_t(k)] || wanted[size_t(factor.order[size_t(k)])];
    if (!any) continue;
    part.supernodes.push_back(int(s));
    for (int k = first; k < end; ++k) part.unknowns.push_back(k);
    // its parent in the elimination tree
    if (row < factor.row_begin[s + 1]) reached[size_t(factor.rows[size_t(row)])] = 1;
  }
  return part;
}

template <class Scalar>
bool SupernodalSolve<Scalar>::take(const SupernodalFactor& factor) {
  // their products with unknowns near one stay in the range of single precision
  constexpr double least = 1e-15, largest = 1e15;
  whole_ = factor;
  all_.supernodes.resize(factor.first.size() - 1);
  all_.unknowns.resize(factor.order.size());
  for (auto* list : {&all_.supernodes, &all_.unknowns}) std::iota(list->begin(), list->end(), 0);
  inverse_.resize(factor.order.size());
  y_.resize(factor.order.size() + wide);
  part_.resize(factor.order.size() + wide);
  if constexpr (copies) {
    values_.resize(factor.values.size());
    for (size_t k = 0; k < values_.size(); ++k) {
      if (!(std::abs(factor.values[k]) < largest)) return false;
      values_[k] = Scalar(factor.values[k]);
    }
  }
  for (size_t s = 0; s + 1 < factor.first.size(); ++s) {
    const size_t height = size_t(factor.row_begin[s + 1] - factor.row_begin[s]);
    for (int k = factor.first[s]; k < factor.first[s + 1]; ++k) {
      const double diagonal = factor.values[size_t(factor.value_begin[s]) + size_t(k - factor.first[s]) * (height + 1)];
      if (copies && diagonal < least) return false;
      inverse_[size_t(k)] = Scalar(1 / diagonal);
    }
  }
  return true;
}

template <class Scalar>
void SupernodalSolve<Scalar>::solve(const Vector& b, Vector& x, const FactorPart& part) {
  const auto& order = whole_.order;
  x.resize(b.size());
  double scale = 0;
  if (copies)
    for (const int k : part.unknowns) scale = std::max(scale, std::abs(b[order[size_t(k)]]));
  if (scale == 0) scale = 1;
  for (const int k : part.unknowns) y_[size_t(k)] = Scalar(b[order[size_t(k)]] / scale);
  if (!part.supernodes.empty()) substitute(whole_, part.supernodes, values(), inverse_.data(), y_.data(), part_.data());
  for (const int k : part.unknowns) x[order[size_t(k)]] = scale * double(y_[size_t(k)]);
}

template class SupernodalSolve<float>;
template class SupernodalSolve<double>;

}  // namespace talus
