#include "seiche/linear/two_ended_sweep.hpp"

#include <algorithm>
#include <limits>

#include "seiche/linear/tridiagonal.hpp"

namespace seiche::linear {

void TwoEndedSweep::begin(Rows rows, std::ptrdiff_t n) {
  rows_ = rows;
  n_ = n;
  middle_ = n / 2;
  front_ = 0;
  back_ = n;
  front_inverse_ = front_value_ = back_inverse_ = back_value_ = 0;
  smallest_inverse_ = std::numeric_limits<double>::infinity();
}

void TwoEndedSweep::eliminate(std::ptrdiff_t front, std::ptrdiff_t back) {
  front = std::min(front, middle_);
  back = std::max(back, middle_ + 1);
  const double* const d = rows_.diagonal;
  const double* const e = rows_.off_diagonal;
  double* const b = rows_.right_hand_side;
  double* const multiplier = rows_.multiplier;
  double top = front_inverse_;
  double top_value = front_value_;
  double bottom = back_inverse_;
  double bottom_value = back_value_;
  double smallest = smallest_inverse_;
  std::ptrdiff_t i = front_;
  std::ptrdiff_t j = back_ - 1;
  // The first row on either side has no neighbour outside.
  const auto row_from_front = [&] {
    if (i > 0) {
      const double coupling = e[i - 1];
      const double m = coupling * top;
      multiplier[i - 1] = m;
      top_value = b[i] - m * top_value;
      top = 1 / (d[i] - (coupling * coupling) * top);
    } else {
      top_value = b[0];
      top = 1 / d[0];
    }
    b[i] = top_value * top;
    smallest = top < smallest ? top : smallest;
    ++i;
  };
  const auto row_from_back = [&] {
    if (j < n_ - 1) {
      const double coupling = e[j];
      const double m = coupling * bottom;
      multiplier[j] = m;
      bottom_value = b[j] - m * bottom_value;
      bottom = 1 / (d[j] - (coupling * coupling) * bottom);
    } else {
      bottom_value = b[j];
      bottom = 1 / d[j];
    }
    b[j] = bottom_value * bottom;
    smallest = bottom < smallest ? bottom : smallest;
    --j;
  };
  if (i == 0 && i < front) row_from_front();
  if (j == n_ - 1 && j >= back) row_from_back();
  while (i < front && j >= back) {
    row_from_front();
    row_from_back();
  }
  while (i < front) row_from_front();
  while (j >= back) row_from_back();
  front_ = i;
  back_ = j + 1;
  front_inverse_ = top;
  front_value_ = top_value;
  back_inverse_ = bottom;
  back_value_ = bottom_value;
  smallest_inverse_ = smallest;
}

void TwoEndedSweep::join() {
  const double* const e = rows_.off_diagonal;
  double pivot = rows_.diagonal[middle_];
  double value = rows_.right_hand_side[middle_];
  if (middle_ > 0) {
    const double m = e[middle_ - 1] * front_inverse_;
    rows_.multiplier[middle_ - 1] = m;
    pivot -= e[middle_ - 1] * m;
    value -= m * front_value_;
  }
  if (middle_ < n_ - 1) {
    const double m = e[middle_] * back_inverse_;
    rows_.multiplier[middle_] = m;
    pivot -= e[middle_] * m;
    value -= m * back_value_;
  }
  // A pivot that is zero or not a number passes no comparison on its way here.
  if (!(smallest_inverse_ > 0) || !(pivot > 0)) throw NotPositiveDefinite(static_cast<std::size_t>(middle_), pivot);
  rows_.x[middle_] = value / pivot;
  front_ = middle_;
  back_ = middle_ + 1;
}

void TwoEndedSweep::substitute(std::ptrdiff_t first, std::ptrdiff_t last) {
  const double* const z = rows_.right_hand_side;
  const double* const multiplier = rows_.multiplier;
  double* const x = rows_.x;
  std::ptrdiff_t i = front_ - 1;
  std::ptrdiff_t j = back_;
  double top = x[front_];
  double bottom = x[back_ - 1];
  while (i >= first && j < last) {
    x[i] = top = z[i] - multiplier[i] * top;
    x[j] = bottom = z[j] - multiplier[j - 1] * bottom;
    --i;
    ++j;
  }
  for (; i >= first; --i) x[i] = top = z[i] - multiplier[i] * top;
  for (; j < last; ++j) x[j] = bottom = z[j] - multiplier[j - 1] * bottom;
  front_ = i + 1;
  back_ = j;
}

}  // namespace seiche::linear
