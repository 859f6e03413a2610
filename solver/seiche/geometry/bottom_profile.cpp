#include "seiche/geometry/bottom_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/geometry/gauss_mean.hpp"
#include "seiche/require.hpp"
#include "seiche/require_that.hpp"

namespace seiche {

namespace {

[[noreturn]] void throw_outside(double x, double begin, double end) {
  throw Infeasible(x, "x = {:.6g} is outside the bottom profile [{:.6g}, {:.6g}]", x, begin, end);
}

}  // namespace

double BottomProfile::elevation(double x) const {
  std::array<double, 1> b{}, s{};
  sample(std::array{x}, b, s);
  return b[0];
}

double BottomProfile::slope(double x) const {
  std::array<double, 1> b{}, s{};
  sample(std::array{x}, b, s);
  return s[0];
}

LevelBottom::LevelBottom(double depth) : elevation_(-depth) {
  require_positive("depth", depth);
}

void LevelBottom::sample(std::span<const double>, std::span<double> elevation, std::span<double> slope) const {
  std::ranges::fill(elevation, elevation_);
  std::ranges::fill(slope, 0.0);
}

PiecewiseLinearBottom::PiecewiseLinearBottom(std::vector<double> x, std::vector<double> elevation)
    : x_(std::move(x)), b_(std::move(elevation)) {
  require_that(x_.size() >= 2 && x_.size() == b_.size(),
               "bottom: {} places and {} elevations; needed: at least 2 of each, as many of one as of the other",
               x_.size(), b_.size());
  for (std::size_t k = 0; k < x_.size(); ++k) {
    require_finite(fmt::format("bottom x[{}]", k), x_[k]);
    require_finite(fmt::format("bottom elevation[{}]", k), b_[k]);
  }
  for (std::size_t k = 1; k < x_.size(); ++k) {
    require_that(x_[k] > x_[k - 1], "bottom x[{}] = {:.17g}; allowed: above x[{}] = {:.17g}", k, x_[k], k - 1,
                 x_[k - 1]);
    slope_.push_back((b_[k] - b_[k - 1]) / (x_[k] - x_[k - 1]));
  }
}

std::size_t PiecewiseLinearBottom::piece(double x) const {
  if (!(x >= x_.front() && x <= x_.back())) throw_outside(x, x_.front(), x_.back());
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  return static_cast<std::size_t>(above - x_.begin()) - 1;
}

void PiecewiseLinearBottom::sample(std::span<const double> x, std::span<double> elevation,
                                   std::span<double> slope) const {
  for (std::size_t i = 0; i < x.size();) {
    const std::size_t k = piece(x[i]);
    const bool last = k + 1 == slope_.size();
    const double reach = x_[k + 1];
    std::size_t stop = i + 1;
    while (stop < x.size() && x[stop] >= x_[k] && (x[stop] < reach || (last && x[stop] <= reach))) ++stop;
    for (; i < stop; ++i) {
      elevation[i] = on_piece(k, x[i]);
      slope[i] = slope_[k];
    }
  }
}

template <class Integrand>
double PiecewiseLinearBottom::mean_of(double from, double to, const Integrand& integrand) const {
  const std::size_t piece_from = piece(from);
  const std::size_t piece_to = piece(to);
  const double left = std::min(from, to);
  const double right = std::max(from, to);
  const std::size_t first = std::min(piece_from, piece_to);
  const std::size_t last = std::max(piece_from, piece_to);
  if (first == last) return integrand(on_piece(first, left), on_piece(first, right));
  double sum = 0;
  for (std::size_t k = first; k <= last; ++k) {
    const double a = std::max(left, x_[k]);
    const double b = std::min(right, x_[k + 1]);
    sum += (b - a) * integrand(on_piece(k, a), on_piece(k, b));
  }
  return sum / (right - left);
}

double PiecewiseLinearBottom::mean(double from, double to) const {
  return mean_of(from, to, [](double a, double b) { return 0.5 * (a + b); });
}

double PiecewiseLinearBottom::mean_square(double from, double to) const {
  return mean_of(from, to, [](double a, double b) { return (a * a + a * b + b * b) / 3; });
}

std::optional<double> PiecewiseLinearBottom::uniform_slope(double from, double to) const {
  const std::size_t k = piece(from);
  if (k == piece(to)) return slope_[k];
  return std::nullopt;
}

SmoothBottom::SmoothBottom(std::function<double(double)> elevation, std::function<double(double)> slope, double begin,
                           double end)
    : elevation_(std::move(elevation)), slope_(std::move(slope)), begin_(begin), end_(end) {
  require_that(elevation_ && slope_, "bottom: elevation and slope must both be given");
  require_that(begin < end, "bottom: begin = {}; allowed: below end = {}", begin, end);
}

void SmoothBottom::sample(std::span<const double> x, std::span<double> elevation, std::span<double> slope) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    require_inside(x[i], x[i]);
    elevation[i] = elevation_(x[i]);
    slope[i] = slope_(x[i]);
  }
}

std::optional<double> SmoothBottom::uniform_slope(double from, double to) const {
  require_inside(from, to);
  return std::nullopt;
}

void SmoothBottom::require_inside(double from, double to) const {
  for (const double x : {from, to}) {
    if (!(x >= begin_ && x <= end_)) throw_outside(x, begin_, end_);
  }
}

double SmoothBottom::mean(double from, double to) const {
  require_inside(from, to);
  return gauss_mean(elevation_, from, to);
}

double SmoothBottom::mean_square(double from, double to) const {
  require_inside(from, to);
  return gauss_mean([this](double x) { return elevation_(x) * elevation_(x); }, from, to);
}

void Bed::validate(double start, double end) const {
  require_that(elevation && primitive, "bed: elevation and primitive must both be given");
  constexpr int samples = 257;
  // Step of a central difference that balances truncation and round-off: eps^(1/3) of the length.
  const double step = 6e-6 * (end - start);
  const auto sample = [&](int k) { return start + (end - start) * (k + 0.5) / samples; };
  double lowest = 0;
  double highest = 0;
  for (int k = 0; k < samples; ++k) {
    lowest = std::min(lowest, elevation(sample(k)));
    highest = std::max(highest, elevation(sample(k)));
  }
  for (int k = 0; k < samples; ++k) {
    const double x = sample(k);
    const double z = elevation(x);
    const double slope = (primitive(x + step) - primitive(x - step)) / (2 * step);
    require_that(std::isfinite(z) && std::abs(slope - z) <= 1e-6 * (highest - lowest),
                 "bed: derivative of the primitive at x = {:g} is {:.9g}, must equal the elevation {:.9g}", x, slope,
                 z);
  }
}

}  // namespace seiche
