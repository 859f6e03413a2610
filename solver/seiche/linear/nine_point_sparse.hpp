/// Nine-point systems by sparse Cholesky factorisation: NinePointCholesky's interface, for lattices too wide for that.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/linear/nine_point_matrix.hpp"
#include "seiche/linear/sparse_cholesky.hpp"

namespace seiche::linear {

class NinePointSparse {
 public:
  /// At least one column and one row. Throws std::invalid_argument.
  NinePointSparse(std::size_t columns, std::size_t rows);

  /// Throws std::invalid_argument for a matrix of another shape, NotPositiveDefinite with the index of the cell.
  void factor(const NinePointMatrix& a);
  /// Arrays of one number per cell, in the order of the lattice; they may be the same. One thread at a time.
  void solve(std::span<const double> right_hand_side, std::span<double> x) const {
    cholesky_.solve(right_hand_side, x);
  }

  [[nodiscard]] std::size_t size() const { return columns_ * rows_; }
  [[nodiscard]] FactorWork work() const { return cholesky_.work(); }

 private:
  std::size_t columns_;
  std::size_t rows_;
  SparseCholesky cholesky_;
  std::vector<double> values_;  // lower triangle, column by column
};

}  // namespace seiche::linear
