/// The space N of smooth solenoidal velocity fields onto which the particles' velocities are projected.
///
/// A space belongs to a set of places; it may be another one at every step. What the method conserves follows from what
/// it holds: energy from nothing, a momentum from the translation, the angular momentum from the rotation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "seiche/mechanics/constrained_model.hpp"

namespace seiche::gauss_particles {

/// What a space tells of its last step.
struct SpaceFacts {
  std::size_t unknowns = 0;
  std::size_t inner_cells = 0;     ///< at least half full or so; 0 for spaces without a lattice
  std::size_t free_particles = 0;  ///< with a mass, that fly freely, being spray thinner than a cell
  /// Largest defect of the normal equations, each divided by the norm of its field, over the norm of the velocities.
  double residual = 0;
  /// Half of the kinetic energy that the penalty takes in the step [J/m].
  double penalty = 0;
};

class FieldSpace {
 public:
  FieldSpace() = default;
  FieldSpace(const FieldSpace&) = delete;
  FieldSpace& operator=(const FieldSpace&) = delete;
  FieldSpace(FieldSpace&&) = delete;
  FieldSpace& operator=(FieldSpace&&) = delete;
  virtual ~FieldSpace() = default;

  /// The space for the step `when` with particles at these places; massless ones are markers.
  /// @param penalty  C g^(1/2) tau/2 [m^(1/2)], the factor of h^(7/2) (spline_space.hpp)
  /// Throws mechanics::Infeasible, linear::NotPositiveDefinite.
  virtual void place(mechanics::Interval when, std::span<const double> x, std::span<const double> y,
                     std::span<const double> mass, double penalty) = 0;
  /// Replaces velocities by their projection, orthogonal with the masses as weights; markers get the field's.
  /// Throws mechanics::Infeasible when the normal equations are not solved.
  void project(std::span<double> u, std::span<double> v) { project(u, v, {}, {}); }
  /// As project, with impulses [kg/s] on the particles, massless ones too, besides their momenta; empty: none.
  virtual void project(std::span<double> u, std::span<double> v, std::span<const double> impulse_x,
                       std::span<const double> impulse_y) = 0;
  /// Of every particle of the last place: whether it flies freely. Empty: none does.
  [[nodiscard]] virtual std::span<const std::uint8_t> free() const = 0;
  [[nodiscard]] virtual const SpaceFacts& facts() const = 0;
  /// The shortest length that fields of the space resolve [m]; 0: unknown.
  [[nodiscard]] virtual double resolution() const = 0;
};

// Velocity fields whose stream function is a combination of given polynomials: small spaces, solved densely.
//
// With the five of degree 1 and 2 the fields are all linear ones, and particles follow Dirichlet's ellipse exactly but
// for the error in time, however few they are. Leaving out x^2 + y^2 leaves out the rotation, and the angular momentum
// is no longer kept.
//
// When not to use it: degrees above four or so, which are ill-conditioned; walls.

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
