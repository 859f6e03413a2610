/// Manufactured solution of one-dimensional dispersive shallow water over an uneven bottom: a prescribed motion and
/// dynamic pressure in label coordinates, with the generalised forces that sustain them.
///
///     b(x) = -d + e cos(kb x),   x(a, t) = a + A sin(k a) cos(w t),   H = (d - e cos(kb a))/x_a,   y = b(x) + H,
///     pi(a, t) = Q cos(k2 a) sin(w t),   lambda = g y + pi,   all with period L in a
///
/// b bottom, H depth, y elevation of the surface, pi pressure of vertical acceleration over density, lambda the
/// multiplier of the constraint that H x_a does not change. Gravity and lambda push a label with, per unit mass,
///
///     Fx = -g y_x - pi_x - pi y_x/H,   Fy = pi/H,   f_x = f_a/x_a
///
/// and with improved dispersion, whose energy is (g gamma/2) H^2 y_x^2 per unit of x, M = H x_a,
///
///     Fx -= (3 g gamma/2) (M^2 y_a^2/x_a^4)_a/M,   Fy += g gamma (M^2 y_a/x_a^3)_a/M
///
/// Kinetic energy (p^2 + alpha r^2)/2 per unit mass, in one of two frames; u = x_t, v = y_t, c = 1/sqrt(1 + b'^2),
/// s = b' c:
///
///     along and normal to the bottom (Frank):  u = p c - r s,  v = p s + r c
///         p_t = c Fx + s Fy + S_p,   alpha r_t = -s Fx + c Fy + S_r
///     Green-Naghdi:  u = q p,  v = r - kappa b' u,   q = 1/sqrt(1 + mu b'^2)
///         p_t = q (Fx - kappa b' Fy) + S_p,   alpha r_t = Fy + S_r
///         kappa = (1 - 2 alpha)/(2 alpha),   mu = alpha - alpha kappa^2 = 1 - 1/(4 alpha)
///
/// The second frame. In a column whose vertical velocity is linear between b' u at the bottom and v at the surface the
/// mean of u^2 + w^2 is (alpha = 1/3)
///
///     u^2 + b'^2 u^2 + b' u (v - b' u) + alpha (v - b' u)^2 = (1 + mu b'^2) u^2 + alpha (v + kappa b' u)^2
///         = p^2 + alpha r^2
///
/// p and r are the rates of X = int dx/q and Y = y + kappa b, functions of the place alone, so that Lagrange's
/// equations have no further terms. With pi = H (alpha r_t - S_r) and v = b' u - H u_x they are, for alpha = 1/3, the
/// Green-Naghdi momentum equation over an uneven bottom, D = u_t at a label:
///
///     (1 + b'^2) D + b' b'' u^2 + b' H u_x^2 - H b' D_x/2 + g y_x
///         + (1/H) (H^2 [(H/3) (2 u_x^2 - D_x) + (b' D + b'' u^2)/2])_x = S_p/q + (3/2) b' S_r + (H^2 S_r)_x/H
///
/// In the first frame b' u H_t has coefficient 1 instead of 1/2 in the energy, and p, r are not rates of coordinates:
/// the centripetal acceleration over a curved bottom is absent. On a flat bottom the two agree.
///
/// When not to use it: models that cannot take a force, shorelines (H > 0 everywhere).
///
/// References: Frank, Discrete models of incompressible fluids (1994), ch. 3; Miles and Salmon, Weakly dispersive
/// nonlinear gravity waves, J. Fluid Mech. 157 (1985) 519; Seabra-Santos, Renouard and Temperville, Numerical and
/// experimental study of the transformation of a solitary wave over a shelf or isolated obstacle, J. Fluid Mech. 176
/// (1987) 117; Bonneton, Chazel, Lannes, Marche and Tissier, A splitting approach for the fully nonlinear and weakly
/// dispersive Green-Naghdi model, J. Comput. Phys. 230 (2011) 1479; Roache, J. Fluids Eng. 124 (2002) 4.
#pragma once

#include "seiche/exact/reference_solution.hpp"

namespace seiche::validation {

class DispersiveManufactured {
 public:
  struct Parameters {
    double gravity = 1;             ///< g [m/s^2]
    double depth = 1;               ///< d [m]
    double length = 10;             ///< period L [m]
    double amplitude = 0.3;         ///< A [m], |A| k < 1 so that labels do not cross
    double frequency = 0.8;         ///< w [1/s]
    double pressure = 0.05;         ///< Q [m^2/s^2]
    double bottom_amplitude = 0.2;  ///< e [m], |e| < d
    int motion_mode = 1;            ///< k = 2 pi motion_mode/L
    int bottom_mode = 1;            ///< kb likewise
    int pressure_mode = 2;          ///< k2 likewise
    double alpha = 1.0 / 3;         ///< share of the vertical motion in the energy; >= 1/4 in the second frame
    bool green_naghdi = false;      ///< frame of p and r
    double gamma = 0;               ///< factor of the energy of improved dispersion
  };

  /// What a marker of the model carries, and the force on it.
  struct Sample {
    double x, y;                ///< position [m]
    double p, r;                ///< rates [m/s]
    double lambda;              ///< g y + pi [m^2/s^2]
    double source_p, source_r;  ///< generalised force per unit mass [m/s^2]
  };

  struct Bottom {
    double height, slope, curvature;
  };

  /// Throws std::invalid_argument.
  explicit DispersiveManufactured(const Parameters& parameters);
  DispersiveManufactured() : DispersiveManufactured(Parameters{}) {}

  [[nodiscard]] Sample at(double label, double t) const;
  [[nodiscard]] Bottom bottom(double x) const;
  /// H x_a = d - e cos(kb a): volume per unit of label, constant in time [m].
  [[nodiscard]] double volume_density(double label) const;

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }

  [[nodiscard]] double uncertainty() const;
  [[nodiscard]] exact::SelfTest self_test() const;

 private:
  Parameters parameters_;
  double motion_wavenumber_, bottom_wavenumber_, pressure_wavenumber_;
};

}  // namespace seiche::validation
