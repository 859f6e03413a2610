/// Smoothing kernels of support 2h in the plane, q = r/h.
///
///     W(r, h) = A/h^2 w(q),   grad_a W_ab = F (r_a - r_b),   F = (1/r) dW/dr = A/h^4 f(q),   f = w'(q)/q <= 0
///
///     cubic spline:  A = 10/(7 pi),  w = (2-q)_+^3/4 - (1-q)_+^3
///     Wendland C2:   A =  7/(4 pi),  w = (1-q/2)^4 (2q+1)
///
/// References: Monaghan and Lattanzio, A refined particle method for astrophysical problems, Astron. Astrophys. 149
/// (1985) 135; Wendland, Piecewise polynomial, positive definite and compactly supported radial functions of minimal
/// degree, Adv. Comput. Math. 4 (1995) 389.
#pragma once

#include <numbers>
#include <string_view>

namespace seiche::wcsph {

enum class KernelName { cubic_spline, wendland_c2 };

/// "cubic_spline" or "wendland_c2"; throws std::invalid_argument naming those that exist.
KernelName kernel_named(std::string_view name);
std::string_view name_of(KernelName kernel);

/// Half of the width of both kernels, in h.
inline constexpr double support = 2;

struct CubicSpline {
  static constexpr double factor = 10 / (7 * std::numbers::pi);  ///< A
  static constexpr double shape(double q) {
    const double outer = q < 2 ? 2 - q : 0;
    const double inner = q < 1 ? 1 - q : 0;
    return 0.25 * outer * outer * outer - inner * inner * inner;
  }
  /// w'(q)
  static constexpr double slope(double q) {
    const double outer = q < 2 ? 2 - q : 0;
    const double inner = q < 1 ? 1 - q : 0;
    return 3 * inner * inner - 0.75 * outer * outer;
  }
};

struct WendlandC2 {
  static constexpr double factor = 7 / (4 * std::numbers::pi);  ///< A
  static constexpr double shape(double q) {
    const double rest = q < 2 ? 1 - 0.5 * q : 0;
    return rest * rest * rest * rest * (2 * q + 1);
  }
  /// w'(q)
  static constexpr double slope(double q) {
    const double rest = q < 2 ? 1 - 0.5 * q : 0;
    return -5 * q * rest * rest * rest;
  }
};

/// W [1/m^2] at distance r.
template <class Kernel>
constexpr double weight(double r, double h) {
  return Kernel::factor / (h * h) * Kernel::shape(r / h);
}
/// dW/dr [1/m^3] at distance r.
template <class Kernel>
constexpr double radial_slope(double r, double h) {
  return Kernel::factor / (h * h * h) * Kernel::slope(r / h);
}

}  // namespace seiche::wcsph
