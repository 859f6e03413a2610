#include "seiche/linear/lattice_matrix.hpp"

#include <utility>
#include <vector>

#include "seiche/linear/worth_threads.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::linear {
namespace {

/// Cells [first, last) of A x; returns the sum of x (A x) over them.
SEICHE_SIMD_CLONES double multiply_cells(const NinePointMatrix& a, const double* x, double* result,
                                         std::ptrdiff_t first, std::ptrdiff_t last) {
  const auto n = static_cast<std::ptrdiff_t>(a.columns);
  const double* const own = a.own.data();
  const double* const right = a.right.data();
  const double* const up = a.up.data();
  const double* const up_right = a.up_right.data();
  const double* const up_left = a.up_left.data();
  double dot = 0;
#pragma omp simd reduction(+ : dot)
  for (std::ptrdiff_t c = first; c < last; ++c) {
    const double below = up_right[c - n - 1] * x[c - n - 1] + up[c - n] * x[c - n] + up_left[c - n + 1] * x[c - n + 1];
    const double same = right[c - 1] * x[c - 1] + own[c] * x[c] + right[c] * x[c + 1];
    const double above = up_left[c] * x[c + n - 1] + up[c] * x[c + n] + up_right[c] * x[c + n + 1];
    result[c] = below + same + above;
    dot += x[c] * result[c];
  }
  return dot;
}

}  // namespace

double NinePointMatrix::multiply_and_dot(const LatticeArray& x, LatticeArray& result) const {
  const double* const in = x.data();
  double* const out = result.data();
  std::vector<double> partial(rows);
  share_out(rows, size() >= worth_threads, [&](std::size_t j) {
    const auto first = static_cast<std::ptrdiff_t>(j * columns);
    partial[j] = multiply_cells(*this, in, out, first, first + static_cast<std::ptrdiff_t>(columns));
  });
  double sum = 0;
  for (const double p : partial) sum += p;
  return sum;
}

double& NinePointMatrix::coefficient(std::size_t a, std::size_t b) {
  if (b < a) std::swap(a, b);
  const std::size_t across = b / columns - a / columns;
  const std::size_t from = a % columns;
  const std::size_t to = b % columns;
  if (across == 0) return (from == to ? own : right).data()[a];
  return (to == from ? up : to > from ? up_right : up_left).data()[a];
}

