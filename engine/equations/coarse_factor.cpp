#include "equations/coarse_factor.h"

#include <algorithm>
#include <cmath>

namespace talus {

// Columns of the factor: `height` values each, from the rows of its own columns on.
struct CoarseFactor::Supernode {
  int first, columns, height;
  const int* below;  // rows that are not its own columns
  const float* values;

  const float* column(int j) const { return values + size_t(j) * size_t(height); }

  // L⁻¹ of what is in w, whose first `columns` are solved and whose others get what these take from them.
  void forward(float* w) const {
    int j = 0;
    for (; j + 4 <= columns; j += 4) {  // four columns for each time w is read and written
      const float *a = column(j), *b = column(j + 1), *c = column(j + 2), *d = column(j + 3);
      const float wa = w[j] * a[j];
      const float wb = (w[j + 1] - a[j + 1] * wa) * b[j + 1];
      const float wc = (w[j + 2] - a[j + 2] * wa - b[j + 2] * wb) * c[j + 2];
      const float wd = (w[j + 3] - a[j + 3] * wa - b[j + 3] * wb - c[j + 3] * wc) * d[j + 3];
      w[j] = wa, w[j + 1] = wb, w[j + 2] = wc, w[j + 3] = wd;
#pragma omp simd
      for (int i = j + 4; i < height; ++i) w[i] -= a[i] * wa + b[i] * wb + c[i] * wc + d[i] * wd;
    }
    for (; j < columns; ++j) {
      const float* const a = column(j);
      const float wa = w[j] *= a[j];
#pragma omp simd
      for (int i = j + 1; i < height; ++i) w[i] -= a[i] * wa;
    }
  }

  // L⁻ᵀ of the first `columns` of w, whose others are known.
  void backward(float* w) const {
    int j = columns;
    for (; j % 4 != 0; --j) {
      const float* const a = column(j - 1);
      float sum = 0;
#pragma omp simd reduction(+ : sum)
      for (int i = j; i < height; ++i) sum += a[i] * w[i];
      w[j - 1] = (w[j - 1] - sum) * a[j - 1];
    }
    for (j -= 4; j >= 0; j -= 4) {
      const float *a = column(j), *b = column(j + 1), *c = column(j + 2), *d = column(j + 3);
      float sa = 0, sb = 0, sc = 0, sd = 0;
#pragma omp simd reduction(+ : sa, sb, sc, sd)
      for (int i = j + 4; i < height; ++i) {
        sa += a[i] * w[i];
        sb += b[i] * w[i];
        sc += c[i] * w[i];
        sd += d[i] * w[i];
      }
      const float wd = (w[j + 3] - sd) * d[j + 3];
      const float wc = (w[j + 2] - sc - c[j + 3] * wd) * c[j + 2];
      const float wb = (w[j + 1] - sb - b[j + 3] * wd - b[j + 2] * wc) * b[j + 1];
      w[j] = (w[j] - sa - a[j + 3] * wd - a[j + 2] * wc - a[j + 1] * wb) * a[j];
      w[j + 1] = wb, w[j + 2] = wc, w[j + 3] = wd;
    }
  }
};

CoarseFactor::Supernode CoarseFactor::supernode(size_t s) const {
  const int first = whole_.first[s], columns = whole_.first[s + 1] - first, rows = whole_.row_begin[s];
  return {first, columns, whole_.row_begin[s + 1] - rows, whole_.rows.data() + rows + columns, values_.data() + whole_.value_begin[s]};
}

bool CoarseFactor::take(const SupernodalFactor& factor) {
  constexpr double least = 1e-15, largest = 1e15;  // their products with unknowns near one stay in range
  whole_ = factor;
  values_.resize(factor.values.size());
  y_.resize(factor.order.size());
  part_.resize(factor.order.size());
  for (size_t k = 0; k < values_.size(); ++k) {
    if (!(std::abs(factor.values[k]) < largest)) return false;
    values_[k] = float(factor.values[k]);
  }
  for (size_t s = 0; s + 1 < factor.first.size(); ++s) {
    const Supernode node = supernode(s);
    for (int k = 0; k < node.columns; ++k) {
      float& diagonal = values_[size_t(node.column(k) - values_.data()) + size_t(k)];
      if (diagonal < least) return false;
      diagonal = 1 / diagonal;
    }
  }
  return true;
}

void CoarseFactor::solve(const Vector& b, Vector& x) {
  const auto& order = whole_.order;
  const size_t count = whole_.first.size() - 1;
  x.setZero(b.size());
  const double scale = b.lpNorm<Eigen::Infinity>();
  if (scale == 0) return;
  for (size_t k = 0; k < order.size(); ++k) y_[k] = float(b[order[k]] / scale);
  float* const w = part_.data();
  for (size_t s = 0; s < count; ++s) {
    const Supernode node = supernode(s);
    float* const own = y_.data() + node.first;
    const int others = node.height - node.columns;
    std::copy_n(own, node.columns, w);
    std::fill_n(w + node.columns, others, 0.0F);
    node.forward(w);
    std::copy_n(w, node.columns, own);
    for (int k = 0; k < others; ++k) y_[node.below[k]] += w[node.columns + k];
  }
  for (size_t s = count; s-- > 0;) {
    const Supernode node = supernode(s);
    float* const own = y_.data() + node.first;
    const int others = node.height - node.columns;
    std::copy_n(own, node.columns, w);
    for (int k = 0; k < others; ++k) w[node.columns + k] = y_[node.below[k]];
    node.backward(w);
    std::copy_n(w, node.columns, own);
  }
  for (size_t k = 0; k < order.size(); ++k) x[order[k]] = scale * double(y_[k]);
}

}  // namespace talus
