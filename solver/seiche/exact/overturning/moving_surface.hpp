/// The computed motion of a free surface in the units of its user, from its start to its end: what every wave that may
/// overturn can be asked.
///
/// Lengths are scaled by 1/k (k = 2 pi/wavelength), times by 1/sqrt(g k).
///
/// When not to use it: after touch-down.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "seiche/exact/reference_solution.hpp"

namespace seiche::exact::overturning {

class Evolution;

class MovingSurface {
 public:
  /// Points of the surface along one wavelength, in the order of the surface, with potential [m^2/s] and velocity
  /// [m/s].
  struct Profile {
    double time = 0;
    std::vector<double> x, y, potential, u, v;
  };
  /// At the markers or, where `points` is not 0, at so many points of equal arc length of the trigonometric
  /// interpolant, the first and last one wavelength apart. Throws std::invalid_argument for a time before 0 or after
  /// last_time, Divergence for one after the motion ended.
  [[nodiscard]] Profile profile(double t, std::size_t points = 0) const;

  /// Highest and lowest elevation [m].
  struct Extremes {
    double highest, lowest;
  };
  [[nodiscard]] Extremes extremes(double t) const;

  /// Largest magnitude of the surface's curvature [1/m].
  [[nodiscard]] double largest_curvature(double t) const;

  /// Nose of the jet and throat of the cavity below it, where the surface is vertical [m], and the least distance
  /// between the outer half of the jet and the water ahead [m]; none while the surface is a graph.
  struct Jet {
    double nose_x, nose_y, throat_x, throat_y, gap;
  };
  [[nodiscard]] std::optional<Jet> jet(double t) const;

  /// First time with a vertical tangent [s]; none if not before end_time().
  [[nodiscard]] std::optional<double> vertical_tangent_time() const { return vertical_tangent_time_; }
  /// When the gap closes [s]: extrapolated linearly from its last values that the markers resolve, less than a
  /// twentieth of a wavelength apart; none if the gap is not that small in the computed motion.
  [[nodiscard]] std::optional<double> touch_down_time() const { return touch_down_time_; }
  /// Last time computed [s]: last_time, or when the time step or the resolution collapsed.
  [[nodiscard]] double end_time() const;
  /// Why the motion ended before last_time; empty if it did not.
  [[nodiscard]] std::string ending_reason() const;
  [[nodiscard]] std::size_t steps() const;

  /// Per wavelength, for density 1: volume above the level at rest [m^2], kinetic and potential energy [m^4/s^2],
  /// horizontal impulse [m^3/s].
  struct Integrals {
    double volume, kinetic_energy, potential_energy, impulse;
  };
  [[nodiscard]] Integrals integrals(double t) const;

  /// Until when a jet, if there is one, is developed and not yet thin [s].
  [[nodiscard]] double well_resolved_until() const { return well_resolved_until_; }
  /// Hausdorff distance of the surface from that of another motion of the same wavelength [m].
  [[nodiscard]] double distance_from(const MovingSurface& other, double t) const;

 protected:
  MovingSurface(double wavelength, double gravity);

  /// Takes over a motion that is complete, in scaled units. @param last_time  asked for [s]
  /// @param jet_time  for how long after the first vertical tangent the surface is well resolved, from the time of that
  ///                  tangent [s]
  void keep(std::shared_ptr<const Evolution> evolution, double last_time,
            const std::function<double(double tangent)>& jet_time);

  [[nodiscard]] const Evolution& evolution() const { return *evolution_; }
  [[nodiscard]] double length() const { return length_; }      ///< 1/k [m]
  [[nodiscard]] double time_unit() const { return time_; }     ///< 1/sqrt(g k) [s]
  [[nodiscard]] double velocity() const { return velocity_; }  ///< sqrt(g/k) [m/s]
  /// Identities of any motion up to well_resolved_until(): volume is conserved, energy and horizontal impulse change by
  /// what a pressure on the surface does, if there is one.
  ///
  /// @param amplitude  of the surface [m];  @param tolerance  of a step, in units of 1/k;  @param first  of the start
  [[nodiscard]] SelfTest balances(double amplitude, double tolerance, const std::optional<Identity>& first) const;
  /// A time between 0 and the end, scaled. Throws as profile does.
  [[nodiscard]] double scaled_time(double t) const;

 private:
  void find_touch_down();

  double length_, time_, velocity_;
  double last_time_ = 0;
  double well_resolved_until_ = 0;
  std::shared_ptr<const Evolution> evolution_;
  std::optional<double> vertical_tangent_time_;
  std::optional<double> touch_down_time_;
};

}  // namespace seiche::exact::overturning
