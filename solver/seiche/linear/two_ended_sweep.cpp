#include "seiche/linear/two_ended_sweep.hpp"

#include <algorithm>
#include <limits>

#include "seiche/linear/tridiagonal.hpp"

namespace seiche::linear {

void TwoEndedSweep::begin(Rows rows, std::ptrdiff_t n) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  rows_ = rows;
  n_ = n;
  middle_ = n / 2;
  front_ = {.row = 0, .smallest = infinity};
  back_ = {.row = n - 1, .smallest = infinity};
}

template <bool from_front>
[[gnu::always_inline]] inline void TwoEndedSweep::eliminate_row(Side& side) const {
  const std::ptrdiff_t i = side.row;
  const std::ptrdiff_t pair = from_front ? i - 1 : i;  // of the row and its neighbour outside
  double* const b = rows_.right_hand_side;
  if (i == (from_front ? 0 : n_ - 1)) {
    side.value = b[i];
    side.inverse = 1 / rows_.diagonal[i];
  } else {
    const double coupling = rows_.off_diagonal[pair];
    const double m = coupling * side.inverse;
    rows_.multiplier[pair] = m;
    side.value = b[i] - m * side.value;
    side.inverse = 1 / (rows_.diagonal[i] - (coupling * coupling) * side.inverse);
  }
  b[i] = side.value * side.inverse;
  side.smallest = side.inverse < side.smallest ? side.inverse : side.smallest;
  side.row += from_front ? 1 : -1;
}

void TwoEndedSweep::eliminate(std::ptrdiff_t front, std::ptrdiff_t back) {
  const std::ptrdiff_t front_end = std::min(front, middle_);
  const std::ptrdiff_t back_end = std::max(back, middle_ + 1);
  // Two independent chains of divisions: the processor overlaps them.
  Side from_front = front_;
  Side from_back = back_;
  while (from_front.row < front_end && from_back.row >= back_end) {
    eliminate_row<true>(from_front);
    eliminate_row<false>(from_back);
  }
  front_ = from_front;
  back_ = from_back;
  eliminate_front(front);
  eliminate_back(back);
}

void TwoEndedSweep::eliminate_front(std::ptrdiff_t front) {
  Side side = front_;
  while (side.row < std::min(front, middle_)) eliminate_row<true>(side);
  front_ = side;
}

void TwoEndedSweep::eliminate_back(std::ptrdiff_t back) {
  Side side = back_;
  while (side.row >= std::max(back, middle_ + 1)) eliminate_row<false>(side);
  back_ = side;
}

void TwoEndedSweep::join() {
  const double* const e = rows_.off_diagonal;
  double pivot = rows_.diagonal[middle_];
  double value = rows_.right_hand_side[middle_];
  if (middle_ > 0) {
    const double coupling = e[middle_ - 1];  // where the multiplier may go
    const double m = coupling * front_.inverse;
    rows_.multiplier[middle_ - 1] = m;
    pivot -= coupling * m;
    value -= m * front_.value;
  }
  if (middle_ < n_ - 1) {
    const double coupling = e[middle_];
    const double m = coupling * back_.inverse;
    rows_.multiplier[middle_] = m;
    pivot -= coupling * m;
    value -= m * back_.value;
  }
  // A pivot that is zero or not a number passes no comparison on its way here.
  if (!(std::min(front_.smallest, back_.smallest) > 0) || !(pivot > 0)) {
    throw NotPositiveDefinite(static_cast<std::size_t>(middle_), pivot);
  }
  rows_.x[middle_] = value / pivot;
  first_ = middle_;
  last_ = middle_ + 1;
}

/// From the value of the row before, nearer to the middle.
template <bool to_front>
[[gnu::always_inline]] inline void TwoEndedSweep::substitute_row(std::ptrdiff_t& row, double& value) const {
  value = rows_.right_hand_side[row] - rows_.multiplier[to_front ? row : row - 1] * value;
  rows_.x[row] = value;
  row += to_front ? -1 : 1;
}

void TwoEndedSweep::substitute(std::ptrdiff_t first, std::ptrdiff_t last) {
  std::ptrdiff_t i = first_ - 1;
  std::ptrdiff_t j = last_;
  double left = rows_.x[first_];
  double right = rows_.x[last_ - 1];
  while (i >= first && j < last) {
    substitute_row<true>(i, left);
    substitute_row<false>(j, right);
  }
  first_ = i + 1;
  last_ = j;
  substitute_front(first);
  substitute_back(last);
}

void TwoEndedSweep::substitute_front(std::ptrdiff_t first) {
  double value = rows_.x[first_];
  std::ptrdiff_t i = first_ - 1;
  while (i >= first) substitute_row<true>(i, value);
  first_ = i + 1;
}

void TwoEndedSweep::substitute_back(std::ptrdiff_t last) {
  double value = rows_.x[last_ - 1];
  std::ptrdiff_t j = last_;
  while (j < last) substitute_row<false>(j, value);
  last_ = j;
}

}  // namespace seiche::linear
