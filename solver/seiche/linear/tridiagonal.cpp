#include "seiche/linear/tridiagonal.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace seiche::linear {

NotPositiveDefinite::NotPositiveDefinite(std::size_t row)
    : std::runtime_error(fmt::format("matrix is not positive definite: row {}", row)), row_(row) {}

NotPositiveDefinite::NotPositiveDefinite(std::size_t row, double pivot)
    : std::runtime_error(fmt::format("matrix is not positive definite: pivot {:.6g} in row {}", pivot, row)),
      row_(row) {}

namespace {

void require_shape(TridiagonalMatrix a, std::size_t least_rows, std::size_t couplings) {
  if (a.diagonal.size() < least_rows) {
    throw std::invalid_argument(fmt::format("rows = {}; allowed: at least {}", a.diagonal.size(), least_rows));
  }
  if (a.off_diagonal.size() < couplings) {
    throw std::invalid_argument(
        fmt::format("off_diagonal has {} entries; needed: {}", a.off_diagonal.size(), couplings));
  }
}

/// Inverse pivots are stored, so that failure is looked for only after the elimination.
void require_positive_pivots(const std::vector<double>& inverse_pivot) {
  const auto bad = std::find_if_not(inverse_pivot.begin(), inverse_pivot.end(), [](double r) { return r > 0; });
  if (bad != inverse_pivot.end()) {
    throw NotPositiveDefinite(static_cast<std::size_t>(bad - inverse_pivot.begin()), 1 / *bad);
  }
}

}  // namespace

void Tridiagonal::factor(TridiagonalMatrix a) {
  const std::size_t n = a.diagonal.size();
  require_shape(a, 1, n - 1);
  inverse_pivot_.resize(n);
  multiplier_.resize(n - 1);
  double inverse = 1 / a.diagonal[0];
  bool positive = inverse > 0;
  inverse_pivot_[0] = inverse;
  for (std::size_t i = 1; i < n; ++i) {
    const double e = a.off_diagonal[i - 1];
    multiplier_[i - 1] = e * inverse;
    inverse = 1 / (a.diagonal[i] - (e * e) * inverse);
    inverse_pivot_[i] = inverse;
    positive &= inverse > 0;
  }
  if (!positive) require_positive_pivots(inverse_pivot_);
}

void Tridiagonal::solve(std::span<const double> right_hand_side, std::span<double> x) const {
  const std::size_t n = size();
  double z = right_hand_side[0];
  x[0] = z;
  for (std::size_t i = 1; i < n; ++i) {
    z = right_hand_side[i] - multiplier_[i - 1] * z;
    x[i] = z;
  }
  z = x[n - 1] * inverse_pivot_[n - 1];
  x[n - 1] = z;
  for (std::size_t i = n - 1; i-- > 0;) {
    z = x[i] * inverse_pivot_[i] - multiplier_[i] * z;
    x[i] = z;
  }
}

void TwoEndedTridiagonal::factor(TridiagonalMatrix a) {
  const std::size_t n = a.diagonal.size();
  require_shape(a, 1, n - 1);
  inverse_pivot_.resize(n);
  multiplier_.resize(n - 1);
  const std::size_t middle = n / 2;          // rows 0..middle-1 from above, n-1..middle+1 from below
  const std::size_t below = n - 1 - middle;  // middle or middle - 1
  double top = 0;
  double bottom = 0;
  double* const pivot = inverse_pivot_.data();
  double* const multiplier = multiplier_.data();
  const double* const d = a.diagonal.data();
  const double* const e = a.off_diagonal.data();
  if (middle > 0) pivot[0] = top = 1 / d[0];
  if (below > 0) pivot[n - 1] = bottom = 1 / d[n - 1];
  for (std::size_t k = 1; k < below; ++k) {
    const double e_top = e[k - 1];
    const double e_bottom = e[n - 1 - k];
    multiplier[k - 1] = e_top * top;
    multiplier[n - 1 - k] = e_bottom * bottom;
    top = 1 / (d[k] - (e_top * e_top) * top);
    bottom = 1 / (d[n - 1 - k] - (e_bottom * e_bottom) * bottom);
    pivot[k] = top;
    pivot[n - 1 - k] = bottom;
  }
  for (std::size_t k = std::max<std::size_t>(below, 1); k < middle; ++k) {
    multiplier[k - 1] = e[k - 1] * top;
    pivot[k] = top = 1 / (d[k] - (e[k - 1] * e[k - 1]) * top);
  }
  double rest = d[middle];
  if (middle > 0) {
    multiplier[middle - 1] = e[middle - 1] * top;
    rest -= e[middle - 1] * multiplier[middle - 1];
  }
  if (below > 0) {
    multiplier[middle] = e[middle] * bottom;
    rest -= e[middle] * multiplier[middle];
  }
  pivot[middle] = 1 / rest;
  if (!std::all_of(inverse_pivot_.begin(), inverse_pivot_.end(), [](double r) { return r > 0; })) {
    require_positive_pivots(inverse_pivot_);
  }
}

