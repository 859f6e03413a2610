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
#pragma once

#include <cmath>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact {

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
