#include "seiche/linear/lattice_matrix.hpp"

#include <array>
#include <utility>
#include <vector>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

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
  std::vector<double> partial(rows_ * layers_);
  share_out(partial.size(), size() >= worth_threads, [&](std::size_t row) {
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
    partial[row] = add_layer(up,
                             {before(1, 1, 0), before(0, 1, 0), before(-1, 1, 0), before(1, 0, 0), a[own] + c,
                              after(1, 0, 0), after(-1, 1, 0), after(0, 1, 0), after(1, 1, 0)},
                             in, up, in, out);
    Nine nine;
    if (l + 1 < layers_) {
      for (int k = 0; k < 9; ++k) nine[static_cast<std::size_t>(k)] = after(k % 3 - 1, k / 3 - 1, 1);
      partial[row] += add_layer(up, nine, in + level, up, in, out);
    }
    if (l > 0) {
      for (int k = 0; k < 9; ++k) nine[static_cast<std::size_t>(k)] = before(1 - k % 3, 1 - k / 3, 1);
      partial[row] += add_layer(up, nine, in - level, up, in, out);
    }
  });
  double sum = 0;
  for (const double p : partial) sum += p;
  return sum;
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
