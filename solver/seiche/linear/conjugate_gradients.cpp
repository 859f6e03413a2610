#include "seiche/linear/conjugate_gradients.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

constexpr std::size_t chunk = 4096;
/// Of term(part), in the order of the parts.
template <class Term>
double sum_of_parts(std::size_t parts, bool worth_it, const Term& term) {
  std::vector<double> partial(parts);
  share_out(parts, worth_it, [&](std::size_t part) { partial[part] = term(part); });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

/// Calls kernel(first, length) for every chunk and adds up what it returns.
template <class Kernel>
double sum_over_chunks(std::size_t size, const Kernel& kernel) {
  return sum_of_parts((size + chunk - 1) / chunk, size >= worth_threads,
                      [&](std::size_t c) { return kernel(c * chunk, std::min(chunk, size - c * chunk)); });
}

SEICHE_SIMD_CLONES double dot_chunk(const double* x, const double* y, std::size_t n) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) sum += x[i] * y[i];
  return sum;
}

SEICHE_SIMD_CLONES void scale_and_add_chunk(const double* x, double factor, double* y, std::size_t n) {
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) y[i] = x[i] + factor * y[i];
}

SEICHE_SIMD_CLONES double advance_chunk(double step, const double* p, const double* q, double* x, double* r,
                                        std::size_t n) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) {
    x[i] += step * p[i];
    r[i] -= step * q[i];
    sum += r[i] * r[i];
  }
  return sum;
}

/// Coefficients of a row of cells with their neighbours in one layer: south-west, south, south-east, west, ...
using Nine = std::array<const double*, 9>;

/// y += the products with the nine neighbours around x, `up` from row to row; returns the sum of `own` times them.
SEICHE_SIMD_CLONES double add_layer(std::ptrdiff_t columns, const Nine& nine, const double* x, std::ptrdiff_t up,
                                    const double* own, double* y) {
  const auto [a0, a1, a2, a3, a4, a5, a6, a7, a8] = nine;
  const double* const south = x - up;
  const double* const north = x + up;
  double dot = 0;
#pragma omp simd reduction(+ : dot)
  for (std::ptrdiff_t i = 0; i < columns; ++i) {
    const double below = a0[i] * south[i - 1] + a1[i] * south[i] + a2[i] * south[i + 1];
    const double same = a3[i] * x[i - 1] + a4[i] * x[i] + a5[i] * x[i + 1];
    const double above = a6[i] * north[i - 1] + a7[i] * north[i] + a8[i] * north[i + 1];
    const double sum = below + same + above;
    y[i] += sum;
    dot += own[i] * sum;
  }
  return dot;
}

}  // namespace

double dot(std::span<const double> x, std::span<const double> y) {
  return sum_over_chunks(x.size(),
                         [&](std::size_t first, std::size_t n) { return dot_chunk(&x[first], &y[first], n); });
}

void scale_and_add(std::span<const double> x, double factor, std::span<double> y) {
  sum_over_chunks(y.size(), [&](std::size_t first, std::size_t n) {
    scale_and_add_chunk(&x[first], factor, &y[first], n);
    return 0.0;
  });
}

double advance(double step, std::span<const double> p, std::span<const double> q, std::span<double> x,
               std::span<double> r) {
  return sum_over_chunks(x.size(), [&](std::size_t first, std::size_t n) {
    return advance_chunk(step, &p[first], &q[first], &x[first], &r[first], n);
  });
}

StencilMatrix::StencilMatrix(std::size_t columns, std::size_t rows, std::size_t layers)
    : columns_(columns),
      rows_(rows),
      layers_(layers),
      stride_(odd_lines(size() + 2 * (columns + 1))),
      values_((layers > 1 ? 14 : 5) * stride_, 0.0) {}

double StencilMatrix::multiply_and_dot(const LatticeArray& x, LatticeArray& result) const {
  const StencilMatrix& a = *this;
  const auto up = static_cast<std::ptrdiff_t>(columns_);
  const auto level = static_cast<std::ptrdiff_t>(columns_ * rows_);
  return sum_of_parts(rows_ * layers_, size() >= worth_threads, [&](std::size_t row) {
    const std::size_t c = row * columns_;
    const std::size_t l = row / rows_;
    const double* const in = x.data() + c;
    double* const out = result.data() + c;
    std::fill_n(out, columns_, 0.0);
    // What couples a cell with one before it is stored there.
    const auto before = [&](int di, int dj, int dl) {
      return a[1 + later_neighbour(di, dj, dl)] + c - (dl * level + dj * up + di);
    };
    const auto after = [&](int di, int dj, int dl) { return a[1 + later_neighbour(di, dj, dl)] + c; };
    double dot = add_layer(up,
                           {before(1, 1, 0), before(0, 1, 0), before(-1, 1, 0), before(1, 0, 0), a[own] + c,
                            after(1, 0, 0), after(-1, 1, 0), after(0, 1, 0), after(1, 1, 0)},
                           in, up, in, out);
    Nine nine;
    if (l + 1 < layers_) {
      for (int k = 0; k < 9; ++k) nine[static_cast<std::size_t>(k)] = after(k % 3 - 1, k / 3 - 1, 1);
      dot += add_layer(up, nine, in + level, up, in, out);
    }
    if (l > 0) {
      for (int k = 0; k < 9; ++k) nine[static_cast<std::size_t>(k)] = before(1 - k % 3, 1 - k / 3, 1);
      dot += add_layer(up, nine, in - level, up, in, out);
    }
    return dot;
  });
}

const double& StencilMatrix::coefficient(std::size_t a, std::size_t b) const {
  if (b < a) std::swap(a, b);
  if (a == b) return (*this)[own][a];
  const auto difference = [](std::size_t to, std::size_t from) {
    return static_cast<int>(static_cast<std::ptrdiff_t>(to) - static_cast<std::ptrdiff_t>(from));
  };
  const int di = difference(b % columns_, a % columns_);
  const int dj = difference(b / columns_ % rows_, a / columns_ % rows_);
  const int dl = difference(b / columns_ / rows_, a / columns_ / rows_);
  return (*this)[1 + later_neighbour(di, dj, dl)][a];
}

}  // namespace seiche::linear
