/// Dense 8 x 8 blocks for factorisations by blocks: loops that compilers turn into vectors of any width. All are
/// inlined into functions compiled for several instruction sets (simd_clones.hpp).
#pragma once

#include <cstddef>

namespace seiche::linear::dense_block {

/// Numbers of a block, one column after the other.
struct alignas(64) Block {
  static constexpr std::size_t n = 8;
  double entry[n * n];
};
struct alignas(64) Segment {
  double entry[Block::n];
};

/// 1, but 0 at k: without a condition, which compilers turn into loops over the rest.
inline constexpr double all_but[Block::n][Block::n] = {
    {0, 1, 1, 1, 1, 1, 1, 1}, {1, 0, 1, 1, 1, 1, 1, 1}, {1, 1, 0, 1, 1, 1, 1, 1}, {1, 1, 1, 0, 1, 1, 1, 1},
    {1, 1, 1, 1, 0, 1, 1, 1}, {1, 1, 1, 1, 1, 0, 1, 1}, {1, 1, 1, 1, 1, 1, 0, 1}, {1, 1, 1, 1, 1, 1, 1, 0}};

/// c -= a b^T, or c = -a b^T
template <bool from_zero = false>
[[gnu::always_inline]] inline void subtract_product(const Block& a, const Block& b, Block& c) {
  constexpr std::size_t n = Block::n;
  const double* __restrict x = a.entry;
  const double* __restrict y = b.entry;
  double* __restrict z = c.entry;
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    double c0 = 0, c1 = 0, c2 = 0, c3 = 0, c4 = 0, c5 = 0, c6 = 0, c7 = 0;
    if constexpr (!from_zero) {
      c0 = z[i], c1 = z[n + i], c2 = z[2 * n + i], c3 = z[3 * n + i];
      c4 = z[4 * n + i], c5 = z[5 * n + i], c6 = z[6 * n + i], c7 = z[7 * n + i];
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double v = x[k * n + i];
      const double* const w = y + k * n;
      c0 -= v * w[0];
      c1 -= v * w[1];
      c2 -= v * w[2];
      c3 -= v * w[3];
      c4 -= v * w[4];
      c5 -= v * w[5];
      c6 -= v * w[6];
      c7 -= v * w[7];
    }
    z[i] = c0, z[n + i] = c1, z[2 * n + i] = c2, z[3 * n + i] = c3;
    z[4 * n + i] = c4, z[5 * n + i] = c5, z[6 * n + i] = c6, z[7 * n + i] = c7;
  }
}

/// y -= a x
[[gnu::always_inline]] inline void subtract_product(const Block& a, const Segment& x, Segment& y) {
  constexpr std::size_t n = Block::n;
  const double* __restrict m = a.entry;
  const double* __restrict v = x.entry;
  double* __restrict z = y.entry;
#pragma omp simd
  for (std::size_t i = 0; i < n; ++i) {
    const double even = m[i] * v[0] + m[2 * n + i] * v[2] + m[4 * n + i] * v[4] + m[6 * n + i] * v[6];
    const double odd = m[n + i] * v[1] + m[3 * n + i] * v[3] + m[5 * n + i] * v[5] + m[7 * n + i] * v[7];
    z[i] -= even + odd;
  }
}

/// Symmetric a becomes -a^-1 by sweeps, step by step in turns with another block. Leaves the pivots.
template <std::size_t count>
[[gnu::always_inline]] inline void invert(Block* const (&a)[count], double (&pivot)[count][Block::n]) {
  constexpr std::size_t n = Block::n;
  for (std::size_t b = 0; b < count; ++b) pivot[b][0] = a[b]->entry[0];
#pragma GCC unroll 8
  for (std::size_t k = 0; k < n; ++k) {
#pragma GCC unroll 2
    for (std::size_t b = 0; b < count; ++b) {
      double* __restrict z = a[b]->entry;
      const double r = 1 / pivot[b][k];
      // The next pivot ahead of its column: all wait for it.
      if (k + 1 < n) {
        const double w = z[k * n + k + 1];
        pivot[b][k + 1] = z[(k + 1) * n + k + 1] - (w * w) * r;
      }
      const double* const others = all_but[k];
      double scaled[n];
#pragma omp simd
      for (std::size_t i = 0; i < n; ++i) scaled[i] = (z[k * n + i] * others[i] - (1 - others[i])) * r;
#pragma GCC unroll 8
      for (std::size_t j = 0; j < n; ++j) {
        if (j == k) continue;
        const double w = z[k * n + j];
#pragma omp simd
        for (std::size_t i = 0; i < n; ++i) z[j * n + i] = z[j * n + i] * others[i] - w * scaled[i];
      }
#pragma omp simd
      for (std::size_t i = 0; i < n; ++i) z[k * n + i] = scaled[i];
    }
  }
}

/// Sums of a^T x over several blocks a.
class RowSums {
 public:
  [[gnu::always_inline]] void add(const Block& a, const Segment& x) {
#pragma GCC unroll 8
    for (std::size_t k = 0; k < n; ++k) {
#pragma omp simd
      for (std::size_t i = 0; i < n; ++i) product_[k * n + i] += a.entry[k * n + i] * x.entry[i];
    }
  }
  /// y = -sum a^T x: eight sums of eight, in halves.
  [[gnu::always_inline]] void negative(Segment& y) const {
    double half[n * n / 2];
    double quarter[n * n / 4];
    for (std::size_t k = 0; k < n; ++k) {
#pragma omp simd
      for (std::size_t i = 0; i < n / 2; ++i) half[k * 4 + i] = product_[k * n + i] + product_[k * n + 4 + i];
    }
    for (std::size_t k = 0; k < n; ++k) {
#pragma omp simd
      for (std::size_t i = 0; i < n / 4; ++i) quarter[k * 2 + i] = half[k * 4 + i] + half[k * 4 + 2 + i];
    }
    for (std::size_t k = 0; k < n; ++k) y.entry[k] = -(quarter[2 * k] + quarter[2 * k + 1]);
  }

 private:
  static constexpr std::size_t n = Block::n;
  double product_[n * n] = {};
};

}  // namespace seiche::linear::dense_block
