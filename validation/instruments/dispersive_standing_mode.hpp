/// Standing waves of the dispersive shallow-water model between two vertical walls, and their frequency.
#pragma once

#include <numbers>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/exact/standing_wave.hpp"
#include "seiche/models/dispersive_shallow_water_1d/flow.hpp"
#include "validation/instruments/harmonic_fit.hpp"

namespace seiche::validation {

/// A whole number of half-waves on level water, in equal cells, and how it is stepped.
struct StandingBox {
  double wavenumber = 1;   ///< [1/m]
  std::size_t cells = 32;  ///< of the box
  std::size_t half_waves = 1;
  double tau = 0.05;  ///< [s]
  dispersive_shallow_water_1d::Scheme scheme = {};
  double alpha = 1.0 / 3;
  double slope_energy = 1.0 / 3;
  double gamma = 0;
  double depth_power = 2;
  double depth = 1;    ///< [m]
  double gravity = 1;  ///< [m/s^2]

  /// Number of cells with which one half-wave has cells of about `spacing`.
  static std::size_t cells_of(double wavenumber, double spacing);

  [[nodiscard]] double length() const { return std::numbers::pi * static_cast<double>(half_waves) / wavenumber; }
  [[nodiscard]] double spacing() const { return length() / static_cast<double>(cells); }
  [[nodiscard]] dispersive_shallow_water_1d::Channel channel() const;

  /// Law of the semi-discrete model. Its beta multiplies 1 - cos ks in the potential energy, which for a cell of slope
  /// energy b is  cos^2 + b sin^2 = 1 - (1 - b) sin^2  of ks/2:  beta = (1 - b)/2.
  [[nodiscard]] exact::FrankDispersion law() const;
  /// Frequency of the smallest waves by that law and the time step's; not for compositions.
  [[nodiscard]] double linear_frequency() const;
  [[nodiscard]] exact::DispersiveStandingWave::Parameters wave_parameters() const;
};

/// A wave of small amplitude. It starts from the flat surface, so that cells and masses are exactly those of water at
/// rest, with the velocities of the mode,  v = omega a cos kx,  u = -omega a (s/2H) cot(ks/2) sin kx.
Oscillation small_oscillation(const StandingBox& box, double amplitude, double periods);

/// The frequency of infinitely small waves: from this amplitude and twice it, extrapolated in their squares.
double smallest_wave_frequency(const StandingBox& box, double periods, double relative_amplitude = 1e-5);

/// A wave of finite amplitude. It starts at rest at its highest with the second-order surface of
/// exact::DispersiveStandingWave, in cells of equal volume.
Oscillation finite_oscillation(const StandingBox& box, double amplitude, double periods);

/// The box, if no wave between its markers is too fast for its step: omega tau <= 2, with omega^2 <= (g/H) max(1,
/// beta + 4 gamma (H/s)^2)/alpha whatever the wave. Beyond it the one-step scheme is unstable, and the sweeps of the
/// conservative one need not converge. Throws std::invalid_argument.
inline StandingBox stable(StandingBox box) {
  const double slope = 2 * box.depth / box.spacing();
  const double stiffness = std::max(1.0, box.slope_energy + box.gamma * slope * slope) / box.alpha;
  const double longest = 2 / std::sqrt(box.gravity / box.depth * stiffness);
  if (box.tau <= longest) return box;
  throw std::invalid_argument(
      fmt::format("tau = {:g} is out of range: must not exceed {:.4g} with alpha = {:g}, gamma = {:g} and nodes {:.3g} "
                  "apart, or the shortest waves grow",
                  box.tau, longest, box.alpha, box.gamma, box.spacing()));
}

}  // namespace seiche::validation
