/// The solved Stokes wave in units of 1/k and sqrt(gravity/k): equations in stokes_wave.hpp.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "seiche/exact/cauchy_velocity.hpp"
#include "seiche/exact/clustered_nodes.hpp"
#include "seiche/exact/resolution.hpp"
#include "seiche/exact/spectral_interpolation.hpp"
#include "seiche/exact/velocity.hpp"

namespace seiche::exact {

/// One of the two is given: half the height, or the speed at the crest relative to c.
struct StokesCrest {
  std::optional<double> amplitude;
  std::optional<double> speed;
};

/// tau = log q on the nodes s_j = pi j/m, j = 0..m, and the square of the phase speed.
struct StokesSolution {
  PeriodicNodes nodes{1};
  Eigen::VectorXd potential;
  Eigen::VectorXd stretch;
  Eigen::VectorXd log_speed;
  Eigen::VectorXd inclination;
  double speed_squared = 1;
  double conformal_depth = 0;
  double correction = 0;  ///< last correction of Newton's method

  [[nodiscard]] double amplitude() const;
};

/// Continuation in the crest's speed from a linear wave, or from `nearby` where one is given. Throws
/// std::invalid_argument above the limiting wave.
StokesSolution solve_stokes_wave(StokesCrest crest, double conformal_depth, Resolution resolution,
                                 const StokesSolution* nearby = nullptr);

class StokesSurface {
 public:
  explicit StokesSurface(StokesSolution solution);
  /// With the mean depth in place of the conformal depth: secant iteration.
  static StokesSurface with_mean_depth(StokesCrest crest, double mean_depth, Resolution resolution);

  [[nodiscard]] const StokesSolution& solution() const { return solution_; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] double bernoulli() const { return bernoulli_; }
  [[nodiscard]] double mean_depth() const { return mean_depth_; }
  [[nodiscard]] double crest() const { return elevation_[0]; }
  [[nodiscard]] double trough() const { return elevation_[elevation_.size() - 1]; }

  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] double potential(double x) const;
  [[nodiscard]] Velocity velocity(double x, double y) const;
  [[nodiscard]] double maximum_slope() const;

  struct Integrals {
    double impulse = 0;
    double kinetic_energy = 0;
    double potential_energy = 0;
  };
  [[nodiscard]] const Integrals& integrals() const { return integrals_; }

 private:
  struct Point {
    double label, x, elevation, stretch;
  };
  void integrate_position();
  void place_contour();
  [[nodiscard]] Point point(double label) const;
  /// The surface point at x, 0 <= x <= pi.
  [[nodiscard]] Point find(double x) const;
  [[nodiscard]] bool bottom_matters() const;

  StokesSolution solution_;
  double speed_;
  double bernoulli_ = 0;
  double mean_depth_ = 0;
  Eigen::VectorXd elevation_;
  Eigen::VectorXd position_;                  ///< x_j
  TrigonometricInterpolation interpolation_;  ///< of y, x - s, dx/ds
  CauchyVelocity velocity_;
  Integrals integrals_;
};

}  // namespace seiche::exact
