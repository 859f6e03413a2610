/// Symmetric matrices that couple a cell of a lattice with its eight neighbours in a plane, or its 26 in space, and the
/// arrays that they are stored in.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace seiche::linear {

/// Several numbers per cell of a lattice, row by row: all numbers of one row of cells lie together.
///
/// Loops over a row then read as many streams as there are numbers from a few pages, and the streams fall on different
/// lines of the cache: the distance between them is an odd number of lines. Every row has zeros before its first and
/// after its last cell, which nobody writes, and there is one row of zeros to stand for rows outside the lattice.
class RowBlocks {
 public:
  RowBlocks() = default;
  RowBlocks(std::size_t columns, std::size_t rows, std::size_t numbers)
      : numbers_(numbers),
        rows_(rows),
        stride_(odd((columns + 2 * margin + line - 1) / line) * line),
        values_((rows + 1) * numbers * stride_, 0.0) {}

  /// Numbers of one row; number k of cell i is at data[k stride + i], -1 <= i <= columns.
  struct Row {
    double* data;
    std::size_t stride;
    [[nodiscard]] double* operator[](std::size_t number) const { return data + number * stride; }
  };
  struct ConstRow {
    const double* data;
    std::size_t stride;
    [[nodiscard]] const double* operator[](std::size_t number) const { return data + number * stride; }
  };

  [[nodiscard]] Row row(std::size_t r) { return {values_.data() + begin(r), stride_}; }
  [[nodiscard]] ConstRow row(std::size_t r) const { return {values_.data() + begin(r), stride_}; }
  [[nodiscard]] ConstRow zeros() const { return row(rows_); }

 private:
  static constexpr std::size_t line = 8;  // numbers in a line of the cache
  static constexpr std::size_t margin = line;

  static constexpr std::size_t odd(std::size_t lines) { return lines | 1; }
  [[nodiscard]] std::size_t begin(std::size_t r) const { return r * numbers_ * stride_ + margin; }

  std::size_t numbers_ = 0;
  std::size_t rows_ = 0;
  std::size_t stride_ = 0;
  std::vector<double> values_;
};

// Symmetric matrix on a lattice of columns x rows cells, each coupled with its eight neighbours.
//
// Cell (i, j), i < columns, j < rows, has index c = j columns + i: rows of the lattice are contiguous. Five
// coefficients are stored per cell, those of the cell itself and of the four neighbours that come after it:
//
//     up_left   up   up_right             (i-1, j+1)  (i, j+1)  (i+1, j+1)
//               own     right                         (i, j)    (i+1, j)
//
// Coefficients of neighbours outside the lattice must be zero: products then run over contiguous memory without
// branches. Every coefficient array, and every vector a product reads, has a margin of columns + 1 zeros at both ends.

/// An array of one number per cell with a margin of zeros before and after, so that data()[-margin] may be read.
class LatticeArray {
 public:
  LatticeArray() = default;
  LatticeArray(std::size_t columns, std::size_t rows)
      : margin_(columns + 1), size_(columns * rows), values_(size_ + 2 * margin_, 0.0) {}

  [[nodiscard]] double* data() { return values_.data() + margin_; }
  [[nodiscard]] const double* data() const { return values_.data() + margin_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<double> values() { return {data(), size_}; }
  [[nodiscard]] std::span<const double> values() const { return {data(), size_}; }

 private:
  std::size_t margin_ = 0;
  std::size_t size_ = 0;
  std::vector<double> values_;
};

struct NinePointMatrix {
  NinePointMatrix() = default;
  NinePointMatrix(std::size_t columns_, std::size_t rows_)
      : columns(columns_),
        rows(rows_),
        own(columns_, rows_),
        right(columns_, rows_),
        up(columns_, rows_),
        up_right(columns_, rows_),
        up_left(columns_, rows_) {}

  [[nodiscard]] std::size_t size() const { return columns * rows; }
  /// The stored coefficient of cells a and b, in either order, which must be neighbours or one cell.
  [[nodiscard]] double& coefficient(std::size_t a, std::size_t b);
  /// result = A x; returns x . A x. Threads share the rows of the lattice: one partial sum per row, summed in order, so
  /// the same for any number of threads.
  double multiply_and_dot(const LatticeArray& x, LatticeArray& result) const;

  std::size_t columns = 0;
  std::size_t rows = 0;
  LatticeArray own, right, up, up_right, up_left;
};

// Symmetric matrix on a lattice of columns x rows x layers cells, each coupled with its 26 neighbours.
//
// Cell (i, j, l) has index c = (l rows + j) columns + i. Fourteen coefficients are stored per cell, its own and those
// of the thirteen neighbours (i + di, j + dj, l + dl) that come after it:
//
//     dl = 0:  (1, 0)  (-1, 1)  (0, 1)  (1, 1)          dl = 1:  all nine (di, dj)
//
// Coefficients of neighbours outside the lattice must be zero. Products skip layers that are not there: one layer
// costs as much as a nine-point matrix.

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