void TwoEndedTridiagonal::solve(std::span<const double> right_hand_side, std::span<double> x) const {
  const std::size_t n = size();
  const std::size_t middle = n / 2;
  const std::size_t below = n - 1 - middle;
  const double* const b = right_hand_side.data();
  double* const out = x.data();
  const double* const pivot = inverse_pivot_.data();
  const double* const multiplier = multiplier_.data();
  const double centre = b[middle];
  double top = 0;
  double bottom = 0;
  if (middle > 0) out[0] = top = b[0];
  if (below > 0) out[n - 1] = bottom = b[n - 1];
  for (std::size_t k = 1; k < below; ++k) {
    out[k] = top = b[k] - multiplier[k - 1] * top;
    out[n - 1 - k] = bottom = b[n - 1 - k] - multiplier[n - 1 - k] * bottom;
  }
  for (std::size_t k = std::max<std::size_t>(below, 1); k < middle; ++k) {
    out[k] = top = b[k] - multiplier[k - 1] * top;
  }
  double z = centre;
  if (middle > 0) z -= multiplier[middle - 1] * top;
  if (below > 0) z -= multiplier[middle] * bottom;
  z *= pivot[middle];
  out[middle] = top = bottom = z;
  for (std::size_t k = 1; k <= below; ++k) {
    const std::size_t i = middle - k;
    const std::size_t j = middle + k;
    out[i] = top = out[i] * pivot[i] - multiplier[i] * top;
    out[j] = bottom = out[j] * pivot[j] - multiplier[j - 1] * bottom;
  }
  if (middle > below) out[0] = out[0] * pivot[0] - multiplier[0] * top;
}

void PeriodicTridiagonal::factor(TridiagonalMatrix a) {
  const std::size_t n = a.diagonal.size();
  require_shape(a, 3, n);
  inner_.factor({a.diagonal.first(n - 1), a.off_diagonal.first(n - 2)});
  border_.assign(n - 1, 0.0);
  const double first = a.off_diagonal[n - 1];
  const double last = a.off_diagonal[n - 2];
  border_.front() += first;
  border_.back() += last;
  inner_.solve(border_, border_);
  const double schur = a.diagonal[n - 1] - first * border_.front() - last * border_.back();
  if (!(schur > 0)) throw NotPositiveDefinite(n - 1, schur);
  inverse_schur_ = 1 / schur;
  first_ = first;
  last_ = last;
}

void PeriodicTridiagonal::solve(std::span<const double> right_hand_side, std::span<double> x) const {
  const std::size_t n = size();
  const double b = right_hand_side[n - 1];
  inner_.solve(right_hand_side.first(n - 1), x.first(n - 1));
  const double z = (b - first_ * x[0] - last_ * x[n - 2]) * inverse_schur_;
  for (std::size_t i = 0; i + 1 < n; ++i) x[i] -= border_[i] * z;
  x[n - 1] = z;
}

}  // namespace seiche::linear
