/// The background lattice on which stream functions are splines, and how it follows the water.
///
/// Heights are counted from the bottom where there is one: the stream function is Phi(x, eta), eta = y - b(x), and the
/// velocity (Phi_eta, -Phi_x + b' Phi_eta), solenoidal and along the bottom at eta = 0. Every conservation law of the
/// method holds step by step: the lattice may be another one at every step, moved, shifted at random, refined, grown.
///
/// When not to use it: bottoms with corners, at which the velocities would jump. Over an uneven bottom linear velocity
/// fields are not in the space.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/mechanics/constrained_model.hpp"
#include "seiche/models/gauss_particles/spline_axis.hpp"

namespace seiche::gauss_particles {

/// b(x) with a continuous slope, or level.
struct Ground {
  double level = 0;                                        ///< b of a level bottom; 0 where there is none [m]
  std::shared_ptr<const BottomProfile> profile = nullptr;  ///< uneven bottom, instead of the level
};

struct Lattice {
  SplineAxis x;
  SplineAxis y;  ///< along eta
};

/// The rectangle of the particles; heights above the ground.
struct Bounds {
  double left = 0;
  double right = 0;
  double low = 0;
  double high = 0;
};

/// The lattice of a step: that which begins at when.begin and in whose middle the water is within the bounds.
using LatticeAt = std::function<Lattice(mechanics::Interval when, const Bounds& water)>;

/// Empty cells between the water and a free end of a lattice, at least.
inline constexpr long free_margin = 2;

/// A lattice of given cells between walls and around the water where there is none.
struct LatticePlan {
  int degree = 3;
  double cell_x = 0.1;  ///< [m]
  double cell_y = 0;    ///< [m]; 0: as cell_x
  std::optional<double> left_wall = {};
  std::optional<double> right_wall = {};
  /// [m]; of the periodic channel that begins at left_wall, or at 0. Instead of walls.
  double period = 0;
  bool bottom = false;  ///< a wall at eta = 0
  Ground ground = {};
  bool shift =
      false;  ///< moves the lattice along directions without walls, by another random part of a cell at each step
  std::uint64_t seed = 1;

  /// Throws std::invalid_argument with name, value and range: cells not positive, walls or a period that are not a
  /// whole number of cells apart, walls in a periodic channel, a bottom with a corner.
  void check() const;
  /// The lattice for water within the bounds. The shift depends on the middle of the interval and the seed alone.
  [[nodiscard]] Lattice operator()(mechanics::Interval when, const Bounds& water) const;
};

/// Throws std::invalid_argument, with the place, where the slope of a profile jumps within [begin, end].
void require_continuous_slope(const BottomProfile& profile, double begin, double end);

}  // namespace seiche::gauss_particles
