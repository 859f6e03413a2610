#include "seiche/exact/overturning/surface_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/linear/fourier.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"

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

namespace {

constexpr std::size_t nodes_per_marker = 16;

/// Largest value of periodic samples, by the parabola through the largest three.
template <class Value>
double maximum(std::size_t n, const Value& value) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (value(i) > value(largest)) largest = i;
  }
  const double middle = value(largest);
  const double before = value((largest + n - 1) % n) - middle;
  const double after = value((largest + 1) % n) - middle;
  const double curvature = before + after;
  return curvature < 0 ? middle - (after - before) * (after - before) / (8 * curvature) : middle;
}

}  // namespace

SurfaceCurve::SurfaceCurve(std::span<const Complex> displacements)
    : periodic_((require_at_least("points", static_cast<long>(displacements.size()), 8), displacements)),
      tangent_(periodic_.derivative()),
      nodes_(periodic_.refined(nodes_per_marker)),
      tangents_(tangent_.refined(nodes_per_marker)) {
  for (Complex& z_s : tangents_) z_s += 1;
}

std::vector<double> SurfaceCurve::labels_at_equal_arc_length(std::size_t points) const {
  require_at_least("points", static_cast<long>(points), 2);
  const std::size_t n = tangents_.size();
  std::vector<Complex> speed(n);
  std::ranges::transform(tangents_, speed.begin(), [](Complex z_s) { return std::abs(z_s); });
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

Complex SurfaceCurve::node(std::size_t i) const {
  const std::size_t n = nodes_.size();
  return nodes_[i % n] + label(i, n);
}

double SurfaceCurve::least_advance() const {
  return -maximum(tangents_.size(), [&](std::size_t i) { return -tangents_[i].real(); });
}

double SurfaceCurve::largest_curvature() const {
  const auto second = tangent_.derivative().refined(nodes_per_marker);
  return maximum(tangents_.size(), [&](std::size_t i) {
    return std::abs((std::conj(tangents_[i]) * second[i]).imag()) / std::pow(std::abs(tangents_[i]), 3);
  });
}

double SurfaceCurve::highest() const {
  return maximum(nodes_.size(), [&](std::size_t i) { return nodes_[i].imag(); });
}

double SurfaceCurve::lowest() const {
  return -maximum(nodes_.size(), [&](std::size_t i) { return -nodes_[i].imag(); });
}

double SurfaceCurve::label_of_vertical_tangent(std::size_t i) const {
  const std::size_t n = tangents_.size();
  const double a = tangents_[i % n].real();
  const double b = tangents_[(i + 1) % n].real();
  return label(i, n) + label(1, n) * a / (a - b);
}

std::optional<SurfaceCurve::Overhang> SurfaceCurve::overhang() const {
  const std::size_t n = tangents_.size();
  const auto recedes = [&](std::size_t i) { return tangents_[i % n].real() < 0; };
  std::optional<Overhang> widest;
  for (std::size_t i = 0; i < n; ++i) {
    if (recedes(i) || !recedes(i + 1)) continue;
    std::size_t end = i + 1;
    while (recedes(end + 1)) ++end;
    const Complex nose = point(label_of_vertical_tangent(i));
    const Complex throat = point(label_of_vertical_tangent(end));
    const double width = nose.real() - throat.real();
    if (!widest || width > widest->nose.real() - widest->throat.real()) widest = {nose, throat, gap(i, end)};
  }
  return widest;
}

double SurfaceCurve::gap(std::size_t nose, std::size_t throat) const {
  const std::size_t n = nodes_.size();
  const double middle = 0.5 * (node(nose).real() + node(throat).real());
  double least = std::numeric_limits<double>::infinity();
  // Upper side of the jet down to half its length, and its lower side; water ahead as far as one jet length.
  std::size_t first = nose;
  while (nose - first < n / 4 && first > 0 && node(first - 1).real() > middle) --first;
  for (std::size_t i = first; i < throat && node(i).real() > middle; i += 2) {
    for (std::size_t j = throat; j < throat + n / 2; j += 2) least = std::min(least, std::norm(node(j) - node(i)));
  }
  return std::sqrt(least);
}

double SurfaceCurve::distance(Complex place) const {
  const auto apart = [&](Complex z) {
    const Complex d = z - place;
    return Complex(d.real() - 2 * std::numbers::pi * std::round(d.real() / (2 * std::numbers::pi)), d.imag());
  };
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (const double d = std::norm(apart(node(i))); d < least) {
      least = d;
      nearest = i;
    }
  }
  // Gauss and Newton's iteration for the foot point: curves as close as these need no second derivative.
  double s = label(nearest, nodes_.size());
  for (int i = 0; i < 4; ++i) {
    const Complex z_s = 1.0 + tangent_(s);
    s -= (std::conj(z_s) * apart(point(s))).real() / std::norm(z_s);
  }
  return std::sqrt(std::min(least, std::norm(apart(point(s)))));
}

double SurfaceCurve::distance(const SurfaceCurve& other) const {
  constexpr std::size_t stride = 4;
  Largest largest;
  for (std::size_t i = 0; i < nodes_.size(); i += stride) largest.add(other.distance(node(i)));
  for (std::size_t i = 0; i < other.nodes_.size(); i += stride) largest.add(distance(other.node(i)));
  return largest.value();
}

}  // namespace seiche::exact::overturning
