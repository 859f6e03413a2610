/// Symmetric matrix on a lattice of columns x rows x layers cells, each coupled with its 26 neighbours.
///
/// Cell (i, j, l) has index c = (l rows + j) columns + i. Fourteen coefficients are stored per cell, its own and those
/// of the thirteen neighbours (i + di, j + dj, l + dl) that come after it:
///
///     dl = 0:  (1, 0)  (-1, 1)  (0, 1)  (1, 1)          dl = 1:  all nine (di, dj)
///
/// Coefficients of neighbours outside the lattice must be zero. Products skip layers that are not there: one layer
/// costs as much as a nine-point matrix.
#pragma once

#include <cstddef>

#include "seiche/linear/nine_point_matrix.hpp"
#include "seiche/linear/row_blocks.hpp"

namespace seiche::linear {

/// Number of the coefficient of the neighbour (di, dj, dl) that comes after a cell: 0..12.
constexpr std::size_t later_neighbour(int di, int dj, int dl) {
  return static_cast<std::size_t>(dl == 1 ? 4 + 3 * (dj + 1) + di + 1 : dj == 0 ? 0 : 2 + di);
}

struct TwentySevenPointMatrix {
  TwentySevenPointMatrix() = default;
  TwentySevenPointMatrix(std::size_t columns_, std::size_t rows_, std::size_t layers_)
      : columns(columns_),
        rows(rows_),
        layers(layers_),
        own(columns_, rows_ * layers_),
        later(columns_, rows_ * layers_, 13) {}

  [[nodiscard]] std::size_t size() const { return columns * rows * layers; }
  /// The stored coefficient of cells a and b, in either order, which must be neighbours or one cell.
  [[nodiscard]] double& coefficient(std::size_t a, std::size_t b);
  /// result = A x; returns x . A x. Threads share the rows of the lattice: one partial sum per row, summed in order, so
  /// the same for any number of threads. Margins of x must be finite.
  double multiply_and_dot(const LatticeArray& x, LatticeArray& result) const;

  std::size_t columns = 0;
  std::size_t rows = 0;
  std::size_t layers = 0;
  LatticeArray own;
  RowBlocks later;  // by rows l rows + j
};

}  // namespace seiche::linear
