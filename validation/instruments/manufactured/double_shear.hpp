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

#include "seiche/exact/reference_solution.hpp"

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
  explicit DoubleShear(const Parameters& parameters);
  DoubleShear() : DoubleShear(Parameters{}) {}

  /// The particle of label (X, Y). The formulas hold outside of the square too.
  [[nodiscard]] Sample at(double label_x, double label_y, double t) const;

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }

  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] exact::SelfTest self_test() const;

 private:
  Parameters parameters_;
};

}  // namespace seiche::validation
