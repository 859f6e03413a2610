/// Velocity and pressure inside the steep wave that exact::OverturningWave starts from.
///
/// The surface is eta = A cos kx with the potential of the linear wave there. That potential is harmonic and has no
/// flow through the bottom, so it is the potential everywhere, however steep the wave:
///
///     phi = (A/w) cosh(y + h)/cosh(h) sin x,   w = sqrt(tanh h)                        units of 1/k and sqrt(1/(g k)).
///
/// The pressure is p = -(phi_t + |grad phi|^2/2 + y), phi_t harmonic without flow through the bottom and such that p =
/// 0 at the surface: phi_t = sum a_n cosh n(y + h)/cosh(n h) cos nx, the a_n by least squares at points of the surface.
/// For A <= 0.448 the series converges up to the surface (Rayleigh's hypothesis).
///
/// When not to use it: later times; A > 0.448.
///
/// References: Longuet-Higgins and Cokelet, Proc. R. Soc. Lond. A 350 (1976) 1; Millar, The Rayleigh hypothesis
/// and a related least-squares solution to scattering problems for periodic surfaces, Radio Sci. 8 (1973) 785.
#pragma once

#include <cmath>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include <Eigen/QR>

#include "seiche/require.hpp"
#include "seiche/samples.hpp"

namespace seiche::validation {

class SteepWaveStart {
 public:
  /// Lengths [m]; throws std::invalid_argument unless 0 < amplitude < depth and k amplitude <= 0.448.
  SteepWaveStart(double amplitude, double wavelength, double depth, double gravity)
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

  /// Elevation [m] above the level at rest.
  [[nodiscard]] double elevation(double x) const { return amplitude_ * std::cos(k_ * x); }
  /// (u, v) [m/s], y from the level at rest.
  [[nodiscard]] std::array<double, 2> velocity(double x, double y) const {
    const double scale = std::sqrt(gravity_ / k_) * a_ / w_ / std::cosh(h_);
    return {scale * std::cosh(k_ * y + h_) * std::cos(k_ * x), scale * std::sinh(k_ * y + h_) * std::sin(k_ * x)};
  }
  /// p/rho [m^2/s^2]; below the bottom that of the bottom and the weight of still water.
  [[nodiscard]] double pressure_over_density(double x, double y) const {
    const double inside = std::max(y, -depth_);
    return gravity_ / k_ * scaled_pressure(k_ * x, k_ * inside) + gravity_ * (inside - y);
  }
  /// Largest |p/rho| at the surface between the points where it was made zero, over g times the amplitude.
  [[nodiscard]] double surface_defect() const {
    Worst pressure;
    for (long i = 0; i <= points; ++i) {
      const double x = std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
      pressure.add(scaled_pressure(x, a_ * std::cos(x)), x);
    }
    return pressure.value() / a_;
  }
  [[nodiscard]] double wavelength() const { return wavelength_; }
  [[nodiscard]] double depth() const { return depth_; }

 private:
  static constexpr long modes = 24;
  static constexpr long points = 8 * modes;

  /// cosh n(y + h)/cosh(n h), without overflow.
  static double mode(double n, double y, double h) {
    return std::exp(n * y) * (1 + std::exp(-2 * n * (y + h))) / (1 + std::exp(-2 * n * h));
  }
  [[nodiscard]] double scaled_pressure(double x, double y) const {
    const double scale = a_ / w_ / std::cosh(h_);
    const double u = scale * std::cosh(y + h_) * std::cos(x);
    const double v = scale * std::sinh(y + h_) * std::sin(x);
    double rate = 0;
    for (std::size_t n = 0; n < rate_.size(); ++n) {
      rate += rate_[n] * mode(static_cast<double>(n), y, h_) * std::cos(static_cast<double>(n) * x);
    }
    return -(rate + 0.5 * (u * u + v * v) + y);
  }

  double amplitude_, wavelength_, depth_, gravity_;
  double k_;                  ///< 2 pi/wavelength
  double a_, h_, w_;          ///< scaled
  std::vector<double> rate_;  ///< a_n of phi_t
};

}  // namespace seiche::validation
