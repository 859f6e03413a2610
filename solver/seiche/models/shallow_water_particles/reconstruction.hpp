/// What the particles say about the flow at any point: depth and velocity, discontinuous at edges and interior jumps.
#pragma once

#include <optional>
#include <vector>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/models/shallow_water_particles/dry_front.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::shallow_water_particles {

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
