/// Symmetric matrix on a lattice of columns x rows cells, each coupled with its eight neighbours.
///
/// Cell (i, j), i < columns, j < rows, has index c = j columns + i: rows of the lattice are contiguous. Five
/// coefficients are stored per cell, those of the cell itself and of the four neighbours that come after it:
///
///     up_left   up   up_right             (i-1, j+1)  (i, j+1)  (i+1, j+1)
///               own     right                         (i, j)    (i+1, j)
///
/// Coefficients of neighbours outside the lattice must be zero: products then run over contiguous memory without
/// branches. Every coefficient array, and every vector a product reads, has a margin of columns + 1 zeros at both ends.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace seiche::linear {

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

}  // namespace seiche::linear
