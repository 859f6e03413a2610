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

#include <array>
#include <vector>

namespace seiche::validation {

class SteepWaveStart {
 public:
  /// Lengths [m]; throws std::invalid_argument unless 0 < amplitude < depth and k amplitude <= 0.448.
  SteepWaveStart(double amplitude, double wavelength, double depth, double gravity);

  /// Elevation [m] above the level at rest.
  [[nodiscard]] double elevation(double x) const { return amplitude_ * std::cos(k_ * x); }
  /// (u, v) [m/s], y from the level at rest.
  [[nodiscard]] std::array<double, 2> velocity(double x, double y) const;
  /// p/rho [m^2/s^2]; below the bottom that of the bottom and the weight of still water.
  [[nodiscard]] double pressure_over_density(double x, double y) const;
  /// Largest |p/rho| at the surface between the points where it was made zero, over g times the amplitude.
  [[nodiscard]] double surface_defect() const;
  [[nodiscard]] double wavelength() const { return wavelength_; }
  [[nodiscard]] double depth() const { return depth_; }

 private:
  [[nodiscard]] double scaled_pressure(double x, double y) const;

  double amplitude_, wavelength_, depth_, gravity_;
  double k_;                  ///< 2 pi/wavelength
  double a_, h_, w_;          ///< scaled
  std::vector<double> rate_;  ///< a_n of phi_t
};

}  // namespace seiche::validation
