/// What the particles say about the flow at any point: depth and velocity, discontinuous at edges and interior jumps.
#pragma once

#include <optional>
#include <vector>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

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

/// Ratio (u_f - u)/(2 c) of the particle's means for exponent pi: (pi+1)^(3/2)/(1.5 pi + 1).
double tip_velocity_ratio(double exponent);

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
