/// Small standing waves of the plan model in a box between four walls: their frequencies from the linearised model, and
/// from runs.
#pragma once

#include <cmath>

#include <cstddef>
#include <span>
#include <string>

#include "seiche/exact/lattice_dispersion.hpp"
#include "seiche/models/dispersive_shallow_water_2d/model.hpp"

namespace seiche::validation {

struct PlanTank {
  std::size_t columns = 12;
  std::size_t rows = 12;
  double length = 6;  ///< along x [m]
  double width = 6;
  double depth = 1;
  double gravity = 1;
  double inertia = 1.0 / 3;
  double gamma = 0;  ///< of improved dispersion

  /// Of the lattice, without improved dispersion.
  [[nodiscard]] exact::PlanDispersion law() const;
  /// omega [1/s] in closed form, with improved dispersion.
  [[nodiscard]] double frequency(double kx, double ky) const;
  [[nodiscard]] std::string text() const;  ///< "12 x 12 cells"
};

/// cos(kx x) cos(ky y) with whole numbers of half-waves between the walls.
class PlanMode {
 public:
  PlanMode(const PlanTank& tank, std::size_t half_waves_x, std::size_t half_waves_y);

  [[nodiscard]] double kx() const { return kx_; }
  [[nodiscard]] double ky() const { return ky_; }
  /// Of the closed form.
  [[nodiscard]] double linear_frequency() const { return tank_.frequency(kx_, ky_); }
  [[nodiscard]] double at(double x, double y) const { return std::cos(kx_ * x) * std::cos(ky_ * y); }

  /// What the linearised model makes of the mode: omega^2, and the largest vertical acceleration off the mode's shape,
  /// over omega^2. No run, no amplitude: forces are linear in z but for terms that change no sign with it, so that half
  /// the difference of those at elevations of either sign is the linearised one.
  struct Eigenvalue {
    double square = 0;
    double rest = 0;
  };
  [[nodiscard]] Eigenvalue eigenvalue() const;

  /// Frequency in a run of the one-step scheme, by frequency_of().
  /// @param amplitude  of the first velocity [m/s]
  [[nodiscard]] double measured_frequency(double tau, int steps, double amplitude = 1e-6) const;

 private:
  [[nodiscard]] dispersive_shallow_water_2d::Lattice lattice() const;
  /// Amplitude of values on the nodes, nodes on walls with half their weight.
  [[nodiscard]] double amplitude(const dispersive_shallow_water_2d::Lattice& lattice,
                                 std::span<const double> values) const;

  PlanTank tank_;
  double kx_, ky_;
};

}  // namespace seiche::validation
