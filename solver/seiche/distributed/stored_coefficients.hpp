/// Where the matrices of the lattice models keep the coefficient of two cells.
#pragma once

#include <cstddef>
#include <utility>

#include "seiche/linear/lattice_matrix.hpp"

namespace seiche::distributed {

/// The coefficient of cells (i, j) and (i + di, j + dj), -1 <= di, dj <= 1, which must both be there. It stays in its
/// place for the matrix's life.
inline const double* stored_coefficient(const linear::NinePointMatrix& a, std::size_t i, std::size_t j, std::size_t,
                                        int di, int dj, int) {
  auto cell = static_cast<std::ptrdiff_t>(j * a.columns + i);
  if (dj < 0 || (dj == 0 && di < 0)) {
    cell += dj * static_cast<std::ptrdiff_t>(a.columns) + di;
    di = -di;
    dj = -dj;
  }
  if (dj == 0) return (di == 0 ? a.own : a.right).data() + cell;
  return (di < 0 ? a.up_left : di == 0 ? a.up : a.up_right).data() + cell;
}

/// The same for cells (i, j, l) and (i + di, j + dj, l + dl).
inline const double* stored_coefficient(const linear::TwentySevenPointMatrix& a, std::size_t i, std::size_t j,
                                        std::size_t l, int di, int dj, int dl) {
  auto column = static_cast<std::ptrdiff_t>(i);
  auto row = static_cast<std::ptrdiff_t>(l * a.rows + j);
  if (di == 0 && dj == 0 && dl == 0) return a.own.data() + row * static_cast<std::ptrdiff_t>(a.columns) + column;
  if (dl < 0 || (dl == 0 && (dj < 0 || (dj == 0 && di < 0)))) {
    row += dl * static_cast<std::ptrdiff_t>(a.rows) + dj;
    column += di;
    di = -di;
    dj = -dj;
    dl = -dl;
  }
  return a.later.row(static_cast<std::size_t>(row))[linear::later_neighbour(di, dj, dl)] + column;
}

inline std::size_t layers_of(const linear::NinePointMatrix&) {
  return 1;
}
inline std::size_t layers_of(const linear::TwentySevenPointMatrix& a) {
  return a.layers;
}

}  // namespace seiche::distributed
