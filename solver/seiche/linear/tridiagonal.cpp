#include "seiche/linear/tridiagonal.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "seiche/require_that.hpp"

namespace seiche::linear {

NotPositiveDefinite::NotPositiveDefinite(std::size_t row)
    : std::runtime_error(fmt::format("matrix is not positive definite: row {}", row)), row_(row) {}

NotPositiveDefinite::NotPositiveDefinite(std::size_t row, double pivot)
    : std::runtime_error(fmt::format("matrix is not positive definite: pivot {:.6g} in row {}", pivot, row)),
      row_(row) {}

namespace {

void require_shape(TridiagonalMatrix a, std::size_t least_rows, std::size_t couplings) {
  require_that(a.diagonal.size() >= least_rows, "rows = {}; allowed: at least {}", a.diagonal.size(), least_rows);
  require_that(a.off_diagonal.size() >= couplings, "off_diagonal has {} entries; needed: {}", a.off_diagonal.size(),
               couplings);
}

}  // namespace

void TwoEndedTridiagonal::eliminate(TridiagonalMatrix a) {
  const std::size_t n = a.diagonal.size();
  inverse_pivot_.resize(n);
  multiplier_.resize(n - 1);
  const std::size_t middle = n / 2;
  double* const pivot = inverse_pivot_.data();
  double* const multiplier = multiplier_.data();
  const double* const d = a.diagonal.data();
  const double* const e = a.off_diagonal.data();
  // Rows k and n - 1 - k: two independent chains of divisions, which the processor overlaps.
  double top = 0;
  double bottom = 0;
  for (std::size_t k = 0; k < middle; ++k) {
    const double e_top = k > 0 ? e[k - 1] : 0;
    if (k > 0) multiplier[k - 1] = e_top * top;
    pivot[k] = top = 1 / (d[k] - (e_top * e_top) * top);
    const std::size_t j = n - 1 - k;
    if (j == middle) break;
    const double e_bottom = k > 0 ? e[j] : 0;
    if (k > 0) multiplier[j] = e_bottom * bottom;
    pivot[j] = bottom = 1 / (d[j] - (e_bottom * e_bottom) * bottom);
  }
  double rest = d[middle];
  const auto join = [&](std::size_t pair, double inverse) {
    multiplier[pair] = e[pair] * inverse;
    rest -= e[pair] * multiplier[pair];
  };
  if (middle > 0) join(middle - 1, top);
  if (middle + 1 < n) join(middle, bottom);
  pivot[middle] = 1 / rest;
  // Inverse pivots are stored, so that failure is looked for only now.
  const auto bad = std::find_if_not(inverse_pivot_.begin(), inverse_pivot_.end(), [](double r) { return r > 0; });
  if (bad != inverse_pivot_.end()) {
    throw NotPositiveDefinite(static_cast<std::size_t>(bad - inverse_pivot_.begin()), 1 / *bad);
  }
}

void TwoEndedTridiagonal::substitute(std::span<const double> right_hand_side, std::span<double> x) const {
  const std::size_t n = inverse_pivot_.size();
  const std::size_t middle = n / 2;
  const double* const b = right_hand_side.data();
  double* const out = x.data();
  const double* const pivot = inverse_pivot_.data();
  const double* const multiplier = multiplier_.data();
  double top = 0;
  double bottom = 0;
  for (std::size_t k = 0; k < middle; ++k) {
    out[k] = top = b[k] - (k > 0 ? multiplier[k - 1] * top : 0);
    const std::size_t j = n - 1 - k;
    if (j == middle) break;
    out[j] = bottom = b[j] - (k > 0 ? multiplier[j] * bottom : 0);
  }
  double z = b[middle];
  if (middle > 0) z -= multiplier[middle - 1] * top;
  if (middle + 1 < n) z -= multiplier[middle] * bottom;
  out[middle] = top = bottom = z * pivot[middle];
  for (std::size_t k = 1; k <= middle; ++k) {
    const std::size_t i = middle - k;
    const std::size_t j = middle + k;
    out[i] = top = out[i] * pivot[i] - multiplier[i] * top;
    if (j < n) out[j] = bottom = out[j] * pivot[j] - multiplier[j - 1] * bottom;
  }
}

void TwoEndedTridiagonal::factor(TridiagonalMatrix a, bool ring) {
  const std::size_t n = a.diagonal.size();
  require_shape(a, ring ? 3 : 1, ring ? n : n - 1);
  border_.assign(ring ? n - 1 : 0, 0.0);
  if (!ring) return eliminate(a);
  eliminate({a.diagonal.first(n - 1), a.off_diagonal});
  first_ = a.off_diagonal[n - 1];
  last_ = a.off_diagonal[n - 2];
  border_.front() += first_;
  border_.back() += last_;
  substitute(border_, border_);
  const double schur = a.diagonal[n - 1] - first_ * border_.front() - last_ * border_.back();
  if (!(schur > 0)) throw NotPositiveDefinite(n - 1, schur);
  inverse_schur_ = 1 / schur;
}

void TwoEndedTridiagonal::solve(std::span<const double> right_hand_side, std::span<double> x) const {
  if (border_.empty()) return substitute(right_hand_side, x);
  const std::size_t n = size();
  const double b = right_hand_side[n - 1];
  substitute(right_hand_side.first(n - 1), x.first(n - 1));
  const double z = (b - first_ * x[0] - last_ * x[n - 2]) * inverse_schur_;
  for (std::size_t i = 0; i + 1 < n; ++i) x[i] -= border_[i] * z;
  x[n - 1] = z;
}

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
