/// Solitary waves as asymptotic series in amplitude over depth: the first three orders, and the exact wave of Serre's
/// equations.
///
/// With a = amplitude/depth, X = (x - c t)/depth, elevations in depths, speeds in sqrt(g depth):
///
///     Boussinesq         eta = a sech^2(sqrt(3a/4) X),                  c^2 = 1 + a
///     Rayleigh, Serre    eta = a sech^2(sqrt(a/(4 alpha (1 + a))) X),   c^2 = 1 + a,   alpha = 1/3
///     Laitone            eta = a S - (3/4) a^2 S (1 - S),  S = sech^2(sqrt(3a/4) (1 - 5a/8) X),
///                        c = 1 + a/2 - 3a^2/20
///     Grimshaw           eta = a s^2 - (3/4) a^2 s^2 q^2 + a^3 ((5/8) s^2 q^2 - (101/80) s^4 q^2),
///                        s = sech, q = tanh of sqrt(3a/4) (1 - 5a/8 + 71 a^2/128) X,
///                        c^2 = 1 + a - a^2/20 - 3a^3/70
///
/// all of the form eta = a S (1 - a (1 - S) (b - a (c - d S))), S = sech^2(K X).
///
/// Depth-averaged velocity of any steady wave: u = c eta/(1 + eta). Crest at x = 0; the wave travels to +x.
/// Profile errors against the exact wave of the Euler equations, in depths at a = 0.1 and 0.2 (order in a): Boussinesq
/// 2.0e-3, 7.1e-3 (2); Rayleigh 1.2e-3, 5.2e-3 (2); Laitone 3.6e-4, 2.9e-3 (3); Grimshaw 1.8e-5, 2.8e-4 (4).
///
/// When not to use it: amplitudes beyond about 0.3 as a reference of the Euler equations; use SolitaryWave.
/// SerreSolitary is exact for the Serre (Green-Naghdi) equations at any amplitude.
///
/// References: Boussinesq (1872), J. Math. Pures Appl. 17, 55; Rayleigh (1876), Phil. Mag. 1, 257; Serre (1953),
/// Houille Blanche 8, 374; Laitone (1960), J. Fluid Mech. 9, 430; Grimshaw (1971), J. Fluid Mech. 46, 611.
#pragma once

#include <cmath>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

/// A steady wave of elevation on still water; see the formulas above.
class AsymptoticSolitary {
 public:
  enum class Theory { boussinesq, rayleigh, laitone, grimshaw };

  /// @param amplitude [m], at most 0.8332 depth but for Rayleigh's wave;  @param depth [m];  @param gravity [m/s^2]
  /// @param alpha  factor of the vertical kinetic energy in Rayleigh's wave, 1/3 for Serre. Throws
  ///               std::invalid_argument.
  explicit AsymptoticSolitary(Theory theory, double amplitude, double depth = 1, double gravity = 1,
                              double alpha = 1.0 / 3);

  /// Elevation [m] at distance x [m] from the crest, or at x at time t of the wave with its crest at x = 0 at t = 0.
  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] double elevation(double x, double t) const { return elevation(x - speed() * t); }
  /// Speed of the crest [m/s].
  [[nodiscard]] double speed() const { return series_.froude * std::sqrt(gravity_ * depth_); }
  /// Mean over the depth of the horizontal velocity [m/s], exact for the mass of a steady wave.
  [[nodiscard]] double depth_averaged_velocity(double x) const;
  /// Area above the still level [m^2].
  [[nodiscard]] double area() const { return profile_area() * depth_ * depth_; }

  [[nodiscard]] double amplitude() const { return ratio_ * depth_; }
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] double gravity() const { return gravity_; }

  [[nodiscard]] double uncertainty() const { return 30 * epsilon; }
  /// Crest height and area of the profile; what a model's conservation laws say beyond them.
  [[nodiscard]] SelfTest self_test() const;

  /// Highest wave of the Euler equations in depths: the series mean nothing beyond.
  static constexpr double highest = 0.8332;

 protected:
  /// K, F = c/sqrt(g depth), the coefficients of the profile, and whether 3 V = (F^2 - 1) M (V potential energy, M
  /// excess mass) holds exactly and not only to the wave's order.
  struct Series {
    double decay, froude;
    double b = 0, c = 0, d = 0;
    bool conserves_momentum = false;
  };

  static Series series_of(Theory theory, double amplitude, double alpha);

  /// Amplitude over depth, and the decay rate K of the profile.
  [[nodiscard]] double ratio() const { return ratio_; }
  [[nodiscard]] double decay() const { return series_.decay; }
  /// eta/depth at x in depths.
  [[nodiscard]] double profile(double x) const;

 private:
  /// Area over depth^2, from the integrals of S, S (1 - S), S^2 (1 - S): 2, 2/3, 4/15.
  [[nodiscard]] double profile_area() const;

  double ratio_, depth_, gravity_;
  Series series_;
};

