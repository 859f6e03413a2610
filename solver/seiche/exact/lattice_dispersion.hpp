/// Dispersion laws of the discrete models on regular lattices, in closed form: markers in one dimension, markers in
/// plan, layers of hexahedra, and their section, the two-dimensional mesh.
///
/// A time step tau changes the frequency omega of a semi-discrete model into Omega:
/// one-step scheme sin(Omega tau/2) = omega tau/2, conservative scheme tan(Omega tau/2) = omega tau/2.
///
/// When not to use them: unequal spacing, a deformed lattice, an uneven bottom, waves of finite amplitude.
///
/// References: Frank, Discrete models of incompressible fluids (1994), ch. 2, ch. 3 with formula (13), 4.1 and 4.2; the
/// other closed forms follow from the linearised cells. Madsen and Sorensen, Coastal Eng. 18 (1992) 183 (the idea of
/// tuning to Airy); Trefethen, Group velocity in finite difference schemes, SIAM Review 24 (1982) 113 (anisotropy);
/// Hairer, Lubich and Wanner, Geometric numerical integration (2006), I.5 (frequency of the time schemes).
#pragma once

#include <cmath>
#include <cstddef>

#include "seiche/exact/dispersion.hpp"

namespace seiche::exact {

/// Markers at spacing s on still water of depth H. With h = s/H, kappa = k H, theta = k s/2, nu = omega^2 H/g:
///
///     nu = (1 - beta (1 - cos k s) + 4 gamma sin^2 theta/h^2) 4 tan^2 theta/(4 alpha tan^2 theta + h^2),  k s < pi.
///
/// alpha multiplies the vertical kinetic energy; 1 - 2 beta, the potential energy of a cell's slope; gamma is an added
/// potential energy of slopes. alpha = beta = 1/3, gamma = 0 is formula (13) of the source,
/// nu = (2 + cos k s)/3 * 4 t^2/(h^2 + 4 alpha t^2), t = tan theta. As s -> 0 it is kappa^2 (1 + gamma kappa^2)/
/// (1 + alpha kappa^2), with relative error O(s^2) (for beta = 1/3 the leading one is -alpha kappa^4 h^2/12 in omega).
class FrankDispersion {
 public:
  struct Parameters {
    double alpha = 1.0 / 3;
    double beta = 1.0 / 3;
    double gamma = 0;
  };

  /// @param gravity [m/s^2];  @param depth H [m];  @param spacing s [m]
  /// Throws std::invalid_argument; also for parameters with which the shortest wave would grow.
  FrankDispersion(double gravity, double depth, double spacing, Parameters parameters);
  FrankDispersion(double gravity, double depth, double spacing)
      : FrankDispersion(gravity, depth, spacing, Parameters{}) {}

  /// alpha and gamma that follow Airy's law through kappa^4 (relative) for this spacing and time step of the one-step
  /// scheme, beta = 1/3.
  /// @param time_step tau [s], 0 for the semi-discrete model
  static FrankDispersion tuned(double gravity, double depth, double spacing, double time_step);

  /// Angular frequency [1/s], phase and group speed [m/s] of wavenumber k, 0 < k s < pi.
  [[nodiscard]] double frequency(double k) const { return k * phase_speed(k); }
  [[nodiscard]] double phase_speed(double k) const;
  [[nodiscard]] double group_speed(double k) const;
  /// The law without markers, s -> 0.
  [[nodiscard]] RationalDispersion limit() const { return {gravity_, depth_, parameters_.gamma, parameters_.alpha}; }

  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[nodiscard]] double spacing() const { return spacing_; }

  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_, depth_, spacing_;
  Parameters parameters_;
};

enum class TimeScheme { one_step, conservative };

/// Frequency Omega [1/s] that a scheme of time step tau gives to a mode of frequency omega. Throws
/// std::invalid_argument for the one-step scheme with omega tau > 2: the mode grows.
double discrete_frequency(double omega, double time_step, TimeScheme scheme);

/// A plane wave exp(i k . r) on a rectangular lattice of bilinear cells: what differencing, averaging and the potential
/// energy of the surface make of it. c_i = cos(k_i h_i/2), s_i = sin(k_i h_i/2); K of PlanDispersion is the wavenumber
/// that the constraint of a cell sees. mean and gradient stay finite where K does not, k_i h_i = pi.
struct PlanSymbol {
  double mean;       ///< c1 c2: average over the corners of a cell
  double gradient;   ///< 2 |(s1 c2/h1, s2 c1/h2)| = K c1 c2: difference of opposite sides, averaged along them [1/m]
  double potential;  ///< G: mean square of the bilinear patches over that of the corners
};

