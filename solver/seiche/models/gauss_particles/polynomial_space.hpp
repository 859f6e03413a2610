/// Velocity fields whose stream function is a combination of given polynomials: small spaces, solved densely.
///
/// With the five of degree 1 and 2 the fields are all linear ones, and particles follow Dirichlet's ellipse exactly but
/// for the error in time, however few they are. Leaving out x^2 + y^2 leaves out the rotation, and the angular momentum
/// is no longer kept.
///
/// When not to use it: degrees above four or so, which are ill-conditioned; walls.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "seiche/models/gauss_particles/field_space.hpp"

namespace seiche::gauss_particles {

/// coefficient x^x y^y.
struct Monomial {
  double coefficient = 1;
  int x = 0;
  int y = 0;
};
using StreamFunction = std::vector<Monomial>;

inline double power(double z, int exponent) {
  double value = 1;
  for (int k = 0; k < exponent; ++k) value *= z;
  return value;
}

/// Stream functions of the translations, the rotation and the two strains, in this order: y, -x, -(x^2 + y^2)/2, x y,
/// (y^2 - x^2)/2.
std::vector<StreamFunction> linear_fields();

class PolynomialSpace final : public FieldSpace {
 public:
  /// Throws std::invalid_argument: no stream function, negative powers, coefficients not finite.
  explicit PolynomialSpace(std::vector<StreamFunction> basis = linear_fields());

  /// Throws mechanics::Infeasible where the fields are linearly dependent on the particles.
  void place(mechanics::Interval when, std::span<const double> x, std::span<const double> y,
             std::span<const double> mass, double penalty) override;
  using FieldSpace::project;
  void project(std::span<double> u, std::span<double> v, std::span<const double> impulse_x,
               std::span<const double> impulse_y) override;
  [[nodiscard]] std::span<const std::uint8_t> free() const override { return {}; }
  [[nodiscard]] const SpaceFacts& facts() const override { return facts_; }
  [[nodiscard]] double resolution() const override { return 0; }

 private:
  std::vector<StreamFunction> basis_;
  Eigen::MatrixXd fields_;  // two rows per particle
  Eigen::VectorXd root_mass_, w_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors_;
  SpaceFacts facts_;
};

}  // namespace seiche::gauss_particles
