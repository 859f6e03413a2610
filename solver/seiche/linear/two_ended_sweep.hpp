/// Symmetric positive definite tridiagonal system, one right-hand side, eliminated from both ends while its rows are
/// still being made, and solved from the middle outwards while its solution is already being used.
///
///     sweep.begin(rows, n);
///     while (...) { make rows; sweep.eliminate(front, back); }   // rows [0, front) and [back, n) are known
///     sweep.join();                                              // the middle row
///     while (...) { sweep.substitute(first, last); use x }       // x of [first, last) is wanted
///
/// The same elimination as TwoEndedTridiagonal, for matrices that are used once: nothing is swept over twice. A pivot
/// that is not positive throws NotPositiveDefinite from join.
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
    double* multiplier;       ///< work
    double* x;                ///< solution; may be right_hand_side
  };
  void begin(Rows rows, std::ptrdiff_t n);
  void eliminate(std::ptrdiff_t front, std::ptrdiff_t back);
  void join();
  void substitute(std::ptrdiff_t first, std::ptrdiff_t last);

 private:
  Rows rows_{};
  std::ptrdiff_t n_ = 0;
  std::ptrdiff_t middle_ = 0;
  std::ptrdiff_t front_ = 0;  // rows eliminated from the front: [0, front_)
  std::ptrdiff_t back_ = 0;   // and from the back: [back_, n)
  double front_inverse_ = 0, front_value_ = 0;
  double back_inverse_ = 0, back_value_ = 0;
  double smallest_inverse_ = 0;
};

}  // namespace seiche::linear
