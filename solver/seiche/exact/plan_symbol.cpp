#include "seiche/exact/plan_symbol.hpp"

#include <cmath>
#include <numbers>

#include "seiche/require.hpp"

namespace seiche::exact {

PlanSymbol plan_symbol(double kx, double ky, double hx, double hy) {
  const double rounded_pi = std::numbers::pi * (1 + 1e-15);
  require_within("wavenumber_x", kx, -rounded_pi / hx, rounded_pi / hx);
  require_within("wavenumber_y", ky, -rounded_pi / hy, rounded_pi / hy);
  require_positive("wavenumber", std::hypot(kx, ky));
  const double s1 = std::sin(0.5 * kx * hx);
  const double s2 = std::sin(0.5 * ky * hy);
  const double c1 = std::abs(std::cos(0.5 * kx * hx));  // beyond pi by a rounding it would be negative
  const double c2 = std::abs(std::cos(0.5 * ky * hy));
  return {c1 * c2, 2 * std::hypot(s1 * c2 / hx, s2 * c1 / hy), (2 + std::cos(kx * hx)) * (2 + std::cos(ky * hy)) / 9};
}

}  // namespace seiche::exact
