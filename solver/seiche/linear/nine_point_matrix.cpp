#include "seiche/linear/nine_point_matrix.hpp"

#include <utility>

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

}  // namespace seiche::linear
