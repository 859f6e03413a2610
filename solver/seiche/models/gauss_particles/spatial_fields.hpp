/// Solenoidal velocity fields in space, v = rot A, with polynomials as vector potentials: small spaces, solved densely.
///
/// The fields of a vector potential depend on A up to a gradient only; linear_spatial_fields() takes one potential for
/// each of the eleven linear solenoidal fields. With these the particles follow the ellipsoids of Dirichlet and
/// Dedekind exactly but for the error in time, however few they are (spatial_model.hpp).
///
/// When not to use it: degrees above four or so, which are ill-conditioned; walls.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/QR>

namespace seiche::gauss_particles {

/// coefficient x^x y^y z^z.
struct SpatialMonomial {
  double coefficient = 1;
  int x = 0;
  int y = 0;
  int z = 0;
};
/// Components of A along x, y, z.
using VectorPotential = std::array<std::vector<SpatialMonomial>, 3>;

/// Potentials of the translations along x, y, z, of the shears (y, 0, 0), (z, 0, 0), (0, x, 0), (0, z, 0), (0, 0, x),
/// (0, 0, y) and of the strains (x, -y, 0), (0, y, -z), in this order.
std::vector<VectorPotential> linear_spatial_fields();

class SpatialFields {
 public:
  /// Throws std::invalid_argument: no potential, negative powers, coefficients not finite.
  explicit SpatialFields(std::vector<VectorPotential> basis = linear_spatial_fields());

  /// At particles q = (x of all, y of all, z of all). Throws mechanics::Infeasible where the fields are linearly
  /// dependent on them.
  void place(std::span<const double> q, std::span<const double> mass);
  /// Replaces the velocities by their projection, orthogonal with the masses as weights.
  void project(std::span<double> u);
  /// Largest defect of the normal equations of the last projection, each divided by the norm of its field, over the
  /// norm of the velocities.
  [[nodiscard]] double residual() const { return residual_; }

 private:
  std::vector<VectorPotential> basis_;
  Eigen::MatrixXd fields_;  // three rows per particle
  Eigen::VectorXd root_mass_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors_;
  double residual_ = 0;
};

}  // namespace seiche::gauss_particles
