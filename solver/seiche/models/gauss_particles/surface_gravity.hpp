/// Gravity as a force on the surface: the potential energy of the water below the line of markers.
///
/// @f[ \Pi = \rho g \int \frac{y^2}{2} \, dx = \rho g \sum_{ab} \frac{(x_b - x_a)(y_a^2 + y_a y_b + y_b^2)}{6} @f]
///
/// over the pieces ab of the line, y counted from the still-water level y = 0. Its forces act on the markers, and by
/// the fields on the water. Sums m g y over particles are no exact integrals: an eddy inside, which moves no marker,
/// meets forces of gravity there, and the smallest eddies grow. Here it meets none: five periods of a wave of moderate
/// height need no penalty. What this costs: the energy is no longer exact, for Pi is cubic and markers have no mass.
///
/// When not to use it: the steepest waves; fewer than six particles to a cell's side or masses that are not
/// end-corrected (particles.hpp), with which line and particles part; surfaces that meet themselves; fewer than ten
/// markers to a cell.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "seiche/models/gauss_particles/particles.hpp"

namespace seiche::gauss_particles {

/// The markers, in their order and with the water on their right-hand side, are the surface.
struct SurfaceLine {
  double period =
      0;  ///< of a periodic channel: the line goes on from its last marker to the first [m]; 0: it ends there
};

class SurfaceGravity {
 public:
  /// @param weight  rho g. Throws std::invalid_argument: fewer than two markers, a negative period.
  SurfaceGravity(SurfaceLine line, const Particles& particles, double weight);

  /// Pi at q = (x of all, y of all) [J/m].
  [[nodiscard]] double energy(std::span<const double> q) const;
  /// impulse -= h dPi/dq.
  void push(std::span<const double> q, double h, std::span<double> impulse) const;

 private:
  template <class Visit>
  void each_piece(std::span<const double> q, Visit&& visit) const;

  double period_;
  double weight_;
  std::vector<std::size_t> markers_;
};

}  // namespace seiche::gauss_particles