/// Rayleigh's wave; exact for the equations of Serre, and for those of Frank's discrete model as spacing -> 0.
class SerreSolitary final : public AsymptoticSolitary {
 public:
  explicit SerreSolitary(double amplitude, double depth = 1, double gravity = 1, double alpha = 1.0 / 3)
      : AsymptoticSolitary(Theory::rayleigh, amplitude, depth, gravity, alpha) {}

  /// The place x at which the area of the water from the crest on, depth x + excess_up_to(x) [m^2], is this: equal
  /// steps of it are particles of equal mass.
  [[nodiscard]] double place_of(double water) const;
  /// Integral of the elevation from the crest to x [m^2], and the elevation's derivative, crest at x = 0.
  [[nodiscard]] double excess_up_to(double x) const;
  [[nodiscard]] double elevation_slope(double x) const;
};

/// Periodic travelling wave of Serre's equations (Green and Naghdi's) over a level bottom: cnoidal, exact at any
/// height.
///
/// Seen from the wave the discharge Q per unit of width is constant, and with depths h_c under the crest, h_t under the
/// trough and a third root h_0 < h_t
///
///     h = h_t + (h_c - h_t) cn^2(kappa x | m),   m = (h_c - h_t)/(h_c - h_0),   kappa^2 = 3 (h_c - h_0)/(4 h_0 h_t
///     h_c), Q^2 = g h_0 h_t h_c,   wavelength 2 K(m)/kappa,   mean depth h_0 + (h_c - h_0) E(m)/K(m).
///
/// c is the speed in the frame where the mean of u - (h^3 u_x)_x/(3h) is zero: the velocity along the surface, which
/// Serre's equations transport without sources, as the Euler equations do in StokesWave's frame. u is the mean over the
/// depth, y = 0 the mean level, the crest at x = 0 travels to +x.
///
/// When not to use it: as a wave of the Euler equations, whose dispersion Serre's follow for k depth < 1 or so; waves
/// so long that their crests are solitary (SerreSolitary).
///
/// References: Serre, La Houille Blanche 8 (1953) 374; El, Grimshaw & Smyth, Unsteady undular bores in fully nonlinear
/// shallow-water theory, Phys. Fluids 18 (2006) 027104; Carter & Cienfuegos, The kinematics and stability of solitary
/// and cnoidal wave solutions of the Serre equations, Eur. J. Mech. B 30 (2011) 259.
class SerreCnoidal {
 public:
  /// @param height  from trough to crest [m], at most the depth;  @param wavelength [m];  @param depth  on average [m]
  /// Throws std::invalid_argument: also for crests that are solitary waves to round-off.
  SerreCnoidal(double height, double wavelength, double depth, double gravity);

  /// Above the mean level, at distance x [m] from the crest, or at x at time t.
  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] double elevation(double x, double t) const { return elevation(x - phase_speed() * t); }
  [[nodiscard]] double elevation_slope(double x) const;
  /// Integral of the elevation from the crest to x [m^2], periodic in x.
  [[nodiscard]] double excess_up_to(double x) const;
  /// [m/s], mean over the depth.
  [[nodiscard]] double depth_averaged_velocity(double x) const { return speed_ - discharge_ / (depth_ + elevation(x)); }
  [[nodiscard]] double phase_speed() const { return speed_; }       ///< c [m/s]
  [[nodiscard]] double discharge() const { return discharge_; }     ///< Q [m^2/s], positive
  [[nodiscard]] double height() const { return crest_ - trough_; }  ///< [m]
  [[nodiscard]] double wavelength() const { return wavelength_; }   ///< [m]
  [[nodiscard]] double depth() const { return depth_; }             ///< on average [m]
  [[nodiscard]] double gravity() const { return gravity_; }         ///< [m/s^2]

  // Differences of depths, over the height; the third root is such a difference, and decides the length.
  [[nodiscard]] double uncertainty() const { return 10 * epsilon * (depth_ / height() + depth_ / lowest_); }
  [[nodiscard]] SelfTest self_test() const;

 private:
  struct Elliptic {
    double sn, cn;
  };
  [[nodiscard]] Elliptic at(double x) const;
  /// h'^2 and h'' where the depth is h.
  [[nodiscard]] double slope_squared(double h) const {
    return 3 * (crest_ - h) * (h - trough_) * (h - lowest_) / (lowest_ * trough_ * crest_);
  }
  [[nodiscard]] double curvature(double h) const {
    return 1.5 * ((crest_ - h) * (h - trough_) + (crest_ - h) * (h - lowest_) - (h - trough_) * (h - lowest_)) /
           (lowest_ * trough_ * crest_);
  }

  double wavelength_, depth_, gravity_;
  double modulus_;                  ///< k, m = k^2
  double crest_, trough_, lowest_;  ///< h_c, h_t, h_0
  double kappa_, discharge_, speed_;
};

}  // namespace seiche::exact
