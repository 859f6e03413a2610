#include "validation/instruments/particles/sph_steep_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/QR>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {
namespace {

constexpr long modes = 24;
constexpr long points = 8 * modes;

/// cosh n(y + h)/cosh(n h), without overflow.
double mode(double n, double y, double h) {
  return std::exp(n * y) * (1 + std::exp(-2 * n * (y + h))) / (1 + std::exp(-2 * n * h));
}

}  // namespace

SteepWaveStart::SteepWaveStart(double amplitude, double wavelength, double depth, double gravity)
    : amplitude_(amplitude),
      wavelength_(wavelength),
      depth_(depth),
      gravity_(gravity),
      k_(2 * std::numbers::pi / wavelength),
      a_(k_ * amplitude),
      h_(k_ * depth),
      w_(std::sqrt(std::tanh(h_))) {
  require_positive("amplitude", amplitude);
  require_positive("wavelength", wavelength);
  require_positive("gravity", gravity);
  require_within("k amplitude", a_, 0, 0.448);
  require_within("amplitude/depth", amplitude / depth, 0, 1);
  Eigen::MatrixXd matrix(points, modes);
  Eigen::VectorXd right(points);
  for (long i = 0; i < points; ++i) {
    const double x = std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(points);
    const double y = a_ * std::cos(x);
    for (long n = 0; n < modes; ++n)
      matrix(i, n) = mode(static_cast<double>(n), y, h_) * std::cos(static_cast<double>(n) * x);
    right(i) = scaled_pressure(x, y);
  }
  // Columns grow like exp(n a): scaled to equal length before they are made orthogonal.
  const Eigen::VectorXd scale = matrix.colwise().norm().transpose();
  const Eigen::MatrixXd scaled = matrix * scale.cwiseInverse().asDiagonal();
  Eigen::VectorXd solution = scaled.colPivHouseholderQr().solve(right);
  solution.array() /= scale.array();
  rate_.assign(solution.begin(), solution.end());
}

std::array<double, 2> SteepWaveStart::velocity(double x, double y) const {
  const double scale = std::sqrt(gravity_ / k_) * a_ / w_ / std::cosh(h_);
  return {scale * std::cosh(k_ * y + h_) * std::cos(k_ * x), scale * std::sinh(k_ * y + h_) * std::sin(k_ * x)};
}

double SteepWaveStart::scaled_pressure(double x, double y) const {
  const double scale = a_ / w_ / std::cosh(h_);
  const double u = scale * std::cosh(y + h_) * std::cos(x);
  const double v = scale * std::sinh(y + h_) * std::sin(x);
  double rate = 0;
  for (std::size_t n = 0; n < rate_.size(); ++n) {
    rate += rate_[n] * mode(static_cast<double>(n), y, h_) * std::cos(static_cast<double>(n) * x);
  }
  return -(rate + 0.5 * (u * u + v * v) + y);
}

double SteepWaveStart::pressure_over_density(double x, double y) const {
  const double inside = std::max(y, -depth_);
  return gravity_ / k_ * scaled_pressure(k_ * x, k_ * inside) + gravity_ * (inside - y);
}

double SteepWaveStart::surface_defect() const {
  Worst pressure;
  for (long i = 0; i <= points; ++i) {
    const double x = std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    pressure.add(scaled_pressure(x, a_ * std::cos(x)), x);
  }
  return pressure.value() / a_;
}

}  // namespace seiche::validation
