/// Symmetric positive definite tridiagonal system, one right-hand side, eliminated from both ends while its rows are
/// still being made, and solved from the middle outwards while its solution is already being used.
///
///     sweep.begin(rows, n);
///     while (...) { make rows; sweep.eliminate(front, back); }   // rows [0, front) and [back, n) are known
///     sweep.join();                                              // the middle row
///     while (...) { sweep.substitute(first, last); use x }       // x of [first, last) is wanted
///
/// The same elimination as TwoEndedTridiagonal, for matrices that are used once: nothing is swept over twice. A pivot
/// that is not positive throws NotPositiveDefinite from join. What is done from the front and from the back may be done
/// by two threads; together, in one, it costs less than one after the other.
#pragma once

#include <cstddef>

namespace seiche::linear {

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