namespace {

using Row = RowBlocks::ConstRow;

constexpr std::size_t right = later_neighbour(1, 0, 0);
constexpr std::size_t north_west = later_neighbour(-1, 1, 0);
constexpr std::size_t north = later_neighbour(0, 1, 0);
constexpr std::size_t north_east = later_neighbour(1, 1, 0);

/// Rows j - 1, j, j + 1 of a layer: unknowns, and coefficients of the neighbours that come after.
struct Layer {
  const double* south;
  const double* middle;
  const double* north;
};
struct LayerRows {
  Row south, middle, north;
};

/// y = the terms of the row's own layer.
SEICHE_SIMD_CLONES void multiply_level(std::size_t n, const double* own, Row before, Row here, Layer x, double* y) {
  const double* const se = before[north_west];
  const double* const so = before[north];
  const double* const sw = before[north_east];
  const double* const r = here[right];
  const double* const nw = here[north_west];
  const double* const no = here[north];
  const double* const ne = here[north_east];
  const auto columns = static_cast<std::ptrdiff_t>(n);
#pragma omp simd
  for (std::ptrdiff_t i = 0; i < columns; ++i) {
    const double below = sw[i - 1] * x.south[i - 1] + so[i] * x.south[i] + se[i + 1] * x.south[i + 1];
    const double same = r[i - 1] * x.middle[i - 1] + own[i] * x.middle[i] + r[i] * x.middle[i + 1];
    const double above = nw[i] * x.north[i - 1] + no[i] * x.north[i] + ne[i] * x.north[i + 1];
    y[i] = below + same + above;
  }
}

/// y += the terms of the layer above; its rows' coefficients belong to this row.
SEICHE_SIMD_CLONES void add_above(std::size_t n, Row here, Layer x, double* y) {
  const double* const a0 = here[4];
  const double* const a1 = here[5];
  const double* const a2 = here[6];
  const double* const a3 = here[7];
  const double* const a4 = here[8];
  const double* const a5 = here[9];
  const double* const a6 = here[10];
  const double* const a7 = here[11];
  const double* const a8 = here[12];
  const auto columns = static_cast<std::ptrdiff_t>(n);
#pragma omp simd
  for (std::ptrdiff_t i = 0; i < columns; ++i) {
    const double south = a0[i] * x.south[i - 1] + a1[i] * x.south[i] + a2[i] * x.south[i + 1];
    const double middle = a3[i] * x.middle[i - 1] + a4[i] * x.middle[i] + a5[i] * x.middle[i + 1];
    const double northern = a6[i] * x.north[i - 1] + a7[i] * x.north[i] + a8[i] * x.north[i + 1];
    y[i] += south + middle + northern;
  }
}

/// y += the terms of the layer below, whose rows hold the coefficients.
SEICHE_SIMD_CLONES void add_below(std::size_t n, LayerRows a, Layer x, double* y) {
  const double* const se = a.south[later_neighbour(-1, 1, 1)];
  const double* const so = a.south[later_neighbour(0, 1, 1)];
  const double* const sw = a.south[later_neighbour(1, 1, 1)];
  const double* const ea = a.middle[later_neighbour(-1, 0, 1)];
  const double* const mi = a.middle[later_neighbour(0, 0, 1)];
  const double* const we = a.middle[later_neighbour(1, 0, 1)];
  const double* const ne = a.north[later_neighbour(-1, -1, 1)];
  const double* const no = a.north[later_neighbour(0, -1, 1)];
  const double* const nw = a.north[later_neighbour(1, -1, 1)];
  const auto columns = static_cast<std::ptrdiff_t>(n);
#pragma omp simd
  for (std::ptrdiff_t i = 0; i < columns; ++i) {
    const double south = sw[i - 1] * x.south[i - 1] + so[i] * x.south[i] + se[i + 1] * x.south[i + 1];
    const double middle = we[i - 1] * x.middle[i - 1] + mi[i] * x.middle[i] + ea[i + 1] * x.middle[i + 1];
    const double northern = nw[i - 1] * x.north[i - 1] + no[i] * x.north[i] + ne[i + 1] * x.north[i + 1];
    y[i] += south + middle + northern;
  }
}

SEICHE_SIMD_CLONES double dot_row(std::size_t n, const double* x, const double* y) {
  double sum = 0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = 0; i < n; ++i) sum += x[i] * y[i];
  return sum;
}

}  // namespace

double TwentySevenPointMatrix::multiply_and_dot(const LatticeArray& x, LatticeArray& result) const {
  std::vector<double> partial(rows * layers);
  share_out(rows * layers, size() >= worth_threads, [&](std::size_t r) {
    const std::size_t j = r % rows;
    const std::size_t l = r / rows;
    const double* const in = x.data() + r * columns;
    double* const out = result.data() + r * columns;
    const auto around = [&](const double* middle) { return Layer{middle - columns, middle, middle + columns}; };
    multiply_level(columns, own.data() + r * columns, j > 0 ? later.row(r - 1) : later.zeros(), later.row(r),
                   around(in), out);
    if (l + 1 < layers) add_above(columns, later.row(r), around(in + rows * columns), out);
    if (l > 0) {
      const std::size_t below = r - rows;
      add_below(columns,
                {j > 0 ? later.row(below - 1) : later.zeros(), later.row(below),
                 j + 1 < rows ? later.row(below + 1) : later.zeros()},
                around(in - rows * columns), out);
    }
    partial[r] = dot_row(columns, in, out);
  });
  double sum = 0;
  for (const double p : partial) sum += p;
  return sum;
}

double& TwentySevenPointMatrix::coefficient(std::size_t a, std::size_t b) {
  if (b < a) std::swap(a, b);
  if (a == b) return own.data()[a];
  const auto difference = [](std::size_t to, std::size_t from) {
    return static_cast<int>(static_cast<std::ptrdiff_t>(to) - static_cast<std::ptrdiff_t>(from));
  };
  const int di = difference(b % columns, a % columns);
  const int dj = difference(b / columns % rows, a / columns % rows);
  const int dl = difference(b / columns / rows, a / columns / rows);
  return later.row(a / columns)[later_neighbour(di, dj, dl)][a % columns];
}

}  // namespace seiche::linear
