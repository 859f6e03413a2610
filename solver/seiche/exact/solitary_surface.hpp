/// The solved solitary wave in units of the depth and of sqrt(gravity depth): equations in solitary_wave.hpp.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "seiche/exact/cauchy_velocity.hpp"
#include "seiche/exact/clustered_nodes.hpp"
#include "seiche/exact/resolution.hpp"
#include "seiche/exact/spectral_interpolation.hpp"
#include "seiche/exact/velocity.hpp"

namespace seiche::exact {

/// One of the two is given: the height of the crest, or the speed there relative to F.
struct SolitaryCrest {
  std::optional<double> amplitude;
  std::optional<double> speed;
};

/// Elevations y_j on the nodes s_j = j spacing, j = 0..N, and the square of the Froude number.
struct SolitarySolution {
  LineNodes nodes{1, 1};
  double spacing = 0;
  Eigen::VectorXd potential;
  Eigen::VectorXd stretch;
  Eigen::VectorXd elevation;
  Eigen::VectorXd inclination;
  double froude_squared = 1;
  double correction = 0;  ///< last correction of Newton's method
};

/// Root kappa of tan(kappa)/kappa = F^2 in (0, pi/2): the tail decays like exp(-kappa x).
double solitary_decay_rate(double froude_squared);

/// Continuation on coarse nodes, then one solution on fine nodes. Throws std::invalid_argument above the limiting wave.
SolitarySolution solve_solitary_wave(SolitaryCrest crest, Resolution resolution);

class SolitarySurface {
 public:
  SolitarySurface(SolitaryCrest crest, Resolution resolution);

  [[nodiscard]] const SolitarySolution& solution() const { return solution_; }
  [[nodiscard]] double froude() const { return froude_; }
  [[nodiscard]] double amplitude() const { return solution_.elevation[0]; }
  [[nodiscard]] double crest_speed() const { return crest_speed_; }
  [[nodiscard]] double decay_rate() const { return decay_rate_; }

  [[nodiscard]] double elevation(double x) const;
  [[nodiscard]] double potential(double x) const;
  [[nodiscard]] Velocity velocity(double x, double y) const;
  [[nodiscard]] double half_width() const;
  [[nodiscard]] double maximum_slope() const;

  struct Integrals {
    double mass = 0;
    double kinetic_energy = 0;
    double potential_energy = 0;
    double circulation = 0;
  };
  [[nodiscard]] const Integrals& integrals() const { return integrals_; }

 private:
  struct Point {
    double label, x, displacement, elevation, stretch;
  };
  void integrate_position();
  void place_contour();
  [[nodiscard]] Point point(double label) const;
  /// The surface point at x, 0 <= x <= the last node.
  [[nodiscard]] Point find(double x) const;
  [[nodiscard]] std::complex<double> pole(double x, double y) const;

  SolitarySolution solution_;
  double froude_;
  double crest_speed_;
  double decay_rate_;
  double kernel_period_ = 0;         ///< p of the kernel 1/sinh(pi z/p)
  double end_displacement_ = 0;      ///< X(infinity) = C/(2 F)
  Eigen::VectorXd position_;         ///< x_j = phi_j + X_j
  std::vector<double> contour_;      ///< x of the nodes of velocity_: position_ and the flat continuation
  SincInterpolation interpolation_;  ///< of y, X - X(infinity) tanh(s/2), dX/ds
  CauchyVelocity velocity_;
  Integrals integrals_;
};

}  // namespace seiche::exact
