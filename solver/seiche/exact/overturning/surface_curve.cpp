#include "seiche/exact/overturning/surface_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche::exact::overturning {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t nodes_per_marker = 16;

TrigonometricInterpolant interpolant(SurfaceView<const double> surface) {
  std::vector<Complex> periodic(surface.size());
  for (std::size_t j = 0; j < surface.size(); ++j) periodic[j] = {surface.displacement[j], surface.y[j]};
  return TrigonometricInterpolant(periodic);
}

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

SurfaceCurve::SurfaceCurve(SurfaceView<const double> surface)
    : periodic_(interpolant(surface)),
      nodes_(periodic_.refined(nodes_per_marker)),
      tangents_(periodic_.derivative().refined(nodes_per_marker)) {
  for (Complex& z_s : tangents_) z_s += 1;
}

Complex SurfaceCurve::node(std::size_t i) const {
  const std::size_t n = nodes_.size();
  return nodes_[i % n] + label(i, n);
}

double SurfaceCurve::least_advance() const {
  return -maximum(tangents_.size(), [&](std::size_t i) { return -tangents_[i].real(); });
}

double SurfaceCurve::largest_curvature() const {
  const auto second = periodic_.derivative().derivative().refined(nodes_per_marker);
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

}  // namespace seiche::exact::overturning
