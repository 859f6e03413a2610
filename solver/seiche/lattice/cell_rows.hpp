/// Loops over one row of a lattice's cells or nodes, the same for every element: contiguous, without branches, to be
/// called from functions with SEICHE_SIMD_CLONES.
///
/// Corners of a cell go around anticlockwise, 0 to 3, and in space 4 to 7 above them. An element has
///
///     axes, corners, stored        of its nodes' places, of a cell, numbers kept per cell
///     mobilities                   of the nodes' inverse masses W: xx, yy(, zz) or also xy, xz, yz
///     gradient(corner, axis, s, stride, i)   of the volume of cell i: from its numbers, number k at s[k stride + i]
///     rate(s, stride, u, i)        optional: the volume's rate, where it has a shorter form
///
/// and the clones of run(RowLoop), which is run_row. Cells that share a node are coupled there: A = J W J^T has the
/// terms g_a W g_b of the corners a and b at which the two cells have the node.
#pragma once

#include <array>
#include <cstddef>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::lattice {

/// Place of a corner in its cell, 0 or 1 along each direction of the lattice, and back.
inline constexpr std::array<std::array<int, 3>, 8> place_of{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
constexpr std::size_t corner_at(int px, int py, int pz) {
  return static_cast<std::size_t>(4 * pz + (py == 0 ? px : 3 - px));
}

/// Of an element in space that keeps its gradients as they are, number 3 corner + axis.
struct StoredGradients {
  SEICHE_INLINE static double gradient(std::size_t corner, std::size_t axis, const double* s, std::ptrdiff_t stride,
                                       std::ptrdiff_t i) {
    return s[static_cast<std::ptrdiff_t>(3 * corner + axis) * stride + i];
  }
};

/// Rows of nodes around a row of cells, (j, l), (j+1, l), (j, l+1), (j+1, l+1), and of cells around a row of nodes,
/// (j-1, l-1), (j, l-1), (j-1, l), (j, l): in the plane two, without l.
template <class E>
using Rows = std::array<const double*, E::corners / 2>;
template <class E>
using NodeVectors = std::array<Rows<E>, E::axes>;
template <class E>
using NodeMobilities = std::array<Rows<E>, E::mobilities>;

/// A row of cells, with the rows after it: north, and above it south, here and north; null where there are none.
template <class E>
struct Assembly {
  std::size_t columns;
  std::ptrdiff_t stride;
  const double* cells;
  std::array<const double*, 4> later;
  NodeMobilities<E> w;
  bool full;                      ///< W has entries off its diagonal
  std::array<double*, 14> parts;  ///< coefficients with itself, then with linear::later_neighbour 0, 1, ...
};
template <class E>
struct Rates {
  std::size_t columns;
  std::ptrdiff_t stride;
  const double* cells;
  NodeVectors<E> velocity;
  double* rates;
};
/// A row of nodes; multipliers are zeros where there are no cells.
template <class E>
struct Reaction {
  std::size_t columns;
  std::ptrdiff_t stride;
  Rows<E> cells, mu;
  std::array<const double*, E::mobilities> w;
  bool full;
  std::array<double*, E::axes> velocity;
};

/// `count` nodes in a row.
template <class E>
struct Kick {
  std::size_t count;
  double h;
  std::array<const double*, E::axes> push;
  std::array<const double*, E::mobilities> w;
  bool full;
  std::array<double*, E::axes> velocity;
};

template <class E>
concept HasOwnRate = requires(const double* s, std::ptrdiff_t i, const NodeVectors<E>& u) {
  E::rate(s, i, u, i);
};

/// Whether a corner of a cell is one of its neighbour (di, dj, dl), and which.
template <int di, int dj, int dl>
constexpr bool is_shared(std::size_t corner) {
  const auto [px, py, pz] = place_of[corner];
  return px - di >= 0 && px - di <= 1 && py - dj >= 0 && py - dj <= 1 && pz - dl >= 0 && pz - dl <= 1;
}
template <int di, int dj, int dl>
constexpr bool any_shared(std::size_t first, std::size_t count) {
  for (std::size_t c = first; c < first + count; ++c) {
    if (is_shared<di, dj, dl>(c)) return true;
  }
  return false;
}

/// Of the volume of cell i at one of its corners.
template <class E>
SEICHE_INLINE std::array<double, E::axes> gradient_at(std::size_t corner, const double* s, std::ptrdiff_t stride,
                                                      std::ptrdiff_t i) {
  std::array<double, E::axes> g;
  for (std::size_t axis = 0; axis < E::axes; ++axis) g[axis] = E::gradient(corner, axis, s, stride, i);
  return g;
}

/// g_a W g_b, summed in pairs over the shared ones of `count` corners.
template <class E, bool full, int di, int dj, int dl, std::size_t first, std::size_t count>
SEICHE_INLINE double coupling(const double* a, const double* b, std::ptrdiff_t stride, const NodeMobilities<E>& w,
                              std::ptrdiff_t i) {
  constexpr std::size_t half = count / 2;
  if constexpr (count == 1) {
    constexpr std::size_t theirs = corner_at(place_of[first][0] - di, place_of[first][1] - dj, place_of[first][2] - dl);
    constexpr auto row = static_cast<std::size_t>(place_of[first][1] + 2 * place_of[first][2]);
    const std::ptrdiff_t n = i + place_of[first][0];
    const auto g = gradient_at<E>(first, a, stride, i);
    const auto h = gradient_at<E>(theirs, b, stride, i + di);
    double sum = g[0] * w[0][row][n] * h[0] + g[1] * w[1][row][n] * h[1];
    if constexpr (E::axes == 3) sum += g[2] * w[2][row][n] * h[2];
    if constexpr (full) {
      sum += w[3][row][n] * (g[0] * h[1] + g[1] * h[0]) + w[4][row][n] * (g[0] * h[2] + g[2] * h[0]) +
             w[5][row][n] * (g[1] * h[2] + g[2] * h[1]);
    }
    return sum;
  } else if constexpr (!any_shared<di, dj, dl>(first, half)) {
    return coupling<E, full, di, dj, dl, first + half, half>(a, b, stride, w, i);
  } else if constexpr (!any_shared<di, dj, dl>(first + half, half)) {
    return coupling<E, full, di, dj, dl, first, half>(a, b, stride, w, i);
  } else {
    return coupling<E, full, di, dj, dl, first, half>(a, b, stride, w, i) +
           coupling<E, full, di, dj, dl, first + half, half>(a, b, stride, w, i);
  }
}

/// Coefficients of cells first..last-1 with their neighbours (di, dj, dl) in the row b.
template <class E, bool full, int di, int dj, int dl>
SEICHE_INLINE void couple(std::ptrdiff_t first, std::ptrdiff_t last, const Assembly<E>& row, const double* later,
                          double* coefficients) {
  const NodeMobilities<E> w = row.w;
  const double* const a = row.cells;
  const double* const b = later;
  const std::ptrdiff_t stride = row.stride;
  double* __restrict out = coefficients;
#pragma omp simd
  for (std::ptrdiff_t i = first; i < last; ++i) {
    out[i] = coupling<E, full, di, dj, dl, 0, E::corners>(a, b, stride, w, i);
  }
}

template <class E, bool full, int dj, int dl>
SEICHE_INLINE void couple_row(const Assembly<E>& row, const double* later) {
  if (later == nullptr) return;
  constexpr std::size_t west = 1 + linear::later_neighbour(-1, dj, dl);
  const auto n = static_cast<std::ptrdiff_t>(row.columns);
  couple<E, full, -1, dj, dl>(1, n, row, later, row.parts[west]);
  couple<E, full, 0, dj, dl>(0, n, row, later, row.parts[west + 1]);
  couple<E, full, 1, dj, dl>(0, n - 1, row, later, row.parts[west + 2]);
}

template <class E, bool full>
SEICHE_INLINE void assemble(const Assembly<E>& row) {
  const auto n = static_cast<std::ptrdiff_t>(row.columns);
  couple<E, full, 0, 0, 0>(0, n, row, row.cells, row.parts[0]);
  couple<E, full, 1, 0, 0>(0, n - 1, row, row.cells, row.parts[1]);
  couple_row<E, full, 1, 0>(row, row.later[0]);
  if constexpr (E::corners == 8) {
    couple_row<E, full, -1, 1>(row, row.later[1]);
    couple_row<E, full, 0, 1>(row, row.later[2]);
    couple_row<E, full, 1, 1>(row, row.later[3]);
  }
}

/// g u, summed in pairs over corners.
template <class E, std::size_t first, std::size_t count>
SEICHE_INLINE double corner_rates(const double* s, std::ptrdiff_t stride, const NodeVectors<E>& u, std::ptrdiff_t i) {
  if constexpr (count == 1) {
    constexpr auto row = static_cast<std::size_t>(place_of[first][1] + 2 * place_of[first][2]);
    const std::ptrdiff_t n = i + place_of[first][0];
    const auto g = gradient_at<E>(first, s, stride, i);
    double sum = g[0] * u[0][row][n] + g[1] * u[1][row][n];
    if constexpr (E::axes == 3) sum += g[2] * u[2][row][n];
    return sum;
  } else {
    return corner_rates<E, first, count / 2>(s, stride, u, i) +
           corner_rates<E, first + count / 2, count / 2>(s, stride, u, i);
  }
}

/// J u.
template <class E>
SEICHE_INLINE void find_rates(const Rates<E>& row) {
  const NodeVectors<E> u = row.velocity;
  const double* const s = row.cells;
  const std::ptrdiff_t stride = row.stride;
  double* __restrict out = row.rates;
#pragma omp simd
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(row.columns); ++i) {
    if constexpr (HasOwnRate<E>) {
      out[i] = E::rate(s, stride, u, i);
    } else {
      out[i] = corner_rates<E, 0, E::corners>(s, stride, u, i);
    }
  }
}

