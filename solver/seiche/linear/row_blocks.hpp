/// Several numbers per cell of a lattice, row by row: all numbers of one row of cells lie together.
///
/// Loops over a row then read as many streams as there are numbers from a few pages, and the streams fall on different
/// lines of the cache: the distance between them is an odd number of lines. Every row has zeros before its first and
/// after its last cell, which nobody writes, and there is one row of zeros to stand for rows outside the lattice.
#pragma once

#include <cstddef>
#include <vector>

namespace seiche::linear {

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

}  // namespace seiche::linear
