/// Symmetric positive definite tridiagonal systems, factorised once and solved for many right-hand sides.
///
///     A_ii = diagonal[i],   A_{i,i+1} = A_{i+1,i} = off_diagonal[i],   i = 0..n-1
///
/// TwoEndedTridiagonal eliminates from both ends to the middle row (twisted factorisation): two independent chains,
/// which one processor core overlaps. In a ring the last unknown is eliminated by its Schur complement, a Cholesky step
/// and hence backward stable, which Sherman-Morrison is not.
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

class TwoEndedTridiagonal {
 public:
  /// @param ring  whether off_diagonal[n-1] couples the last row to the first; three rows at least then
  void factor(TridiagonalMatrix a, bool ring = false);
  void solve(std::span<const double> right_hand_side, std::span<double> x) const;
  [[nodiscard]] std::size_t size() const { return inverse_pivot_.size() + (border_.empty() ? 0 : 1); }

 private:
  void eliminate(TridiagonalMatrix a);
  void substitute(std::span<const double> right_hand_side, std::span<double> x) const;

  std::vector<double> inverse_pivot_;
  std::vector<double> multiplier_;  // off_diagonal[i] times the inverse pivot of its outer row
  // Of a ring, whose last unknown stands apart:
  std::vector<double> border_;  // its column, solved for by the others; empty without a ring
  double first_ = 0;            // its couplings to the first and to the last but one
  double last_ = 0;
  double inverse_schur_ = 0;
};

// Symmetric positive definite tridiagonal system, one right-hand side, eliminated from both ends while its rows are
// still being made, and solved from the middle outwards while its solution is already being used.
//
//     sweep.begin(rows, n);
//     while (...) { make rows; sweep.eliminate(front, back); }   // rows [0, front) and [back, n) are known
//     sweep.join();                                              // the middle row
//     while (...) { sweep.substitute(first, last); use x }       // x of [first, last) is wanted
//
// The same elimination as TwoEndedTridiagonal, for matrices that are used once: nothing is swept over twice. A pivot
// that is not positive throws NotPositiveDefinite from join. What is done from the front and from the back may be done
// by two threads; together, in one, it costs less than one after the other.

class TwoEndedSweep {
 public:
  /// Arrays of n rows (off_diagonal: n - 1 used), made by the caller before eliminate reaches them.
  struct Rows {
    const double* diagonal;
    const double* off_diagonal;
    double* right_hand_side;  ///< overwritten
    double* multiplier;       ///< work; may be off_diagonal
    double* x;                ///< solution; may be right_hand_side
  };
  void begin(Rows rows, std::ptrdiff_t n);
  void eliminate(std::ptrdiff_t front, std::ptrdiff_t back);
  void eliminate_front(std::ptrdiff_t front);
  void eliminate_back(std::ptrdiff_t back);
  void join();
  void substitute(std::ptrdiff_t first, std::ptrdiff_t last);
  void substitute_front(std::ptrdiff_t first);
  void substitute_back(std::ptrdiff_t last);

 private:
  /// What the last row eliminated from one side leaves to the next one.
  struct Side {
    std::ptrdiff_t row;  ///< that comes next
    double inverse = 0, value = 0;
    double smallest;  ///< inverse of a pivot
  };
  template <bool from_front>
  void eliminate_row(Side& side) const;
  template <bool from_front>
  void substitute_row(std::ptrdiff_t& row, double& value) const;

  Rows rows_{};
  std::ptrdiff_t n_ = 0;
  std::ptrdiff_t middle_ = 0;
  Side front_{}, back_{};
  // Solved so far: [first_, last_).
  std::ptrdiff_t first_ = 0, last_ = 0;
};

}  // namespace seiche::linear
