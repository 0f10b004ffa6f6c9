#include "equations/supernodal_solve.h"

#include <algorithm>
#include <cmath>

#include "equations/simd.h"

namespace talus {

namespace {

// Columns of the factor: `height` values each, from the rows of its own columns on.
template <class Scalar>
struct Supernode {
  int columns, height;
  const Scalar *values, *inverse;  // and 1 / its diagonal

  TALUS_WITHIN const Scalar* column(int j) const { return values + size_t(j) * size_t(height); }

  // L⁻¹ of what is in w, whose first `columns` are solved and whose others get what these take from them.
  TALUS_WITHIN void forward(Scalar* w) const {
    int j = 0;
    for (; j + 4 <= columns; j += 4) {  // four columns for each time w is read and written
      const Scalar *a = column(j), *b = column(j + 1), *c = column(j + 2), *d = column(j + 3);
      const Scalar wa = w[j] * inverse[j];
      const Scalar wb = (w[j + 1] - a[j + 1] * wa) * inverse[j + 1];
      const Scalar wc = (w[j + 2] - a[j + 2] * wa - b[j + 2] * wb) * inverse[j + 2];
      const Scalar wd = (w[j + 3] - a[j + 3] * wa - b[j + 3] * wb - c[j + 3] * wc) * inverse[j + 3];
      w[j] = wa, w[j + 1] = wb, w[j + 2] = wc, w[j + 3] = wd;
#pragma omp simd
      for (int i = j + 4; i < height; ++i) w[i] -= a[i] * wa + b[i] * wb + c[i] * wc + d[i] * wd;
    }
    for (; j < columns; ++j) {
      const Scalar* const a = column(j);
      const Scalar wa = w[j] *= inverse[j];
#pragma omp simd
      for (int i = j + 1; i < height; ++i) w[i] -= a[i] * wa;
    }
  }

  // L⁻ᵀ of the first `columns` of w, whose others are known.
  TALUS_WITHIN void backward(Scalar* w) const {
    int j = columns;
    for (; j % 4 != 0; --j) {
      const Scalar* const a = column(j - 1);
      Scalar sum = 0;
#pragma omp simd reduction(+ : sum)
      for (int i = j; i < height; ++i) sum += a[i] * w[i];
      w[j - 1] = (w[j - 1] - sum) * inverse[j - 1];
    }
    for (j -= 4; j >= 0; j -= 4) {
      const Scalar *a = column(j), *b = column(j + 1), *c = column(j + 2), *d = column(j + 3);
      Scalar sa = 0, sb = 0, sc = 0, sd = 0;
#pragma omp simd reduction(+ : sa, sb, sc, sd)
      for (int i = j + 4; i < height; ++i) {
        sa += a[i] * w[i];
        sb += b[i] * w[i];
        sc += c[i] * w[i];
        sd += d[i] * w[i];
      }
      const Scalar wd = (w[j + 3] - sd) * inverse[j + 3];
      const Scalar wc = (w[j + 2] - sc - c[j + 3] * wd) * inverse[j + 2];
      const Scalar wb = (w[j + 1] - sb - b[j + 3] * wd - b[j + 2] * wc) * inverse[j + 1];
      w[j] = (w[j] - sa - a[j + 3] * wd - a[j + 2] * wc - a[j + 1] * wb) * inverse[j];
      w[j + 1] = wb, w[j + 2] = wc, w[j + 3] = wd;
    }
  }
};

// y becomes (L Lᵀ)⁻¹ y. `part`: room for the rows of a supernode.
template <class Scalar>
TALUS_WITHIN void substitute_in(const SupernodalFactor& whole, const Scalar* values, const Scalar* inverse, Scalar* y, Scalar* part) {
  const size_t count = whole.first.size() - 1;
  const auto supernode = [&](size_t s) {
    const int first = whole.first[s];
    return Supernode<Scalar>{whole.first[s + 1] - first, whole.row_begin[s + 1] - whole.row_begin[s], values + whole.value_begin[s], inverse + first};
  };
  for (size_t s = 0; s < count; ++s) {
    const Supernode<Scalar> node = supernode(s);
    Scalar* const own = y + whole.first[s];
    const int* const below = whole.rows.data() + whole.row_begin[s];
    std::copy_n(own, node.columns, part);
    std::fill(part + node.columns, part + node.height, Scalar(0));
    node.forward(part);
    std::copy_n(part, node.columns, own);
    for (int k = node.columns; k < node.height; ++k) y[below[k]] += part[k];
  }
  for (size_t s = count; s-- > 0;) {
    const Supernode<Scalar> node = supernode(s);
    Scalar* const own = y + whole.first[s];
    const int* const below = whole.rows.data() + whole.row_begin[s];
    std::copy_n(own, node.columns, part);
    for (int k = node.columns; k < node.height; ++k) part[k] = y[below[k]];
    node.backward(part);
    std::copy_n(part, node.columns, own);
  }
}

TALUS_WIDE void substitute(const SupernodalFactor& whole, const float* values, const float* inverse, float* y, float* part) {
  substitute_in(whole, values, inverse, y, part);
}
TALUS_WIDE void substitute(const SupernodalFactor& whole, const double* values, const double* inverse, double* y, double* part) {
  substitute_in(whole, values, inverse, y, part);
}

}  // namespace

template <class Scalar>
bool SupernodalSolve<Scalar>::take(const SupernodalFactor& factor) {
  constexpr double least = 1e-15, largest = 1e15;  // their products with unknowns near one stay in the range of single precision
  whole_ = factor;
  inverse_.resize(factor.order.size());
  y_.resize(factor.order.size());
  part_.resize(factor.order.size());
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
void SupernodalSolve<Scalar>::solve(const Vector& b, Vector& x) {
  const auto& order = whole_.order;
  x.resize(b.size());
  const double scale = copies ? b.lpNorm<Eigen::Infinity>() : 1;
  if (scale == 0) {
    x.setZero();
    return;
  }
  for (size_t k = 0; k < order.size(); ++k) y_[k] = Scalar(b[order[k]] / scale);
  if constexpr (copies)
    substitute(whole_, values_.data(), inverse_.data(), y_.data(), part_.data());
  else
    substitute(whole_, whole_.values.data(), inverse_.data(), y_.data(), part_.data());
  for (size_t k = 0; k < order.size(); ++k) x[order[k]] = scale * double(y_[k]);
}

template class SupernodalSolve<float>;
template class SupernodalSolve<double>;

}  // namespace talus
