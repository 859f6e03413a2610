/// Breaking fronts: where the water gives energy to turbulence.
///
/// A front is a run of neighbouring cells that the motion compresses, -du/dx > 0.0015 c/h: a hundredth of the rate at
/// which Kennedy et al. let breaking end, so that its foot is not where velocities converge by their noise. It begins
/// to break when its surface is somewhere steeper than onset_slope, and goes on until it is no bore any more: until the
/// Froude number of a bore of its depths,
///
/// @f[ Fr = \sqrt{\frac{h_2 (h_1 + h_2)}{2 h_1^2}}, @f]
///
/// h1 at its foot, h2 above h1 by the front's height, falls below ceasing_froude. Water flows through a front: what
/// breaks on is the front that overlaps the one before, cell by cell.
///
/// In cells that break markers exchange horizontal momentum like in a viscous fluid, with the viscosity that leaves a
/// bore of the model's equations without waves behind it (shallow_water/breaking_bore.hpp), h and c = sqrt(g h) those
/// of the cell.
///
/// No experiment enters but for where breaking begins and ends. Mass and momentum decide the depth behind a bore and
/// the energy that it loses, which are those of the hydraulic jump, whatever the viscosity.
///
/// What is left of a broken wave becomes thin. Where markers stand farther apart than the water is deep, going up and
/// down by turns is no wave of the model's but would dry them: there neighbours exchange vertical momentum too, by the
/// factor alpha m omega/2 times their distance over the depth, omega^2 = g/(3 alpha h). It damps this critically where
/// the two are equal and more where the water is thinner, and leaves what is smooth.
///
/// When not to use it: overturning itself, and jets; bores with Fr below ceasing_froude, which are undular; run-up of
/// broken waves without friction, whose thin tongue the light marker at the tip leads too far.
///
/// References: M. Tissier, P. Bonneton, F. Marche, F. Chazel, D. Lannes, Coastal Eng. 67 (2012) 54 (30 degrees, 1.3);
/// A. B. Kennedy, Q. Chen, J. T. Kirby, R. A. Dalrymple, J. Waterway 126 (2000) 39 (viscosity on fronts).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/shallow_water/breaking_bore.hpp"

namespace seiche::dispersive_shallow_water_1d {

struct Breaking {
  double onset_slope = 0.577;                                    ///< of the surface, tan 30 degrees
  double ceasing_froude = shallow_water::weakest_breaking_bore;  ///< at least 1
  double share = 1;                                              ///< of the viscosity that leaves no waves

  /// Throws std::invalid_argument.
  void validate() const;
};

class BreakingFronts {
 public:
  /// What the water does: markers in ascending order, velocities along x, elevations of the bottom. A positive period
  /// joins the last marker to the first one's image.
  struct Surface {
    std::span<const double> x, y, u, bed;
    double gravity;
    double period = 0;
  };

  BreakingFronts(Breaking settings, std::size_t cells) : settings_(settings), damping_(cells, 0.0), were_(cells, 0.0) {}

  /// Finds the fronts that break now, those that broke before included. Returns whether there are any.
  bool find(const Surface& surface);
  /// Of cells, at the last find: nu/(2 sqrt(alpha) h c); 0 where nothing breaks.
  [[nodiscard]] std::span<const double> damping() const { return damping_; }

 private:
  /// Of a run of compressed cells; 0 if it does not break.
  [[nodiscard]] double damping_of_front(const Surface& surface, std::size_t first, std::size_t cells) const;

  Breaking settings_;
  std::vector<double> damping_, were_;
};

}  // namespace seiche::dispersive_shallow_water_1d
