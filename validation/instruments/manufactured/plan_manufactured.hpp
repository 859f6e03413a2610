/// Manufactured solution of the Green-Naghdi equations in 2DH, in Lagrangian form: a prescribed motion of the columns
/// of water in a square basin with a level bottom, with the body force that sustains it.
///
///     x = X + A sin kX cos kY cos(w t + 1/2),   k = pi/L,   labels 0 <= X, Y <= L
///     y = Y + A (7/10 cos kX sin kY cos(w t + 1) + 3/10 cos 2kX sin 2kY sin w t)
///     H = d/J,   J = x_X y_Y - x_Y y_X
///
/// H is the depth, d its mean; the motion keeps the walls X, Y = 0, L. With D = d/dt at a label,
///
///     b = (x_tt, y_tt) + g grad H + (alpha/H) grad(H^2 D^2 H),   grad f = (f_X y_Y - f_Y y_X, f_Y x_X - f_X x_Y)/J
///
/// is the horizontal force per unit mass, and lambda = g H + alpha H D^2 H the multiplier of the constraint that the
/// volume of a column does not change: for alpha = 1/3, lambda - g H is the mean over the depth of the pressure, over
/// density, that vertical acceleration adds.
/// The vertical equation, alpha D^2 H = (lambda - g H)/H, has no force. All derivatives are those of the formulas: H^2
/// D^2 H = d^3 (2 J_t^2/J^5 - J_tt/J^4), J and its derivatives by Leibniz's rule from those of the motion.
///
/// When not to use it: models that cannot take a force, shorelines (H > 0 everywhere), labels as places at t = 0 (there
/// is no time at which x = X everywhere).
///
/// References: Green and Naghdi, A derivation of equations for wave propagation in water of variable depth, J. Fluid
/// Mech. 78 (1976) 237; Miles and Salmon, Weakly dispersive nonlinear gravity waves, J. Fluid Mech. 157 (1985) 519
/// (Lagrangian form); Roache, Code verification by the method of manufactured solutions, J. Fluids Eng. 124 (2002) 4.
#pragma once

#include <cmath>
#include <numbers>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::validation {

class PlanManufactured {
 public:
  struct Parameters {
    double gravity = 1;                ///< g [m/s^2]
    double depth = 1;                  ///< d [m]
    double length = std::numbers::pi;  ///< side of the basin L [m]
    double amplitude = 0.15;           ///< A [m], |A| k <= 0.3: J > 1 - 2.3 |A| k > 0.3
    double frequency = 1.3;            ///< w [1/s]
    double alpha = 1.0 / 3;            ///< factor of the vertical kinetic energy
  };

  /// What a column of water carries, and the force on it.
  struct Sample {
    double x, y;        ///< place [m]
    double u, v;        ///< horizontal velocity [m/s]
    double depth;       ///< H: elevation of the surface above the bottom [m]
    double depth_rate;  ///< its rate at the label, the vertical velocity of the surface [m/s]
    double lambda;      ///< g H + alpha H D^2 H [m^2/s^2]
    double bx, by;      ///< body force per unit mass [m/s^2]
  };

  struct Label {
    double x, y;  ///< [m]
  };

  /// Throws std::invalid_argument.
  explicit PlanManufactured(const Parameters& parameters);
  PlanManufactured() : PlanManufactured(Parameters{}) {}

  /// @param label_x, label_y  X, Y in [0, L] [m]. Throws std::invalid_argument.
  [[nodiscard]] Sample at(double label_x, double label_y, double t) const;
  /// Label of the column at (x, y) at time t: Newton's method to round-off.
  [[nodiscard]] Label label(double x, double y, double t) const;

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] double period() const { return 2 * std::numbers::pi / parameters_.frequency; }  ///< [s]

  [[nodiscard]] double uncertainty() const { return 100 * exact::epsilon; }
  [[nodiscard]] exact::SelfTest self_test() const;

 private:
  Parameters parameters_;
};

}  // namespace seiche::validation
