#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "seiche/exact/affine_drop.hpp"
#include "seiche/exact/affine_ellipsoid.hpp"
#include "seiche/samples.hpp"
#include "verification/self_test_claims.hpp"

namespace affine_ellipsoid_test {

using namespace seiche;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using exact::AffineEllipsoid;

const std::string source = "Dirichlet, J. reine angew. Math. 58 (1861) 181; Dedekind, ibid. 217";

Matrix3d turning_gradient() {
  Matrix3d gradient;
  gradient << 0.6, -0.4, 0.1, 0.5, -0.2, -0.3, 0.2, 0.3, -0.4;
  return gradient;
}

/// Largest difference between the acceleration of a particle, by fourth-order differences of its path, and the gradient
/// of the pressure p0 (1 - |A^-1 x|^2), by differences that are exact for a quadratic.
double momentum_residual(const AffineEllipsoid& drop, double time, double span) {
  const auto deformation = [&](double steps) { return drop.at(time + steps * span).deformation; };
  const Matrix3d acceleration =
      (-deformation(2) + 16 * deformation(1) - 30 * deformation(0) + 16 * deformation(-1) - deformation(-2)) /
      (12 * span * span);
  const AffineEllipsoid::Instant now = drop.at(time);
  const auto pressure = [&](const Vector3d& x) {
    return now.central_pressure * (1 - (now.deformation.inverse() * x).squaredNorm());
  };
  Largest largest;
  for (const Vector3d& label : {Vector3d(0.8, 0, 0), Vector3d(0.1, -0.7, 0.3), Vector3d(-0.3, 0.2, 0.9)}) {
    const Vector3d here = now.deformation * label;
    Vector3d gradient;
    for (int i = 0; i < 3; ++i) {
      const Vector3d width = 0.01 * Vector3d::Unit(i);
      gradient[i] = (pressure(here + width) - pressure(here - width)) / 0.02;
    }
    largest.add((acceleration * label + gradient).norm());
  }
  return largest.value();
}

TEST_CASE("a free liquid ellipsoid moves as the Euler equations demand", "[exact]") {
  verification::Check check("exact_affine_ellipsoid", "Free liquid ellipsoid",
                            "A ball whose velocity is linear in the coordinates: momentum along particle paths, the "
                            "invariants, Dedekind's theorem, the way back, and the plane drop as its limit.");
  const AffineEllipsoid turning(turning_gradient());
  claim_self_test(check, "turning", turning, source);
  claim_self_test(check, "strain", AffineEllipsoid(Vector3d(2, -1, -1).asDiagonal(), 3), source);
  std::vector<double> spans;
  std::vector<double> residuals;
  for (double span = 0.16; span > 0.015; span /= 2) {
    spans.push_back(span);
    residuals.push_back(momentum_residual(turning, 1, span));
  }
  check.that({.id = "momentum",
              .text = "Particles accelerate by the pressure gradient: the residual is that of the time differences.",
              .quantity = "order of the residual in the time difference",
              .source = source},
             evidence::observed_order(spans, residuals, 1e-11),
             evidence::Order{4, 0.3, "fourth-order differences of a smooth path"});
  // tr(A^-1 A^-T) of the ball is 3, of the disc 2.
  Matrix3d plane = Matrix3d::Zero();
  plane.topLeftCorner<2, 2>() << 0.5, 1.1, 0.3, -0.5;
  const exact::AffineDrop drop(Eigen::Matrix2d::Identity(), plane.topLeftCorner<2, 2>());
  check.that({.id = "plane",
              .text = "The pressure of a ball that flows in planes is two thirds of the plane drop's.",
              .quantity = "ratio of the pressures at the centre",
              .source = source},
             {.value = AffineEllipsoid(plane).at(0).central_pressure / drop.at(0).central_pressure},
             evidence::Roundoff{.operations = 20, .scale = 1, .reason = "two traces", .expected = 2.0 / 3});
  const AffineEllipsoid large(turning_gradient(), 3);
  check.that({.id = "axes",
              .text = "The semi-axes are those of an ellipsoid with the volume of the ball.",
              .quantity = "their product over the radius cubed, at t = 1",
              .source = source},
             {.value = large.semi_axes(large.at(1)).prod() / 27},
             evidence::Bound{.limit = 1e-12, .reason = "the motion's own uncertainty", .expected = 1});
  CHECK_THROWS_AS(AffineEllipsoid(Matrix3d::Identity()), std::invalid_argument);
  CHECK_THROWS_AS(AffineEllipsoid(turning_gradient(), 0), std::invalid_argument);
  CHECK_THROWS_AS(turning.at(std::nan("")), std::invalid_argument);
}

}  // namespace affine_ellipsoid_test