/// @param kx, ky  wavenumber [1/m], not both 0, |k_i| h_i <= pi;  @param hx, hy  sides of a cell h1, h2 [m]
/// Throws std::invalid_argument.
PlanSymbol plan_symbol(double kx, double ky, double hx, double hy);

/// Markers in plan, on a rectangular lattice of spacings h1, h2.
///
///     omega^2 = g H G K^2/(1 + alpha H^2 K^2)
///     T_i = (2/h_i) tan(k_i h_i/2),   K^2 = T1^2 + T2^2,   G = ((2 + cos k1 h1)/3) ((2 + cos k2 h2)/3),   |k_i| h_i <=
///     pi
///
/// The volume of a cell allows Z = -i H (T1 X + T2 Y) for the displacement (X, Y, Z) of a marker; of all motions with
/// that Z the one along (T1, T2) has the least kinetic energy, |Z'|^2 (alpha + 1/(H K)^2)/2 per unit mass. The total
/// volume below the bilinear patches being constant, the potential energy is that of the patches about the still level,
/// g G |Z|^2/2 per unit area. All other motions are vortices, omega = 0. For k2 = 0 it is formula (13) of the source
/// (FrankDispersion).
///
///     h_i -> 0           omega^2 = g H k^2/(1 + alpha H^2 k^2), k = |k|: the Green-Naghdi equations
///     leading error      -(k1^2 h1^2 + k2^2 h2^2)/12 + (k1^4 h1^2 + k2^4 h2^2)/(12 k^2 (1 + alpha H^2 k^2)) of omega;
///                        for long waves -(h1^2 + h2^2) k1^2 k2^2/(12 k^2): none along the axes, largest at 45 degrees
///     shortest waves     k_i h_i = pi: omega^2 = g G/(alpha H), the same without a bound on the other component
class PlanDispersion {
 public:
  /// @param spacing_x, spacing_y  h1, h2 [m];  @param alpha  factor of the vertical kinetic energy
  /// Throws std::invalid_argument unless all are positive.
  PlanDispersion(double gravity, double depth, double spacing_x, double spacing_y, double alpha = 1.0 / 3);

  /// omega [1/s] and omega/|k| [m/s] of the wavenumber (kx, ky) [1/m], |k_i| h_i <= pi, not 0. Throw
  /// std::invalid_argument.
  [[nodiscard]] double frequency(double kx, double ky) const;
  [[nodiscard]] double phase_speed(double kx, double ky) const { return frequency(kx, ky) / std::hypot(kx, ky); }

  /// The law without a lattice, h_i -> 0: isotropic.
  [[nodiscard]] RationalDispersion limit() const { return RationalDispersion::green_naghdi(gravity_, depth_, alpha_); }
  /// sqrt(g/(alpha H)) [1/s], above every frequency: the one-step scheme is stable for tau < 2/bound, whatever the
  /// spacing.
  [[nodiscard]] double frequency_bound() const { return std::sqrt(gravity_ / (alpha_ * depth_)); }

  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_, depth_, spacing_x_, spacing_y_, alpha_;
};

/// Vertical inertia of surface nodes: their mass, or reduced so that long waves have Airy's frequency to one more
/// power.
enum class SurfaceInertia { nodal, tuned };