/// u += W f at one node.
template <class E, bool full>
SEICHE_INLINE void move(const std::array<const double*, E::mobilities>& w, const std::array<double*, E::axes>& u,
                        const std::array<double, E::axes>& f, std::ptrdiff_t i) {
  if constexpr (full) {
    u[0][i] += w[0][i] * f[0] + w[3][i] * f[1] + w[4][i] * f[2];
    u[1][i] += w[3][i] * f[0] + w[1][i] * f[1] + w[5][i] * f[2];
    u[2][i] += w[4][i] * f[0] + w[5][i] * f[1] + w[2][i] * f[2];
  } else {
    for (std::size_t axis = 0; axis < E::axes; ++axis) u[axis][i] += w[axis][i] * f[axis];
  }
}

/// What the cells west and east of a node press on it, from `count` of the rows around it.
template <class E, bool west, bool east, std::size_t first, std::size_t count>
SEICHE_INLINE std::array<double, E::axes> pressure(const Reaction<E>& row, std::ptrdiff_t i) {
  std::array<double, E::axes> force{};
  if constexpr (count == 1) {
    constexpr int py = 1 - first % 2;
    constexpr int pz = E::corners == 8 ? 1 - static_cast<int>(first / 2) : 0;
    if constexpr (east) {
      const auto g = gradient_at<E>(corner_at(0, py, pz), row.cells[first], row.stride, i);
      for (std::size_t axis = 0; axis < E::axes; ++axis) force[axis] = row.mu[first][i] * g[axis];
    }
    if constexpr (west) {
      const auto g = gradient_at<E>(corner_at(1, py, pz), row.cells[first], row.stride, i - 1);
      for (std::size_t axis = 0; axis < E::axes; ++axis) force[axis] += row.mu[first][i - 1] * g[axis];
    }
  } else {
    const auto one = pressure<E, west, east, first, count / 2>(row, i);
    const auto other = pressure<E, west, east, first + count / 2, count / 2>(row, i);
    for (std::size_t axis = 0; axis < E::axes; ++axis) force[axis] = one[axis] + other[axis];
  }
  return force;
}

