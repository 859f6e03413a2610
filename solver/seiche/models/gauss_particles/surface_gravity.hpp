/// Gravity as a force on the surface: the potential energy of the water below the line of markers.
///
/// @f[ \Pi = \rho g \int \frac{y^2}{2} \, dx = \rho g \sum_{ab} \frac{(x_b - x_a)(y_a^2 + y_a y_b + y_b^2)}{6} @f]
///
/// over the pieces ab of the line, y counted from the still-water level y = 0. Its forces act on the markers, and by
/// the fields on the water. Sums m g y over particles are no exact integrals: an eddy inside, which moves no marker,
/// meets forces of gravity there, and the smallest eddies grow. Here it meets none: five periods of a wave of moderate
/// height need no penalty. What this costs: Pi is cubic and markers have no mass, so that the energy errs by O(tau^2);
/// with `exact_energy` the force is the discrete gradient of Pi over the markers' way, and the energy is exact again.
/// The momentum along x is exact either way, for Pi does not change when all markers move along x together.
///
/// Take the inner cells 0.9 full (SplineSpace::Settings): functions that hang on fewer particles are pushed by the
/// line but hardly weighed by the particles. Waves of 90 per cent of the greatest height need ten particles to a cell's
/// side, or the penalty: with either, and 24 cells to a wavelength, the surface is off by 0.8 per cent of the height
/// after five periods. Masses fitted to the moments of cut cells at the beginning are no cure, for the water carries
/// them to other cells.
///
/// When not to use it: fewer than six particles to a cell's side or masses that are not end-corrected (particles.hpp),
/// with which line and particles part; surfaces that meet themselves; fewer than ten markers to a cell; dissipative
/// stepping, which would have no force.
///
/// Reference for the discrete gradient: McLachlan, Quispel & Robidoux, Phil. Trans. R. Soc. A 357 (1999) 1021.
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
  /// The force is the mean over the markers' way, found by iteration: the energy is exact, at the cost of some more
  /// solutions with the factors of the step; the phase lags by (omega tau)^2/12 instead of leading by as much.
  bool exact_energy = false;
};

class SurfaceGravity {
 public:
  /// @param weight  rho g. Throws std::invalid_argument: fewer than two markers, a negative period.
  SurfaceGravity(SurfaceLine line, const Particles& particles, double weight);

  /// The particles that are the line.
  [[nodiscard]] std::span<const std::size_t> markers() const { return markers_; }
  /// Pi at q = (x of all, y of all) [J/m].
  [[nodiscard]] double energy(std::span<const double> q) const;
  /// impulse -= h dPi/dq.
  void push(std::span<const double> q, double h, std::span<double> impulse) const;
  /// As push, with the mean of dPi/dq over the straight way from q0 to q1: its product with q1 - q0 is the difference
  /// of Pi, to round-off.
  void push_between(std::span<const double> q0, std::span<const double> q1, double h, std::span<double> impulse);

 private:
  template <class Visit>
  void each_piece(std::span<const double> q, Visit&& visit) const;

  double period_;
  double weight_;
  std::vector<std::size_t> markers_;
  std::vector<double> middle_;
};

}  // namespace seiche::gauss_particles
