#include "equations/coarse_solve.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "equations/simd.h"

namespace talus {

namespace {

constexpr int wide = CoarseSolve::wide;

using Chunk = Register<float>::Whole;
using EightLongs = long __attribute__((vector_size(64)));

TALUS_WITHIN Chunk& at(float* from) {
  return reinterpret_cast<Chunk&>(*from);
}
TALUS_WITHIN const Chunk& at(const float* from) {
  return reinterpret_cast<const Chunk&>(*from);
}

// N⁻¹ of a panel.
template <int columns>
TALUS_WITHIN void forward(int own, std::span<const int> chunks, const float* below, float* y) {
  float x[columns];
  for (int m = 0; m < columns; ++m) x[m] = y[own + m];
  for (const int chunk : chunks) {
    Chunk taken = at(below) * x[0];
    for (int m = 1; m < columns; ++m) taken += at(below + wide * m) * x[m];
    at(y + chunk) -= taken;
    below += wide * columns;
  }
}

// D⁻¹ and N⁻ᵀ.
template <int columns>
TALUS_WITHIN void backward(int own, std::span<const int> chunks, const float* below, const float* square, float* y) {
  Chunk parts[wide] = {};
  for (const int chunk : chunks) {
    for (int m = 0; m < columns; ++m) parts[m] += at(below + wide * m) * at(y + chunk);
    below += wide * columns;
  }
  Register<float>::Half sums[2];
  sum_up<float>(parts, sums[0]);
  sum_up<float>(parts + 4, sums[1]);
  Chunk x = at(square) * y[own];
  for (int m = 1; m < columns; ++m) x += at(square + wide * m) * y[own + m];
  x -= __builtin_shufflevector(sums[0], sums[1], 0, 1, 2, 3, 4, 5, 6, 7);
  for (int m = 0; m < columns; ++m) y[own + m] = x[m];
}

// way.of<columns>(), of which there are few.
template <class Way>
TALUS_WITHIN auto with_columns(int columns, const Way& way) {
  switch (columns) {
    case 1:
      return way.template of<1>();
    case 2:
      return way.template of<2>();
    case 3:
      return way.template of<3>();
    case 4:
      return way.template of<4>();
    case 5:
      return way.template of<5>();
    case 6:
      return way.template of<6>();
    case 7:
      return way.template of<7>();
    default:
      return way.template of<wide>();
  }
}

struct View {
  const CoarseSolve::Panel* panels;
  const int *panel_begin, *chunks;
  const float *below, *squares;
};

template <bool back>
struct Pass {
  const View& view;
  const CoarseSolve::Panel& panel;
  float* y;

  template <int columns>
  TALUS_WITHIN void of() const {
    const std::span<const int> chunks(view.chunks + panel.chunk_begin, view.chunks + panel.chunk_end);
    if constexpr (back)
      backward<columns>(panel.first, chunks, view.below + panel.below, view.squares + panel.square, y);
    else
      forward<columns>(panel.first, chunks, view.below + panel.below, y);
  }
};

template <bool back>
TALUS_WITHIN void pass(const View& view, int p, float* y) {
  const CoarseSolve::Panel& panel = view.panels[p];
  with_columns(panel.columns, Pass<back>{view, panel, y});
}

// y becomes (N D Nᵀ)⁻¹ y, by supernodes of which each leads to others among them.
TALUS_WIDE void substitute(const View& view, std::span<const int> supernodes, float* y) {
  for (const int s : supernodes)
    for (int p = view.panel_begin[s]; p < view.panel_begin[s + 1]; ++p) pass<false>(view, p, y);
  for (size_t k = supernodes.size(); k-- > 0;)
    for (int p = view.panel_begin[supernodes[k] + 1]; p-- > view.panel_begin[supernodes[k]];) pass<true>(view, p, y);
}

// What a panel is made of: its columns of L, `height` long, of which its square begins at `begin`.
struct Source {
  const double* column[wide];
  const int* rows;
  int begin, height;
  bool last;  // nothing follows these columns in memory
};

// Whether it is in range.
template <int n>
TALUS_WITHIN bool invert_square(const Source& from, double (&inverse)[wide][wide], float* square) {
  // products with unknowns near one stay in the range of single precision
  constexpr double least = 1e-30, largest = 1e30;
  for (int k = 0; k < n; ++k) {
    inverse[k][k] = 1 / from.column[k][from.begin + k];
    for (int m = 0; m < k; ++m) {
      double sum = 0;
      for (int l = m; l < k; ++l) sum += from.column[l][from.begin + k] * inverse[l][m];
      inverse[k][m] = -sum * inverse[k][k];
    }
  }
  bool within = true;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < wide; ++b) {
      double sum = 0;
      for (int k = a; k < n; ++k) sum += inverse[k][a] * inverse[k][b];
      within = within && std::abs(sum) < largest && (a != b || sum > least);
      square[wide * a + b] = float(sum);
    }
  return within;
}

// Rows k up to `end` of the panel's columns as a chunk.
template <int n>
TALUS_WITHIN void read(const Source& from, int k, int end, int chunk, Eight* values) {
  const int count = end - k;
  if (from.rows[end - 1] - chunk < count && !from.last) {  // without a gap
    const EightLongs lanes = {0, 1, 2, 3, 4, 5, 6, 7};
    for (int m = 0; m < n; ++m) {
      std::memcpy(&values[m], from.column[m] + k, sizeof(Eight));
      values[m] = lanes < count ? values[m] : Eight{};
    }
    return;
  }
  for (int m = 0; m < n; ++m) {
    values[m] = Eight{};
    for (int row = k; row < end; ++row) values[m][from.rows[row] - chunk] = from.column[m][row];
  }
}

struct Filling {
  const Source& from;
  std::span<const int> chunks;
  float *below, *square;

