#include "seiche/exact/overturning/curve_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "seiche/exact/overturning/interpolant.hpp"
#include "seiche/require.hpp"

namespace seiche::exact::overturning {
namespace {

using Complex = std::complex<double>;

/// Distance from the origin to the cubic with ends a, b and end slopes s, t, by Newton's iteration for the foot point.
double distance_to_cubic(Complex a, Complex b, Complex s, Complex t) {
  const Complex c2 = 3.0 * (b - a) - 2.0 * s - t;
  const Complex c3 = 2.0 * (a - b) + s + t;
  double u = std::clamp(-(std::conj(b - a) * a).real() / std::norm(b - a), 0.0, 1.0);
  for (int i = 0; i < 5; ++i) {
    const Complex z = a + u * (s + u * (c2 + u * c3));
    const Complex z1 = s + u * (2.0 * c2 + 3.0 * u * c3);
    const Complex z2 = 2.0 * c2 + 6.0 * u * c3;
    const double slope = (std::conj(z1) * z).real();
    const double curvature = std::norm(z1) + (std::conj(z2) * z).real();
    u = std::clamp(u - slope / (curvature > 0 ? curvature : std::norm(z1)), 0.0, 1.0);
  }
  return std::abs(a + u * (s + u * (c2 + u * c3)));
}

}  // namespace

PeriodicCurve::PeriodicCurve(std::span<const Complex> points, double period, std::size_t refinement) : period_(period) {
  require_at_least("points", static_cast<long>(points.size()), 8);
  require_at_least("refinement", static_cast<long>(refinement), 1);
  require_positive("period", period);
  const std::size_t n = points.size();
  std::vector<Complex> periodic(n);
  for (std::size_t j = 0; j < n; ++j)
    periodic[j] = points[j] - period * static_cast<double>(j) / static_cast<double>(n);
  const TrigonometricInterpolant curve(periodic);
  nodes_ = curve.refined(refinement);
  tangents_ = curve.derivative().refined(refinement);
  const auto m = static_cast<double>(nodes_.size());
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    nodes_[j] += period * static_cast<double>(j) / m;
    tangents_[j] = tangents_[j] * (2 * std::numbers::pi / m) + period / m;
  }
}

double PeriodicCurve::distance(Complex point) const {
  const Complex p = point - period_ * std::round((point.real() - nodes_[nodes_.size() / 2].real()) / period_);
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    double dx = std::abs(nodes_[j].real() - p.real());
    dx = std::min(dx, std::abs(period_ - dx));
    const double dy = nodes_[j].imag() - p.imag();
    const double d2 = dx * dx + dy * dy;
    if (d2 < least) {
      least = d2;
      nearest = j;
    }
  }
  const auto relative = [&](long j) {
    const auto m = static_cast<long>(nodes_.size());
    const long wrapped = (j + m) % m;
    const long turns = (j - wrapped) / m;
    const Complex z = nodes_[static_cast<std::size_t>(wrapped)] - p + period_ * static_cast<double>(turns);
    return std::pair{z, tangents_[static_cast<std::size_t>(wrapped)]};
  };
  const auto [centre, slope] = relative(static_cast<long>(nearest));
  const double shift = period_ * std::round(centre.real() / period_);
  double result = std::abs(centre - shift);
  for (const long side : {-1L, 1L}) {
    const auto [end, end_slope] = relative(static_cast<long>(nearest) + side);
    const auto sign = static_cast<double>(side);
    result = std::min(result, distance_to_cubic(centre - shift, end - shift, sign * slope, sign * end_slope));
  }
  return result;
}

double hausdorff_distance(const PeriodicCurve& a, const PeriodicCurve& b, std::size_t stride) {
  double largest = 0;
  for (std::size_t j = 0; j < a.nodes().size(); j += stride) largest = std::max(largest, b.distance(a.nodes()[j]));
  for (std::size_t j = 0; j < b.nodes().size(); j += stride) largest = std::max(largest, a.distance(b.nodes()[j]));
  return largest;
}

}  // namespace seiche::exact::overturning
