/// Manufactured solution for an incompressible fluid with a free boundary: two shears, one after the other, of the
/// square |X|, |Y| <= 1 of labels, with the body force that sustains them.
///
///     x = X + e1 sin t sin kY,   y = Y + e2 sin t cos lx,   p = P cos t (1 - X^2)(1 - Y^2)
///
/// Each shear keeps areas, so that det F = 1, F = dr/d(X, Y); the pressure vanishes on the boundary. The force per unit
/// mass is f = r'' + F^-T grad_X p for unit density,
///
///     f_x = x'' + y_Y p_X - y_X p_Y,   f_y = y'' - x_Y p_X + p_Y.
///
/// At t = 0 labels are places and the fluid moves.
///
/// When not to use it: methods that cannot take a force, or whose boundary is not free.
///
/// Reference: Roache, Code verification by the method of manufactured solutions, J. Fluids Eng. 124 (2002) 4.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "seiche/exact/reference_solution.hpp"
#include "seiche/require.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/difference.hpp"

namespace seiche::validation {

class DoubleShear {
 public:
  struct Parameters {
    double first_amplitude = 0.3;    ///< e1
    double second_amplitude = 0.2;   ///< e2
    double first_wavenumber = 1.3;   ///< k
    double second_wavenumber = 1.1;  ///< l
    double pressure = 0.7;           ///< P
  };

  struct Sample {
    double x, y;              ///< place
    double u, v;              ///< velocity
    double pressure;          ///< over the density
    double force_x, force_y;  ///< per unit mass
  };

  /// Throws std::invalid_argument.
  explicit DoubleShear(const Parameters& parameters) : parameters_(parameters) {
    require_finite("first_amplitude", parameters.first_amplitude);
    require_finite("second_amplitude", parameters.second_amplitude);
    require_positive("first_wavenumber", parameters.first_wavenumber);
    require_positive("second_wavenumber", parameters.second_wavenumber);
    require_finite("pressure", parameters.pressure);
  }
  DoubleShear() : DoubleShear(Parameters{}) {}

  /// The particle of label (X, Y). The formulas hold outside of the square too.
  [[nodiscard]] Sample at(double label_x, double label_y, double t) const {
    const auto& [e1, e2, k, l, top_pressure] = parameters_;
    const double s = std::sin(t);
    const double c = std::cos(t);

    const double x = label_x + e1 * s * std::sin(k * label_y);
    const double x_t = e1 * c * std::sin(k * label_y);
    const double x_tt = -e1 * s * std::sin(k * label_y);
    const double wave = e2 * std::cos(l * x);
    const double wave_x = -e2 * l * std::sin(l * x);
    const double wave_xx = -l * l * wave;
    const double y_t = c * wave + s * wave_x * x_t;
    const double y_tt = -s * wave + 2 * c * wave_x * x_t + s * (wave_xx * x_t * x_t + wave_x * x_tt);

    const double x_along_y = e1 * s * k * std::cos(k * label_y);
    const double y_along_x = s * wave_x;
    const double y_along_y = 1 + y_along_x * x_along_y;
    const double bump_x = 1 - label_x * label_x;
    const double bump_y = 1 - label_y * label_y;
    const double p_x = -2 * top_pressure * c * label_x * bump_y;
    const double p_y = -2 * top_pressure * c * label_y * bump_x;
    return {.x = x,
            .y = label_y + s * wave,
            .u = x_t,
            .v = y_t,
            .pressure = top_pressure * c * bump_x * bump_y,
            .force_x = x_tt + y_along_y * p_x - y_along_x * p_y,
            .force_y = y_tt - x_along_y * p_x + p_y};
  }

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }

  [[nodiscard]] double uncertainty() const { return 20 * exact::epsilon; }
  [[nodiscard]] exact::SelfTest self_test() const {
    const auto& [e1, e2, k, l, top_pressure] = parameters_;
    Worst area, velocities, momentum;
    for (const double label_x : {-0.9, -0.35, 0.1, 0.6, 1.0}) {
      for (const double label_y : {-1.0, -0.55, 0.05, 0.4, 0.8}) {
        for (const double t : {0.0, 0.4, 1.1, 2.6}) {
          const auto along_x = [&](double Sample::*value) {
            return difference([&](double z) { return at(z, label_y, t).*value; }, label_x);
          };
          const auto along_y = [&](double Sample::*value) {
            return difference([&](double z) { return at(label_x, z, t).*value; }, label_y);
          };
          const auto in_time = [&](double Sample::*value) {
            return difference([&](double z) { return at(label_x, label_y, z).*value; }, t);
          };
          const Sample here = at(label_x, label_y, t);
          const double x_x = along_x(&Sample::x);
          const double x_y = along_y(&Sample::x);
          const double y_x = along_x(&Sample::y);
          const double y_y = along_y(&Sample::y);
          const double p_x = along_x(&Sample::pressure);
          const double p_y = along_y(&Sample::pressure);
          area.add(x_x * y_y - x_y * y_x - 1);
          velocities.add(in_time(&Sample::x) - here.u);
          velocities.add(in_time(&Sample::y) - here.v);
          momentum.add(in_time(&Sample::u) + y_y * p_x - y_x * p_y - here.force_x);
          momentum.add(in_time(&Sample::v) - x_y * p_x + x_x * p_y - here.force_y);
        }
      }
    }
    // Eighth-order differences over h = (551 eps)^(1/9) = 0.037: weights of 2.1/h in sum; the truncation is as large
    // for ninth derivatives of order one, and grows with the ninth power of the wavenumbers and shears.
    const double shear = 1 + std::abs(e1) * k + std::abs(e2) * l * (1 + std::abs(e1));
    const double steepness = std::pow(std::max({1.0, k, l}), 9);
    const double scale = 1 + std::abs(e1) + std::abs(e2) + std::abs(top_pressure);
    const double limit = 4 * exact::epsilon * 2.1 / 0.037 * scale * shear * shear * steepness;
    const std::string reason =
        "values rounded four times over the spacing 0.037 of eighth-order differences, whose truncation is as large: "
        "the "
        "ninth power of the wavenumbers";
    return {{"det dr/d(X, Y) = 1", area.value(), limit, reason},
            {"r' = (u, v)", velocities.value(), limit, reason},
            {"r'' + F^-T grad_X p = f", momentum.value(), limit, reason}};
  }

 private:
  Parameters parameters_;
};

}  // namespace seiche::validation