  template <int n>
  TALUS_WITHIN bool of() const {
    double inverse[wide][wide] = {};  // of the square of L, [row][column]
    if (!invert_square<n>(from, inverse, square)) return false;
    int k = from.begin + n;
    float* to = below;
    for (const int chunk : chunks) {
      const int begin = k;
      while (k < from.height && from.rows[k] < chunk + wide) ++k;
      Eight values[n];
      read<n>(from, begin, k, chunk, values);
      for (int m = 0; m < n; ++m, to += wide) {
        Eight sum = values[m] * inverse[m][m];
        for (int l = m + 1; l < n; ++l) sum += values[l] * inverse[l][m];
        at(to) = __builtin_convertvector(sum, Chunk);
      }
    }
    return true;
  }
};

TALUS_WIDE bool fill_panel(int columns, const Filling& filling) {
  return with_columns(columns, filling);
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
    for (int k = first; k < end; ++k) {
      const bool asked = wanted[size_t(factor.order[size_t(k)])];
      if (asked) part.unknowns.push_back(k);
      any = any || asked || reached[size_t(k)];
    }
    if (!any) continue;
    part.supernodes.push_back(int(s));
    // its parent in the elimination tree
    if (row < factor.row_begin[s + 1]) reached[size_t(factor.rows[size_t(row)])] = 1;
  }
  return part;
}

// Rows of neighbouring blocks go together in chunks, with noughts in the places of those that are none.
void CoarseSolve::lay_out(const SupernodalFactor& factor) {
  panels_.clear();
  panel_begin_.assign(1, 0);
  chunks_.clear();
  size_t below = 0, squares = 0;
  for (size_t s = 0; s + 1 < factor.first.size(); ++s) {
    const int columns = factor.first[s + 1] - factor.first[s], parts = (columns + wide - 1) / wide;
    for (int p = 0; p < parts; ++p) {
      const int begin = columns * p / parts, end = columns * (p + 1) / parts, from = int(chunks_.size());
      int next = 0;
      for (int k = factor.row_begin[s] + end; k < factor.row_begin[s + 1]; ++k)
        if (const int row = factor.rows[size_t(k)]; row >= next) {
          chunks_.push_back(row);
          next = row + wide;
        }
      panels_.push_back({factor.first[s] + begin, end - begin, from, int(chunks_.size()), below, squares});
      below += size_t(wide * (end - begin)) * (chunks_.size() - size_t(from));
      squares += size_t(wide * (end - begin));
    }
    panel_begin_.push_back(int(panels_.size()));
  }
  below_.resize(below);
  squares_.resize(squares);
}

bool CoarseSolve::fill(const SupernodalFactor& factor, size_t s) {
  Source from;
  from.height = factor.row_begin[s + 1] - factor.row_begin[s];
  from.rows = factor.rows.data() + factor.row_begin[s];
  from.last = s + 2 == factor.first.size();
  for (int p = panel_begin_[s]; p < panel_begin_[s + 1]; ++p) {
    const Panel& panel = panels_[size_t(p)];
    from.begin = panel.first - factor.first[s];
    for (int m = 0; m < panel.columns; ++m)
      from.column[m] = &factor.values[size_t(factor.value_begin[s]) + size_t(from.begin + m) * size_t(from.height)];
    const std::span<const int> chunks(chunks_.data() + panel.chunk_begin, chunks_.data() + panel.chunk_end);
    if (!fill_panel(panel.columns, {from, chunks, below_.data() + panel.below, squares_.data() + panel.square}))
      return false;
  }
  return true;
}

bool CoarseSolve::take(const SupernodalFactor& factor) {
  order_ = factor.order;
  all_.supernodes.resize(factor.first.size() - 1);
  all_.unknowns.resize(factor.order.size());
  for (auto* list : {&all_.supernodes, &all_.unknowns}) std::iota(list->begin(), list->end(), 0);
  lay_out(factor);
  y_.resize(factor.order.size() + wide);
  for (size_t s = 0; s + 1 < factor.first.size(); ++s)
    if (!fill(factor, s)) return false;
  return true;
}

void CoarseSolve::solve(const Vector& b, Vector& x, const FactorPart& part) {
  x.resize(b.size());
  double scale = 0;
  for (const int k : part.unknowns) scale = std::max(scale, std::abs(b[order_[size_t(k)]]));
  if (scale == 0) scale = 1;
  std::fill(y_.begin(), y_.end(), 0.0f);
  for (const int k : part.unknowns) y_[size_t(k)] = float(b[order_[size_t(k)]] / scale);
  substitute({panels_.data(), panel_begin_.data(), chunks_.data(), below_.data(), squares_.data()}, part.supernodes,
             y_.data());
  for (const int k : part.unknowns) x[order_[size_t(k)]] = scale * double(y_[size_t(k)]);
}

}  // namespace talus
