#include "seiche/exact/overturning/interpolant.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seiche/linear/fourier.hpp"
#include "seiche/require.hpp"

namespace seiche::exact::overturning {
namespace {

using Complex = std::complex<double>;

}  // namespace

TrigonometricInterpolant::TrigonometricInterpolant(std::span<const Complex> samples)
    : coefficients_(samples.size()), lowest_(-static_cast<long>((samples.size() - 1) / 2)) {
  linear::Fourier fourier(samples.size());
  fourier.coefficients(samples, coefficients_);
  std::ranges::rotate(coefficients_, coefficients_.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2 + 1));
  // The sawtooth has no derivative at its samples and no values in between.
  if (samples.size() % 2 == 0) coefficients_.back() = 0;
}

Complex TrigonometricInterpolant::operator()(double s) const {
  const Complex step(std::cos(s), std::sin(s));
  Complex sum = 0;
  for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) sum = sum * step + *c;
  const double first = static_cast<double>(lowest_) * s;
  return sum * Complex(std::cos(first), std::sin(first));
}

TrigonometricInterpolant TrigonometricInterpolant::derivative() const {
  TrigonometricInterpolant result = *this;
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    result.coefficients_[i] *= Complex(0, static_cast<double>(lowest_ + static_cast<long>(i)));
  }
  return result;
}

std::vector<Complex> TrigonometricInterpolant::refined(std::size_t refinement) const {
  const std::size_t n = coefficients_.size() * refinement;
  std::vector<Complex> values(n);
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    const long k = lowest_ + static_cast<long>(i);
    values[k >= 0 ? static_cast<std::size_t>(k) : n - static_cast<std::size_t>(-k)] = coefficients_[i];
  }
  linear::Fourier(n).samples(values, values);
  return values;
}

std::vector<double> labels_at_equal_arc_length(std::span<const Complex> tangent, std::size_t points) {
  require_at_least("points", static_cast<long>(points), 2);
  const std::size_t n = tangent.size();
  std::vector<Complex> speed(n);
  std::ranges::transform(tangent, speed.begin(), [](Complex z_s) { return std::abs(z_s); });
  // Integral of the trigonometric interpolant of |z_s|, 0 at s = 0.
  linear::Fourier fourier(n);
  std::vector<Complex> arc(n);
  fourier.coefficients(speed, arc);
  const double mean = arc[0].real();
  arc[0] = 0;
  for (std::size_t i = 1; i < n; ++i) arc[i] = fourier.is_sawtooth(i) ? 0 : arc[i] / Complex(0, fourier.wavenumber(i));
  fourier.samples(arc, arc);
  const double start = arc[0].real();
  const double width = 2 * std::numbers::pi / static_cast<double>(n);
  std::vector<double> labels(points);
  std::size_t j = 0;
  const auto length_at = [&](std::size_t i) {
    return i == n ? 2 * std::numbers::pi * mean : mean * width * static_cast<double>(i) + arc[i].real() - start;
  };
  for (std::size_t p = 0; p + 1 < points; ++p) {
    const double wanted = 2 * std::numbers::pi * mean * static_cast<double>(p) / static_cast<double>(points - 1);
    while (j + 1 < n && length_at(j + 1) <= wanted) ++j;
    // Inverse function between two nodes: cubic in the length, with slopes 1/|z_s|.
    const double a = length_at(j);
    const double span = length_at(j + 1) - a;
    const double u = (wanted - a) / span;
    const double slope_a = span / (speed[j].real() * width);
    const double slope_b = span / (speed[(j + 1) % n].real() * width);
    const double value = u * u * (3 - 2 * u) + u * (1 - u) * ((1 - u) * slope_a - u * slope_b);
    labels[p] = width * (static_cast<double>(j) + value);
  }
  labels.back() = 2 * std::numbers::pi;
  return labels;
}

}  // namespace seiche::exact::overturning
