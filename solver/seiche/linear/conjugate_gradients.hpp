/// Preconditioned conjugate gradients for A x = b, A symmetric positive definite.
///
/// With z = P r the preconditioned residual and p the direction, an iteration is
///
///     alpha = z.r / p.Ap,   x += alpha p,   r -= alpha Ap,   z = P r,   beta = z_new.(r_new - r) / z.r,   p = z_new +
///     beta p
///
/// This beta (Polak-Ribiere; flexible conjugate gradients) bears a preconditioner that is symmetric only to single
/// precision, which z_new.r_new / z.r does not. Here r_new - r = -alpha Ap, so that it costs no further vector.
///
/// The residual is followed by its recurrence. It leaves the true one, b - A x, by round-off: a few units in the last
/// place of |A| |x|.
///
/// References: Hestenes & Stiefel, Methods of conjugate gradients for solving linear systems, J. Res. NBS 49 (1952)
/// 409; Golub & Ye, Inexact preconditioned conjugate gradient method with inner-outer iteration, SIAM J. Sci. Comput.
/// 21 (1999) 1305; Notay, Flexible conjugate gradients, SIAM J. Sci. Comput. 22 (2000) 1444.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>

#include <fmt/format.h>

#include "seiche/linear/lattice_matrix.hpp"

namespace seiche::linear {

// Passes over long vectors for iterative solvers, several operations at a time: they are limited by memory.
//
// Threads share chunks of fixed length; sums are taken within each chunk and then in order, so that results do not
// depend on the number of threads. All spans of one call have the same length; outputs do not overlap inputs.

/// x . y
double dot(std::span<const double> x, std::span<const double> y);
/// y = x + factor y
void scale_and_add(std::span<const double> x, double factor, std::span<double> y);
/// x += step p, r -= step q; returns r . r.
double advance(double step, std::span<const double> p, std::span<const double> q, std::span<double> x,
               std::span<double> r);

/// The tolerance was not reached.
class NotConverged : public std::runtime_error {
 public:
  NotConverged(int iterations, double relative_residual, double tolerance)
      : std::runtime_error(
            fmt::format("conjugate gradients: relative residual {:.3g} after {} iterations; wanted: {:.3g}",
                        relative_residual, iterations, tolerance)) {}
};

/// A direction p or a residual r was found with p . A p or r . P r not positive: not positive definite, or not numbers.
class NotPositiveDirection : public std::runtime_error {
 public:
  NotPositiveDirection(const char* form, double value, int iteration)
      : std::runtime_error(fmt::format("conjugate gradients: {} = {:.6g} in iteration {}; the matrix and the "
                                       "preconditioner must be positive definite and all entries finite",
                                       form, value, iteration)) {}
};

/// Keeps its work arrays from solution to solution.
///
/// @tparam Vector  copyable, with values() giving a span of the unknowns and whatever else Multiply needs around them
template <class Vector = LatticeArray>
class ConjugateGradients {
 public:
  struct Goal {
    double tolerance = 1e-10;  ///< |r| <= tolerance |b|, Euclidean norms
    int most_iterations = 200;
  };
  struct Result {
    int iterations = 0;
    double relative_residual = 0;  ///< |r|/|b| at the end
  };

  /// Starts from the x given. Throws NotConverged, NotPositiveDirection.
  ///
  /// @param multiply       multiply(const Vector& p, Vector& q) sets q = A p and returns p . q
  /// @param precondition   precondition(span of r, span of z, magnitude) sets z = P r; magnitude: typical size of r
  template <class Multiply, class Precondition>
  Result solve(const Multiply& multiply, Precondition&& precondition, const Vector& b, Vector& x, Goal goal) {
    const double b_norm = std::sqrt(dot(b.values(), b.values()));
    if (b_norm == 0) {
      for (double& value : x.values()) value = 0;
      return {};
    }
    shape_like(b);
    multiply(x, residual_);
    scale_and_add(b.values(), -1, residual_.values());
    double r_norm = std::sqrt(dot(residual_.values(), residual_.values()));
    double zr = 0;
    double beta = 0;
    double step = 0;
    int iteration = 0;
    for (; !(r_norm <= goal.tolerance * b_norm); ++iteration) {
      if (iteration == goal.most_iterations) throw NotConverged(iteration, r_norm / b_norm, goal.tolerance);
      precondition(residual_.values(), preconditioned_.values(), typical_size(r_norm));
      const double zr_new = dot(preconditioned_.values(), residual_.values());
      if (!(zr_new > 0)) throw NotPositiveDirection("r.Pr", zr_new, iteration);
      const double zq = dot(preconditioned_.values(), product_.values());
      if (iteration > 0) beta = -step * zq / zr;
      zr = zr_new;
      scale_and_add(preconditioned_.values(), beta, direction_.values());
      const double curvature = multiply(direction_, product_);
      if (!(curvature > 0)) throw NotPositiveDirection("p.Ap", curvature, iteration);
      step = zr / curvature;
      r_norm = std::sqrt(advance(step, direction_.values(), product_.values(), x.values(), residual_.values()));
    }
    return {iteration, r_norm / b_norm};
  }

 private:
  void shape_like(const Vector& b) {
    if (residual_.values().size() == b.values().size()) return;
    residual_ = preconditioned_ = direction_ = product_ = b;
  }
  [[nodiscard]] double typical_size(double norm) const {
    return norm / std::sqrt(static_cast<double>(residual_.values().size()));
  }

  Vector residual_, preconditioned_, direction_, product_;
};

}  // namespace seiche::linear
