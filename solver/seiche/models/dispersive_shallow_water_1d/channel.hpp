/// What a channel is: its bottom, its ends, and the constants of the model.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "seiche/geometry/bottom_profile.hpp"
#include "seiche/ranges.hpp"
#include "seiche/shallow_water/relations.hpp"

namespace seiche::dispersive_shallow_water_1d {

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
/// bore of the model's equations without waves behind it (shallow_water/relations.hpp), h and c = sqrt(g h) those
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
struct Breaking {
  double onset_slope = 0.577;                                    ///< of the surface, tan 30 degrees
  double ceasing_froude = shallow_water::weakest_breaking_bore;  ///< at least 1
  double share = 1;                                              ///< of the viscosity that leaves no waves

  static constexpr auto ranges() {
    return std::array{Number{"onset_slope", &Breaking::onset_slope, Range::positive()},
                      Number{"ceasing_froude", &Breaking::ceasing_froude, Range{1}},
                      Number{"share", &Breaking::share, Range::positive()}};
  }
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

/// free: an end cell without anything beyond it, a vertical face under no pressure. wall: a vertical wall, the marker
/// slides up and down. tip: the shoreline, a marker that slides on the bottom.
enum class End { free, wall, tip };

/// Kinetic energy of a particle over a sloping bottom. They agree where the bottom is level.
///
///     frank           m (p^2 + alpha r^2)/2, p and r the rates along the bottom's tangent and normal (Frank 1994, 11)
///     green_naghdi    the exact one of a column whose vertical velocity is linear between bed and surface,
///                     m (u^2 + alpha (v - b'u)^2 + b'u (v - b'u) + b'^2 u^2)/2
///
/// The second becomes m (p^2 + alpha r^2)/2 as well, with  p = u sqrt(1 + mu b'^2),  r = v + kappa b'u,
/// kappa = (1 - 2 alpha)/(2 alpha),  mu = alpha - alpha kappa^2  (alpha = 1/3: 1/2 and 1/4). As p and r are then rates
/// of coordinates, of x stretched by the slope and of y + kappa b, nothing else changes.
enum class Kinetics { frank, green_naghdi };

/// Mass of a shoreline marker, whose cell is a triangle of volume V.
///
///     elementary    V/4, the water nearer to it than to its neighbour (Frank 1994)
///     consistent    V/6, with which a plane surface over a plane slope accelerates as it should; converges much faster
enum class TipMass { elementary, consistent };

/// Friction at the bottom of a channel, on the rate p along it at depth H:
///
/// @f[ \dot{p} = - C \frac{|p| \, p}{H} @f]
///
///     manning      C = g n^2/H^(1/3)    n [s/m^(1/3)]; glass 0.009 to 0.01, smooth concrete 0.011 to 0.013
///     quadratic    C = c                c [1], an eighth of the f of Darcy and Weisbach
///
/// Reference: V. T. Chow, Open-Channel Hydraulics, McGraw-Hill (1959), chapter 5.
enum class FrictionLaw { manning, quadratic };

struct Friction {
  FrictionLaw law = FrictionLaw::manning;
  double coefficient = 0;  ///< n or c; 0 for none

  [[nodiscard]] bool active() const { return coefficient > 0; }
  /// C/H [1/m], by which |p| gives the rate of decay.
  [[nodiscard]] double per_length(double gravity, double depth) const;
};

struct Channel {
  std::shared_ptr<const BottomProfile> bottom;
  End left = End::wall;
  End right = End::wall;
  double period = 0;   ///< [m] if positive, the channel is periodic and has no ends
  double gravity = 1;  ///< [m/s^2]
  double density = 1;  ///< [kg/m^3]
  Kinetics kinetics = Kinetics::frank;
  TipMass tip_mass = TipMass::elementary;

  double alpha = 1.0 / 3;  ///< factor of the vertical kinetic energy
  /// Factor of a cell's slope in its potential energy, (mean of y)^2 + slope_energy (difference of y)^2/4; 1/3 is the
  /// polygon's own. The beta of FrankDispersion is (1 - slope_energy)/2.
  double slope_energy = 1.0 / 3;

  /// Improved dispersion: energy (g gamma/2) sum V^s H0^(2-s) (dy)^2/dx^(1+s), to be used with alpha = 1/3 + gamma.
  double gamma = 0;
  double depth_power = 2;      ///< s
  double reference_depth = 1;  ///< H0 [m], without effect for s = 2

  Friction friction = {};                 ///< none, as in Frank's own model
  std::optional<Breaking> breaking = {};  ///< likewise

  /// Throws std::invalid_argument.
  void validate() const;
  [[nodiscard]] bool periodic() const { return period > 0; }

  static constexpr auto ranges() {
    return std::array{Number{"period", &Channel::period, Range::not_negative()},
                      Number{"gravity", &Channel::gravity, Range::positive()},
                      Number{"density", &Channel::density, Range::positive()},
                      Number{"alpha", &Channel::alpha, Range::positive()},
                      Number{"slope_energy", &Channel::slope_energy, Range::finite()},
                      Number{"gamma", &Channel::gamma, Range::not_negative()},
                      Number{"depth_power", &Channel::depth_power, Range::finite()},
                      Number{"reference_depth", &Channel::reference_depth, Range::positive()}};
  }
};

}  // namespace seiche::dispersive_shallow_water_1d
