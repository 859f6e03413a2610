/// Standing waves of the two-dimensional Lagrangian mesh between two vertical walls, and their frequency.
/// Depth, gravity and density are 1.
#pragma once

#include <numbers>

#include <cstddef>
#include <memory>
#include <vector>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/models/lagrangian_mesh_2d/flow.hpp"
#include "validation/instruments/harmonic_fit.hpp"

namespace seiche::validation {

/// A tank that holds a whole number of half-waves, its mesh, and how it is stepped.
struct MeshTank {
  double wavenumber = 1;
  std::size_t columns = 32;  ///< of the tank
  std::size_t rows = 8;
  std::size_t half_waves = 1;
  double tau = 0.05;
  lagrangian_mesh_2d::Scheme scheme = {};
  double hourglass = 0;
  bool tuned_surface_inertia = false;

  /// Number of columns of about `width` in a tank.
  static std::size_t columns_of(double wavenumber, double width, std::size_t half_waves = 1);

  [[nodiscard]] double length() const { return std::numbers::pi * static_cast<double>(half_waves) / wavenumber; }
  [[nodiscard]] double column_width() const { return length() / static_cast<double>(columns); }
  /// Law of the semi-discrete model without hourglass potential.
  [[nodiscard]] exact::LagrangianMeshDispersion law() const;
  /// Frequency of the smallest waves by that law and the time step's; not for compositions.
  [[nodiscard]] double linear_frequency() const;
  [[nodiscard]] lagrangian_mesh_2d::Settings settings() const;
};

/// Part of the surface's elevations in the wave of the tank, over the nodes' labels. With columns of equal area it is
/// orthogonal to all other waves.
double mode_amplitude(const MeshTank& tank, const lagrangian_mesh_2d::Flow& flow);

/// A wave of small amplitude. It starts from the flat surface, so that areas and masses are exactly those of water at
/// rest, by an impulse on the surface that has the wave's shape: such an impulse excites nothing else.
Oscillation small_oscillation(const MeshTank& tank, double amplitude, double periods);

/// The frequency of infinitely small waves: from this amplitude and twice it, extrapolated in their squares.
double smallest_wave_frequency(const MeshTank& tank, double periods, double amplitude = 1e-5);

/// Water at rest with the second-order surface of Tadjbakhsh and Keller's standing wave at its highest, in columns of
/// equal area.
std::unique_ptr<lagrangian_mesh_2d::Flow> finite_standing_wave(const MeshTank& tank, double amplitude);
/// Its amplitude in the mode at t = 0, tau, ... until `time`, and its frequency: harmonics 1 and 3, since half a period
/// later the wave is its own mirror image.
std::vector<double> finite_series(const MeshTank& tank, double amplitude, double time);
Oscillation finite_oscillation(const MeshTank& tank, double amplitude, double time);
inline const std::vector<int> harmonics_of_mode{1, 3};

}  // namespace seiche::validation
