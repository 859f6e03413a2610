/// Manufactured solution in Lagrangian form: a prescribed motion of the water, with the body force that sustains it.
///
///     x(label, t) = label + A sin(k label) sin(w t),   walls at 0 and length, k = 2 pi/length
///
/// Mass is exact by construction: J = 1 + A k cos(k label) sin(w t), h = H/J. The momentum equation then needs the
/// force per unit mass f = x_tt + (g/J) d(H/J)/d label = -A w^2 sin(k label) sin(w t) - g H J_label/J^3, J_label = -A
/// k^2 sin(k label) sin(w t). On an uneven bed add g z_x(x).
///
/// When not to use it: methods that cannot take a body force.
///
/// References: Roache, Code verification by the method of manufactured solutions, J. Fluids Eng. 124 (2002) 4.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <boost/math/tools/roots.hpp>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/require.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::validation {

class LagrangianManufactured {
 public:
  /// @param depth      still-water depth H [m];  @param length  of the basin [m]
  /// @param amplitude  A [m], A k < 1 so that particles do not cross;  @param frequency  w [1/s]
  /// Throws std::invalid_argument.
  explicit LagrangianManufactured(double gravity = 9.81, double depth = 1, double length = 1, double amplitude = 0.05,
                                  double frequency = 3)
      : gravity_(gravity), depth_(depth), length_(length), amplitude_(amplitude), frequency_(frequency) {
    require_positive("gravity", gravity);
    require_positive("depth", depth);
    require_positive("length", length);
    require_positive("frequency", frequency);
    wavenumber_ = 2 * std::numbers::pi / length;
    require_within("amplitude", amplitude, 0, 0.999 / wavenumber_);
  }

  /// State at (x, t), x in [0, length].
  [[nodiscard]] shallow_water::State at(double x, double t) const { return state_of(label(x, t), t); }
  /// Body force per unit mass f(x, t) [m/s^2] on a flat bed.
  [[nodiscard]] double source(double x, double t) const { return source_of(label(x, t), t); }

  /// Position of the particle with this label (its place at t = 0) [m]: exact reference for edges.
  [[nodiscard]] double position(double label, double t) const {
    return label + amplitude_ * std::sin(wavenumber_ * label) * std::sin(frequency_ * t);
  }
  /// Label of the particle at x: Newton's method within a bracket.
  [[nodiscard]] double label(double x, double t) const {
    require_within("x", x, 0, length_);
    require_finite("t", t);
    const double swing = amplitude_ * std::sin(frequency_ * t);
    const auto residual = [&](double s) {
      return std::pair(s + swing * std::sin(wavenumber_ * s) - x, 1 + swing * wavenumber_ * std::cos(wavenumber_ * s));
    };
    std::uintmax_t iterations = 200;
    const double reach = std::abs(swing);
    const double low = std::max(0.0, x - reach);
    const double high = std::min(length_, x + reach);
    if (!(high > low)) return x;
    // Newton's last step doubles the digits, so 50 of the 53 bits asked for arrive as all.
    return boost::math::tools::newton_raphson_iterate(residual, x, low, high, 50, iterations);
  }
  /// Mean velocity of the water between two labels (by mass) [m/s].
  [[nodiscard]] double mean_velocity(double left_label, double right_label, double t) const {
    // Mean of sin(k s): sin(k centre) sinc(k half-width), free of cancellation for narrow particles.
    const double half = 0.5 * wavenumber_ * (right_label - left_label);
    const double centre = 0.5 * wavenumber_ * (right_label + left_label);
    const double sinc = half == 0 ? 1.0 : std::sin(half) / half;
    return amplitude_ * frequency_ * std::cos(frequency_ * t) * std::sin(centre) * sinc;
  }
  /// Force and state in terms of the label, without inversion.
  [[nodiscard]] double source_of(double label, double t) const {
    const double wave = amplitude_ * std::sin(wavenumber_ * label) * std::sin(frequency_ * t);
    const double jacobian = 1 + amplitude_ * wavenumber_ * std::cos(wavenumber_ * label) * std::sin(frequency_ * t);
    const double jacobian_slope = -wavenumber_ * wavenumber_ * wave;
    return -frequency_ * frequency_ * wave - gravity_ * depth_ * jacobian_slope / (jacobian * jacobian * jacobian);
  }
  [[nodiscard]] shallow_water::State state_of(double label, double t) const {
    const double jacobian = 1 + amplitude_ * wavenumber_ * std::cos(wavenumber_ * label) * std::sin(frequency_ * t);
    return {depth_ / jacobian, amplitude_ * frequency_ * std::sin(wavenumber_ * label) * std::cos(frequency_ * t)};
  }

 private:
  double gravity_, depth_, length_, amplitude_, frequency_, wavenumber_;
};

}  // namespace seiche::validation