/// u += W J^T mu.
template <class E, bool full>
SEICHE_INLINE void react(const Reaction<E>& given) {
  const Reaction<E> row = given;
  const auto last = static_cast<std::ptrdiff_t>(row.columns);
  constexpr std::size_t rows = E::corners / 2;
  move<E, full>(row.w, row.velocity, pressure<E, false, true, 0, rows>(row, 0), 0);
#pragma GCC ivdep
  for (std::ptrdiff_t i = 1; i < last; ++i) {
    move<E, full>(row.w, row.velocity, pressure<E, true, true, 0, rows>(row, i), i);
  }
  move<E, full>(row.w, row.velocity, pressure<E, true, false, 0, rows>(row, last), last);
}

/// u += h W push.
template <class E, bool full>
SEICHE_INLINE void kick(const Kick<E>& given) {
  const Kick<E> row = given;
#pragma GCC ivdep
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(row.count); ++i) {
    std::array<double, E::axes> f;
    for (std::size_t axis = 0; axis < E::axes; ++axis) f[axis] = row.h * row.push[axis][i];
    move<E, full>(row.w, row.velocity, f, i);
  }
}

/// One of the loops over a row.
template <class E>
struct RowLoop {
  const Assembly<E>* assembly = nullptr;
  const Rates<E>* rates = nullptr;
  const Reaction<E>* reaction = nullptr;
  const Kick<E>* push = nullptr;
};

template <class E>
SEICHE_INLINE void run_row(const RowLoop<E>& loop) {
  constexpr bool full = E::mobilities == 6;  // may be
  if (const auto* row = loop.assembly) return full && row->full ? assemble<E, full>(*row) : assemble<E, false>(*row);
  if (const auto* row = loop.rates) return find_rates(*row);
  if (const auto* row = loop.reaction) return full && row->full ? react<E, full>(*row) : react<E, false>(*row);
  return full && loop.push->full ? kick<E, full>(*loop.push) : kick<E, false>(*loop.push);
}

}  // namespace seiche::lattice
