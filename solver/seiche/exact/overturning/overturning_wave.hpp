/// A steep wave that overturns: fully nonlinear potential flow, periodic, over a flat bottom or in deep water.
///
/// At t = 0 the surface is eta = amplitude cos kx with the surface potential of the linear wave of that amplitude
/// travelling to +x (k = 2 pi/wavelength, units of 1/k and g in the formulas):
///
///     phi = (A/w) cosh(y + h)/cosh(h) sin x at y = eta,   w = sqrt(tanh h).
///
/// Too steep to be a travelling wave, it breaks. Cauchy's integral gives the velocity of the surface with spectral
/// accuracy (overturning/surface_velocity.hpp); markers move with the water (overturning/evolution.hpp) until the jet
/// touches the water ahead. Volume, energy and impulse are conserved by the motion, and measured.
///
/// When not to use it: after touch-down; waves that do not break (travelling waves: stokes_wave.hpp); near touch-down
/// for more digits than uncertainty(t) says.
///
/// References: Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350
/// (1976) 1; Baker, Meiron & Orszag, Generalized vortex methods for free-surface flow problems, J. Fluid Mech. 123
/// (1982) 477.
///
/// A Stokes wave that a travelling pressure on its surface, or another velocity than its own at the start, makes
/// overturn: fully nonlinear potential flow.
///
/// At t = 0 a Stokes wave of half height `amplitude` has its crest at x = 0 and travels to +x over a flat bottom at
/// y = -depth, its velocities multiplied by velocity_factor; without amplitude the water is at rest. Then, in units of
/// 1/k (k = 2 pi/wavelength), g and the density,
///
///     p_s(x, t) = -p0 sin t sin(x - t)   for 0 <= t <= pi,   0 afterwards,
///
/// acts on the surface: high pressure behind the crest of a wave that travels with the linear speed of deep water. It
/// enters dphi/dt = |grad phi|^2/2 - y - p_s of the markers (overturning/evolution.hpp); the velocity comes from
/// Cauchy's integral (overturning/surface_velocity.hpp). Volume is conserved; energy and horizontal impulse change by
/// the pressure's work and thrust, which are integrated with the motion, and measured.
///
/// When not to use it: after touch-down; near touch-down for more digits than uncertainty(t) says; up to a jet with
/// fewer than 192 markers, whose balances then err by more than the steps explain.
///
/// Reference: Longuet-Higgins & Cokelet, The deformation of steep surface waves on water I, Proc. R. Soc. Lond. A 350
/// (1976) 1. The amplitude of the pressure is the user's: 0.1 is fitted to the times of the frames of Frank (1994),
/// figure 10, which does not print one.
///
/// Many waves in a tank, over a level bottom or over bars: a group that comes to a focus at a wall, or an irregular
/// sea. Fully nonlinear potential flow.
///
/// Between walls at x = 0 and half a wavelength, modes n = first .. last start with the surface and the potential that
/// linear theory gives them at t = 0 (k = 2 pi/wavelength, w_n^2 = g n k tanh n k h):
///
///     eta = sum a_n cos n k x cos(w_n(t - focus) + e_n),    sum a_n = amplitude,
///     phi = -sum (a_n g/w_n) cosh n k(y + h)/cosh n k h cos n k x sin(w_n(t - focus) + e_n),   on the surface y = eta.
///
/// The a_n are equal, or, with a mode `peak`, a_n^2 is in proportion to JONSWAP's spectrum with its peak there,
///
///     S(w) = w^-5 exp(-(5/4) (w_p/w)^4) 3.3^exp(-(w/w_p - 1)^2/(2 s^2)),  s = 0.07 for w <= w_p, 0.09 above,
///
/// times the band dw_n = c_g k. With seed = 0 all e_n are 0: by linear theory all crests meet at the wall x = 0 at
/// t = focus, `amplitude` high; focus = 0 starts at rest, and one mode is a standing wave. Any other seed draws the e_n
/// at random between 0 and 2 pi: an irregular sea. The tank and its mirror image are the period of the computed motion.
///
/// Over bars (overturning/bars.hpp) the potential at the start is that of linear theory in the plane of zeta: it keeps
/// to the bottom, and later times of linear theory are those of the level bottom.
///
/// When not to use it: waves steep enough to break, or to throw a jet up the wall.
///
/// References: Baldock, Swan & Taylor, A laboratory study of nonlinear surface waves on water, Phil. Trans. R. Soc.
/// Lond. A 354 (1996) 649 (groups of equal amplitudes); Hasselmann et al., Measurements of wind-wave growth and swell
/// decay during the Joint North Sea Wave Project, Dtsch. Hydrogr. Z. A 8(12) (1973).
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "seiche/exact/overturning/surface_curve.hpp"
#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

