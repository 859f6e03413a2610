/// What the particles say about the flow at any point: depth and velocity, discontinuous at edges and interior jumps.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/models/shallow_water_particles/particles.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

// Edges between particles: linear reconstruction and its prediction to the middle of a step, and the Riemann problem.

/// Depth and velocity at both edges of every particle.
struct EdgeValues {
  Array left_depth;
  Array right_depth;
  Array left_velocity;
  Array right_velocity;

  [[nodiscard]] std::array<Array*, 4> all() { return {&left_depth, &right_depth, &left_velocity, &right_velocity}; }
  void resize(std::size_t count) {
    for (Array* a : all()) a->resize(count);
  }
};

/// The same for one particle.
struct EdgePair {
  double h_left, h_right, u_left, u_right;
};

/// Slope limited by the differences to both neighbours, which lie at distances `back` and `ahead`.
inline double slope(double before, double own, double after, double back, double ahead, double theta) {
  return shallow_water::limited_slope((own - before) / back, (after - before) / (back + ahead), (after - own) / ahead,
                                      theta);
}

/// Edge values after half a step [tau/2] of a particle on a flat bed: depths follow the width, velocities the pressure
/// difference and the acceleration. A width that would change by more than a factor 5 is left alone.
inline EdgePair predict(double gravity, EdgePair now, double width, double inv_mass, double half_step,
                        double acceleration) {
  const double stretched = width + half_step * (now.u_right - now.u_left);
  const bool sane = stretched > 0.2 * width && stretched < 5 * width;
  const double ratio = sane ? width / stretched : 1.0;
  const double kick =
      half_step * (inv_mass * 0.5 * gravity * (now.h_left - now.h_right) * (now.h_left + now.h_right) + acceleration);
  return {now.h_left * ratio, now.h_right * ratio, now.u_left + kick, now.u_right + kick};
}

// Riemann problem at an edge with a fixed number of Newton steps and no branches: the loop over edges vectorises.
//
// In mass coordinates the left wave always goes left and the right wave right, so the edge lies in the middle state:
// no sonic points, no entropy fix. Conservation does not depend on the number of steps. Error after n = 0, 1, 2, 3
// steps for jumps below a factor 2: 2.7e-2, 6.7e-5, 4.2e-10, 8e-15; for ratios to 100, 4 steps reach 4e-15.
//
// When not to use it: for one problem at a time, where shallow_water::star_state iterates to round-off.
// Source: Toro, Shock-capturing methods for free-surface shallow flows (2001), ch. 6.

/// Velocity [m/s] and thrust g h*^2/2 [m^3/s^2] of an edge.
struct EdgeState {
  double velocity;
  double thrust;
};

/// Solves f_L(h) + f_R(h) + u_R - u_L = 0 by four Newton steps from the depth that two simple waves would give.
/// Depths must be positive; when the middle dries, the thrust is zero to round-off.
inline EdgeState edge_state(double gravity, double h_left, double u_left, double h_right, double u_right) {
  const double c_left = std::sqrt(gravity * h_left);
  const double c_right = std::sqrt(gravity * h_right);
  const double sum = c_left + c_right;
  const double two_waves = 0.5 * sum + 0.25 * (u_left - u_right);
  const double floor = 1e-9 * sum;
  double c = two_waves > floor ? two_waves : floor;
  double h = c * c / gravity;
  const double inv_left = 1 / h_left;
  const double inv_right = 1 / h_right;

  // f and its derivative at h for the side with depth h_side: jump where h is above it, simple wave otherwise.
  const auto wave = [&](double inv, double h_side, double c_side, double inv_h, double& slope) {
    const double q = std::sqrt(0.5 * gravity * (inv_h + inv));
    const double rise = h - h_side;
    const bool jump = rise > 0;
    slope = jump ? q - 0.25 * gravity * rise * inv_h * inv_h / q : c * inv_h;
    return jump ? rise * q : 2 * (c - c_side);
  };
  for (int k = 0; k < 4; ++k) {
    const double inv_h = 1 / h;
    double slope_left = 0;
    double slope_right = 0;
    const double f_left = wave(inv_left, h_left, c_left, inv_h, slope_left);
    const double f_right = wave(inv_right, h_right, c_right, inv_h, slope_right);
    const double next = h - (f_left + f_right + u_right - u_left) / (slope_left + slope_right);
    h = next > 0.1 * h ? next : 0.1 * h;
    c = std::sqrt(gravity * h);
  }
  const double inv_h = 1 / h;
  double unused = 0;
  const double f_left = wave(inv_left, h_left, c_left, inv_h, unused);
  const double f_right = wave(inv_right, h_right, c_right, inv_h, unused);
  return {0.5 * (u_left + u_right) + 0.5 * (f_right - f_left), 0.5 * gravity * h * h};
}

// The particle at a front that runs over a dry flat bed.
//
// Between the rectangle it starts from and the parabola of the developed tip (Ritter 1892) the depth in the front
// particle is taken as h(s) = h_e (s/w)^pi, s the distance from the front, with the simple wave u(s) = u_f - 2 c(s)
// on it. The exponent follows from the two means the particle carries, so there is no branch in time, and the front
// itself moves with the constant u_f: its position is exact for any number of particles.
//
// When not to use it: on a sloping bed, where the front accelerates (a shoreline with linear reconstruction there).

/// Profile in a front particle, seen with the dry bed ahead (velocities positive towards it).
struct TipProfile {
  double exponent = 0;        ///< pi in [0, 2]
  double edge_depth = 0;      ///< h_e at the inner edge [m]
  double front_velocity = 0;  ///< u_f [m/s]

  /// State at the fraction `s` in [0,1] of the width behind the front.
  [[nodiscard]] shallow_water::State at(double gravity, double s) const;
};

/// Profile with the means (depth, velocity) of the particle; the exponent is clamped to [0,2] and the edge depth to
/// [depth, highest].
TipProfile tip_profile(double gravity, shallow_water::State mean, double front_velocity, double highest);

/// Stretch [left, right] of one particle over which the reconstruction is smooth: surface (depth on a flat bed) and
/// velocity are linear, or follow the tip profile at a dry front.
struct Piece {
  double left = 0;
  double right = 0;
  double surface_left = 0;
  double surface_right = 0;
  double velocity_left = 0;
  double velocity_right = 0;
  std::optional<TipProfile> tip;
  bool tip_on_right = true;
};

using shallow_water::State;

class Reconstruction {
 public:
  /// @param pieces  from left to right, touching
  Reconstruction(double gravity, std::vector<Piece> pieces, std::optional<Bed> bed);

  /// Depth [m] and velocity [m/s] at x; depth 0 and velocity 0 outside the water. At a discontinuity, its right state.
  [[nodiscard]] State at(double x) const;

  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  [[nodiscard]] double left_end() const { return pieces_.front().left; }
  [[nodiscard]] double right_end() const { return pieces_.back().right; }

 private:
  double gravity_;
  std::vector<Piece> pieces_;
  std::optional<Bed> bed_;
};

}  // namespace seiche::shallow_water_particles
