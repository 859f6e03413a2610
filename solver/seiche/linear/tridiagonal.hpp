/// Symmetric positive definite tridiagonal systems, factorised once and solved for many right-hand sides.
///
///     A_ii = diagonal[i],   A_{i,i+1} = A_{i+1,i} = off_diagonal[i],   i = 0..n-1
///
/// Tridiagonal eliminates from the first row to the last: one chain of a multiplication and a division per row.
///
/// TwoEndedTridiagonal eliminates from both ends to the middle row (twisted factorisation): two independent chains,
/// which one processor core overlaps. Same accuracy, different rounding.
///
/// PeriodicTridiagonal has its last row also coupled to the first, by off_diagonal[n-1]. The last unknown is eliminated
/// by its Schur complement, a Cholesky step and hence backward stable, which Sherman-Morrison is not.
///
/// No allocation after the first factorisation of a size. Arrays x and right_hand_side may be the same. A pivot that is
/// not positive throws NotPositiveDefinite with its row.
///
/// When not to use it: matrices that are not positive definite, which would need pivoting.
///
/// References: Golub & Van Loan, Matrix Computations, 4th ed. (2013), 4.3; Babuska, Numerical stability in problems of
/// linear algebra, SIAM J. Numer. Anal. 9 (1972) 53 (elimination from both ends).
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace seiche::linear {

class NotPositiveDefinite : public std::runtime_error {
 public:
  explicit NotPositiveDefinite(std::size_t row);
  NotPositiveDefinite(std::size_t row, double pivot);
  [[nodiscard]] std::size_t row() const { return row_; }

 private:
  std::size_t row_;
};

/// Ownership-free view of the two arrays; off_diagonal may be longer than needed.
struct TridiagonalMatrix {
  std::span<const double> diagonal;
  std::span<const double> off_diagonal;
};

class Tridiagonal {
 public:
  /// Throws std::invalid_argument for an empty matrix or too short an off_diagonal, NotPositiveDefinite.
  void factor(TridiagonalMatrix a);
  void solve(std::span<const double> right_hand_side, std::span<double> x) const;
  [[nodiscard]] std::size_t size() const { return inverse_pivot_.size(); }

 private:
  std::vector<double> inverse_pivot_;
  std::vector<double> multiplier_;
};

class TwoEndedTridiagonal {
 public:
  void factor(TridiagonalMatrix a);
  void solve(std::span<const double> right_hand_side, std::span<double> x) const;
  [[nodiscard]] std::size_t size() const { return inverse_pivot_.size(); }

 private:
  std::vector<double> inverse_pivot_;
  std::vector<double> multiplier_;  // off_diagonal[i] times the inverse pivot of its outer row
};

class PeriodicTridiagonal {
 public:
  /// At least three rows; off_diagonal[n-1] couples the last row to the first.
  void factor(TridiagonalMatrix a);
  void solve(std::span<const double> right_hand_side, std::span<double> x) const;
  [[nodiscard]] std::size_t size() const { return border_.size() + 1; }

 private:
  TwoEndedTridiagonal inner_;
  std::vector<double> border_;  // inner^-1 (column of the last unknown)
  double first_ = 0;            // couplings of the last unknown to the first and to the last but one
  double last_ = 0;
  double inverse_schur_ = 0;
};

}  // namespace seiche::linear
