#include "seiche/models/lagrangian_mesh_3d/assembly.hpp"

#include <utility>

#include "seiche/linear/lattice_matrix.hpp"
#include "seiche/simd_clones.hpp"

namespace seiche::lagrangian_mesh_3d {
namespace {

/// Place of a corner in its cell, 0 or 1 along each axis, and back.
constexpr std::array<std::array<int, 3>, 8> place_of{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
constexpr std::size_t corner_at(int px, int py, int pz) {
  return static_cast<std::size_t>(4 * pz + (py == 0 ? px : 3 - px));
}

template <int di, int dj, int dl, std::size_t corner>
SEICHE_INLINE double shared_node(const double* a, const double* b, std::size_t stride, const NodeVectors& w,
                                 std::ptrdiff_t i) {
  constexpr int px = place_of[corner][0];
  constexpr int py = place_of[corner][1];
  constexpr int pz = place_of[corner][2];
  constexpr bool shared = px - di >= 0 && px - di <= 1 && py - dj >= 0 && py - dj <= 1 && pz - dl >= 0 && pz - dl <= 1;
  if constexpr (!shared) {
    return 0;
  } else {
    constexpr std::size_t theirs = corner_at(px - di, py - dj, pz - dl);
    constexpr auto row = static_cast<std::size_t>(py + 2 * pz);
    const auto product = [&](std::size_t axis) __attribute__((always_inline)) {
      return w[axis][row][i + px] * a[static_cast<std::ptrdiff_t>(component(corner, axis) * stride) + i] *
             b[static_cast<std::ptrdiff_t>(component(theirs, axis) * stride) + i + di];
    };
    return product(0) + product(1) + product(2);
  }
}

/// Coefficients of cells first..last-1 with their neighbours (di, dj, dl) of the row b.
template <int di, int dj, int dl>
SEICHE_INLINE void couple(std::size_t first, std::size_t last, const double* a, const double* b, std::size_t stride,
                          const NodeVectors& rows, double* coefficients) {
  const NodeVectors w = rows;
  double* __restrict out = coefficients;
  const auto end = static_cast<std::ptrdiff_t>(last);
#pragma omp simd
  for (auto i = static_cast<std::ptrdiff_t>(first); i < end; ++i) {
    out[i] = ((shared_node<di, dj, dl, 0>(a, b, stride, w, i) + shared_node<di, dj, dl, 1>(a, b, stride, w, i)) +
              (shared_node<di, dj, dl, 2>(a, b, stride, w, i) + shared_node<di, dj, dl, 3>(a, b, stride, w, i))) +
             ((shared_node<di, dj, dl, 4>(a, b, stride, w, i) + shared_node<di, dj, dl, 5>(a, b, stride, w, i)) +
              (shared_node<di, dj, dl, 6>(a, b, stride, w, i) + shared_node<di, dj, dl, 7>(a, b, stride, w, i)));
  }
}

template <int dj, int dl>
SEICHE_INLINE void couple_row(std::size_t columns, const double* a, RowBlocks::ConstRow b, const NodeVectors& w,
                              RowBlocks::Row later) {
  using linear::later_neighbour;
  couple<-1, dj, dl>(1, columns, a, b.data, b.stride, w, later[later_neighbour(-1, dj, dl)]);
  couple<0, dj, dl>(0, columns, a, b.data, b.stride, w, later[later_neighbour(0, dj, dl)]);
  couple<1, dj, dl>(0, columns - 1, a, b.data, b.stride, w, later[later_neighbour(1, dj, dl)]);
}

}  // namespace

SEICHE_SIMD_CLONES
void assemble_row(std::size_t columns, RowBlocks::ConstRow gradients, const LaterRows& rows, const NodeVectors& w,
                  double* own, RowBlocks::Row later) {
  const double* const a = gradients.data;
  couple<0, 0, 0>(0, columns, a, a, gradients.stride, w, own);
  couple<1, 0, 0>(0, columns - 1, a, a, gradients.stride, w, later[linear::later_neighbour(1, 0, 0)]);
  if (rows.has_north) couple_row<1, 0>(columns, a, rows.north, w, later);
  if (rows.has_above[0]) couple_row<-1, 1>(columns, a, rows.above[0], w, later);
  if (rows.has_above[1]) couple_row<0, 1>(columns, a, rows.above[1], w, later);
  if (rows.has_above[2]) couple_row<1, 1>(columns, a, rows.above[2], w, later);
}

}  // namespace seiche::lagrangian_mesh_3d