class OverturningWave : public overturning::MovingSurface {
 public:
  struct Parameters {
    double amplitude = 0.5;                                  ///< [m]; k amplitude in (0, 1], amplitude < depth
    double wavelength = 2 * std::numbers::pi;                ///< [m]
    double depth = std::numeric_limits<double>::infinity();  ///< [m]; infinite for deep water
    double gravity = 1;                                      ///< [m/s^2]
    std::size_t markers = 512;                               ///< even, at least 64
    double last_time = 0;                                    ///< [s]; 0: one period of the linear wave
    double tolerance = 2e-11;                                ///< of a time step, in units of 1/k
  };

  /// Computes the motion until last_time or until it ends by itself.
  /// Throws std::invalid_argument.
  explicit OverturningWave(const Parameters& parameters);

  [[nodiscard]] SelfTest self_test() const;

 private:
  Parameters parameters_;
};

class PressureForcedWave : public overturning::MovingSurface {
 public:
  struct Parameters {
    double amplitude = 0.3;                    ///< half the height of the Stokes wave [m]; 0: water at rest
    double wavelength = 2 * std::numbers::pi;  ///< [m]
    double depth = std::numbers::pi;           ///< mean [m]; infinite for deep water
    double gravity = 1;                        ///< [m/s^2]
    double pressure = 0.1;                     ///< p0 over the density [m^2/s^2]; k p0/g in [-1, 1]
    double velocity_factor = 1;                ///< of the Stokes wave's velocities at t = 0; in [0, 2]
    std::size_t markers = 256;                 ///< even, at least 64
    double last_time = 0;                      ///< [s]; 0: 7.4/sqrt(g k), Frank's last frame
    double tolerance = 2e-11;                  ///< of a time step, in units of 1/k
  };

  /// Computes the motion until last_time or until it ends by itself. Throws std::invalid_argument.
  explicit PressureForcedWave(const Parameters& parameters);

  /// p_s over the density [m^2/s^2].
  [[nodiscard]] double pressure(double x, double t) const;

  /// Per wavelength, for density 1: work [m^4/s^2] and horizontal thrust [m^3/s] of the pressure from 0 to t.
  struct Action {
    double work, thrust;
  };
  [[nodiscard]] Action action(double t) const;

  [[nodiscard]] SelfTest self_test() const;

 private:
  Parameters parameters_;
  std::optional<double> kinetic_energy_;  ///< of the Stokes wave, per wavelength [m^4/s^2]
};

class WavesInTank : public overturning::MovingSurface {
 public:
  struct Parameters {
    double amplitude = 0.1;     ///< sum of the modes' amplitudes [m]; steepness amplitude k last < 1
    double wavelength = 12;     ///< twice the length of the tank [m]
    double depth = 1;           ///< [m]; infinite for deep water
    double gravity = 9.81;      ///< [m/s^2]
    int first = 2, last = 7;    ///< modes, whole waves in `wavelength`; 1 <= first <= last <= markers/8
    double focus = 0;           ///< [s]; not negative
    int peak = 0;               ///< mode at the spectrum's peak; 0: equal amplitudes
    int seed = 0;               ///< of the phases; 0: none, a focus
    double bar_height = 0;      ///< from trough to crest [m]; at most 1/(their wavenumber), where they are sharp
    int bars = 2;               ///< in `wavelength`, a crest at x = 0; a finite depth is that of their middle
    std::size_t markers = 256;  ///< even, at least 64
    double last_time = 0;       ///< [s]; 0: the focus, or one period of the longest mode if that is 0
    double tolerance = 2e-11;   ///< of a time step, in units of 1/k
  };

  /// Computes the motion until last_time or until it ends by itself. Throws std::invalid_argument.
  explicit WavesInTank(const Parameters& parameters);

  /// By linear theory its elevation is amplitude cos(wavenumber x) cos(frequency t + phase).
  struct Mode {
    double wavenumber, amplitude, frequency, phase;  ///< [1/m], [m], [1/s], [1]
  };
  static std::vector<Mode> modes_of(const Parameters& parameters);
  [[nodiscard]] const std::vector<Mode>& modes() const { return modes_; }
  /// Four standard deviations of the elevation of linear theory, over the tank and a long time [m].
  [[nodiscard]] double significant_height() const;

  /// Linear theory, anywhere in the water, at any time; the motion starts with it at t = 0.
  struct Linear {
    double elevation = 0;  ///< [m], of y at any height
    double potential = 0;  ///< [m^2/s]
    Velocity velocity;     ///< [m/s]
    double pressure = 0;   ///< over the density, -phi_t - |grad phi|^2/2 - g y [m^2/s^2]
    double discharge = 0;  ///< of the water below y, towards +x [m^2/s]
  };
  [[nodiscard]] Linear linear(double x, double y, double t) const;
  /// In metres.
  [[nodiscard]] const overturning::Bars& bars() const { return bars_; }

  [[nodiscard]] SelfTest self_test() const;

 private:
  Parameters parameters_;
  std::vector<Mode> modes_;
  overturning::Bars bars_;
};

}  // namespace seiche::exact
