/// Direct solver of nine-point systems on long lattices: block LDL^T inside the band, from both ends to the middle.
///
/// Cells are numbered along the shorter direction of the lattice, so that a cell of n = min(columns, rows) cells a line
/// is coupled with the n + 1 cells after it. The numbering is cut into blocks of eight cells, whose pivots D_j are 8 x
/// 8 matrices:
///
///     A = L D L^T,   U_ij = A_ij - sum_k L_ik U_jk^T,   D_j = U_jj,   L_ij = U_ij D_j^-1,   i >= j > k
///
/// Inverses of the pivots are formed by Gauss-Jordan sweeps, whose own pivots are those of Cholesky's method. The other
/// end of the lattice is eliminated at the same time in the opposite order: two independent chains of operations, which
/// one processor core overlaps. Work per factorisation about cells n^2 / 2 multiplications, per solution 2 cells n;
/// memory about cells n numbers.
///
/// When not to use it: lattices more than about 100 cells across (SparseCholesky, or iteration).
///
/// References: Golub & Van Loan, Matrix Computations, 4th ed. (2013), 4.3, 4.5; Demmel, Higham & Schreiber, Stability
/// of block LU factorization, Numer. Linear Algebra Appl. 2 (1995) 173; Goodnight, A tutorial on the SWEEP operator,
/// Am. Statistician 33 (1979) 149.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "seiche/linear/conjugate_gradients.hpp"
#include "seiche/linear/dense_block.hpp"
#include "seiche/linear/sparse_cholesky.hpp"

namespace seiche::linear {

class NinePointCholesky {
 public:
  /// At least one column and one row. Throws std::invalid_argument.
  NinePointCholesky(std::size_t columns, std::size_t rows);

  /// Throws std::invalid_argument for a matrix of another shape, NotPositiveDefinite with the index of the cell.
  void factor(const StencilMatrix& a);
  /// Arrays of one number per cell, in the order of the lattice; they may be the same. One thread at a time.
  void solve(std::span<const double> right_hand_side, std::span<double> x) const;

  [[nodiscard]] std::size_t size() const { return columns_ * rows_; }

 private:
  using Block = dense_block::Block;
  using Segment = dense_block::Segment;
  /// Its blocks below the pivot are L_ij, i = j + 1, ..., j + reach, from `first` on.
  struct BlockColumn {
    std::size_t first, reach;
  };

  /// Elimination from one end of the numbering. Coefficients of a cell with itself, the next of its line, and the one
  /// behind, beside and ahead in the next line are found at the cell plus an offset.
  struct End {
    std::vector<std::size_t> cells;  // by their number
    std::array<std::size_t, 5> offset{};
    std::vector<BlockColumn> columns;
    std::vector<Block> minus_inverse;  // -D^-1
    std::vector<Block> lower;
    std::vector<Block> recent;  // U of the last block columns
    std::vector<Segment> x;
  };
  struct Kernels;

  void lay_out(End& end, std::size_t cells);
  [[nodiscard]] Block* recent(End& end, std::size_t column) const {
    return &end.recent[(column & ring_) * (most_reach_ + 2)];
  }

  std::size_t columns_, rows_;
  std::size_t line_;  // cells of a line
  std::size_t most_reach_ = 0;
  std::size_t ring_ = 0;       // columns of `recent`, a power of two, less one
  std::size_t each_ = 0;       // block columns eliminated from each end before the middle
  mutable End front_, back_;   // the front with the middle
  std::vector<Block> middle_;  // what the back adds to the block columns of the middle
};

}  // namespace seiche::linear