/// n layers of hexahedra of height h3 = H/n on a rectangular lattice h1, h2. With K, G of PlanDispersion,
///
///     theta = K h3/2,   t_n = tanh(2 n artanh theta) = [(1+theta)^2n - (1-theta)^2n]/[(1+theta)^2n + (1-theta)^2n],
///
///     omega^2 = (2 g/h3) G R,   R = theta (1 - theta^2) t_n/(1 - theta t_n + 2 b theta (1 - theta^2) t_n)
///
/// b is the vertical inertia of a surface node over that of an inner one: 1/2 with nodal masses, when the denominator
/// is 1 - theta^3 t_n, and 1/2 - 1/(6n) when tuned. Inner layers give tanh(mu h3/2) = theta, the bottom mirrors, the
/// surface closes: multipliers vary like cosh(2 (j + 1/2) artanh theta) over the layers; for theta > 1, where mu is
/// complex, they alternate. With P, Q = cosh(mu (1 - h/2)), cosh(mu (1 - 3h/2)) the multipliers of the two upper layers
/// (depth 1, h = 1/n) the nodal law is also (2 g G/h) [theta^2 (Q + 3P) + P - Q]/[theta^2 (Q + 3P) + 3P - Q].
///
///     fine meshes        omega^2 -> g k tanh kH
///     one layer          omega^2 = g H G K^2/(1 + b H^2 K^2): PlanDispersion with alpha = b, 1/3 when tuned
///     shortest waves     k_i h_i = pi: omega^2 = g G/(b h3)
class HexahedralDispersion {
 public:
  /// @param spacing_x, spacing_y  h1, h2 [m];  @param layers  n. Throws std::invalid_argument unless all are positive.
  HexahedralDispersion(double gravity, double depth, double spacing_x, double spacing_y, std::size_t layers,
                       SurfaceInertia inertia = SurfaceInertia::nodal);

  /// omega [1/s] and omega/|k| [m/s] of the wavenumber (kx, ky) [1/m], |k_i| h_i <= pi, not 0. Throw
  /// std::invalid_argument.
  [[nodiscard]] double frequency(double kx, double ky) const;
  [[nodiscard]] double phase_speed(double kx, double ky) const { return frequency(kx, ky) / std::hypot(kx, ky); }
  /// Speed that a vertical impulse on the surface leaves it with, over the speed that the impulse would give to the
  /// surface nodes if they were free: 2 b R = b omega^2 h3/(g G).
  [[nodiscard]] double surface_response(double kx, double ky) const;
  /// sqrt(g/(b h3)) [1/s], above every frequency: the one-step scheme is stable for tau < 2/bound.
  [[nodiscard]] double frequency_bound() const { return std::sqrt(gravity_ / (inertia_ * layer_height())); }

  [[nodiscard]] double layer_height() const { return depth_ / static_cast<double>(layers_); }
  [[nodiscard]] double surface_inertia() const { return inertia_; }  ///< b

  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  double gravity_, depth_, spacing_x_, spacing_y_;
  std::size_t layers_;
  double inertia_;
};

/// The two-dimensional Lagrangian mesh: a section along x through the hexahedra, n rows of height h2 = H/n in columns
/// of width h1, theta = T = (h2/h1) tan(k h1/2), 0 < k h1 <= pi.
///
///     omega^2 = (2 g/h2) ((2 + cos k h1)/3) T (1 - T^2) t_n/(1 - T t_n + 2 b T (1 - T^2) t_n)
///
///     long waves        omega^2 = g H k^2 (1 - (1/3 + (h2/H)^2/6) (kH)^2 + ...); tuned: -1/3 without h2
///     shortest wave     k h1 = pi: omega^2 = g/(3 b h2)
///     one row           Frank's formula (13) (FrankDispersion) with alpha = b: 1/2 with nodal masses, 1/3 tuned
class LagrangianMeshDispersion {
 public:
  /// @param column_width  h1 [m];  @param rows  n. Throws std::invalid_argument unless all are positive.
  LagrangianMeshDispersion(double gravity, double depth, double column_width, std::size_t rows,
                           SurfaceInertia inertia = SurfaceInertia::nodal);

  /// omega(k) [1/s] and omega/k [m/s], 0 < k <= pi/h1, and HexahedralDispersion::surface_response. Throw
  /// std::invalid_argument.
  [[nodiscard]] double frequency(double wavenumber) const { return section_.frequency(resolved(wavenumber), 0); }
  [[nodiscard]] double phase_speed(double wavenumber) const { return frequency(wavenumber) / wavenumber; }
  [[nodiscard]] double surface_response(double wavenumber) const {
    return section_.surface_response(resolved(wavenumber), 0);
  }

  /// The largest over 0 < k <= pi/h1: the one-step scheme is stable for tau < 2/omega.
  [[nodiscard]] double largest_frequency() const;

  [[nodiscard]] double column_width() const { return column_width_; }
  [[nodiscard]] double row_height() const { return section_.layer_height(); }

  [[nodiscard]] double uncertainty() const { return 20 * epsilon; }
  [[nodiscard]] SelfTest self_test() const;

 private:
  [[nodiscard]] double resolved(double wavenumber) const;

  double gravity_, depth_, column_width_;
  SurfaceInertia inertia_;
  HexahedralDispersion section_;
};

}  // namespace seiche::exact
