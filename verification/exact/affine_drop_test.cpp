#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "seiche/samples.hpp"
#include "validation/instruments/exact/affine_drop.hpp"
#include "verification/refinement.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::affine_drop_test {

using namespace exact;

const std::string source = "Dirichlet (1860); Longuet-Higgins, J. Fluid Mech. 55 (1972) 529";

/// A tilted ellipse that is strained and turns.
AffineDrop turning_drop() {
  Eigen::Matrix2d shape;
  shape << 1, 0.2, -0.1, 0.7;
  Eigen::Matrix2d gradient;
  gradient << 0.5, 1.1, -0.3, -0.5;
  return {shape, gradient, 1000};
}

/// Largest difference between the acceleration of a particle, by fourth-order differences of its path, and -grad p/rho.
double momentum_residual(const AffineDrop& drop, double density, double time, double span) {
  const DropInstant now = drop.at(time);
  Largest largest;
  for (const double angle : {0.1, 1.3, 2.9, 4.4}) {
    const Eigen::Vector2d start =
        drop.at(0).deformation * Eigen::Vector2d(0.8 * std::cos(angle), 0.8 * std::sin(angle));
    const auto path = [&](double steps) { return drop.carried(start.x(), start.y(), time + steps * span); };
    const Eigen::Vector2d here = path(0);
    const Eigen::Vector2d acceleration =
        (-path(2) + 16 * path(1) - 30 * here + 16 * path(-1) - path(-2)) / (12 * span * span);
    // The pressure is quadratic: central differences of any width are exact.
    const double width = 0.01;
    const Eigen::Vector2d gradient(
        (now.pressure(here.x() + width, here.y()) - now.pressure(here.x() - width, here.y())) / (2 * width),
        (now.pressure(here.x(), here.y() + width) - now.pressure(here.x(), here.y() - width)) / (2 * width));
    largest.add((acceleration + gradient / density).norm());
  }
  return largest.value();
}

TEST_CASE("a free liquid ellipse stretches as its equation of motion demands", "[exact]") {
  Check check(
      "exact_affine_drop", "Free liquid ellipse",
      "A drop without gravity whose velocity is linear in the coordinates. Its axes against tables (circle of radius "
      "1, rate 1), the invariants, the reversed motion, the momentum equation along particle paths, the pressure on "
      "the surface. The quadrature of the symmetric case and the integration of the general one check each other.",
      source);
  const StretchingDrop circle(1, 1, 1);
  const AffineDrop turning = turning_drop();
  self_test_holds(check, "turning", turning);

  refine(check, {.axis = "time difference", .sizes = falling(0.16, 4), .title = {}, .floor = 1e-11},
         {{"momentum",
           "The residual of acceleration plus pressure gradient falls at fourth order in the time difference.",
           {4, 0.3, "fourth-order differences of a smooth path"}}},
         [&](double span) { return momentum_residual(turning, 1000, 1, span); });

  Worst surface, outline;
  for (const double t : {-1.0, 0.0, 0.7, 2.0}) {
    const DropInstant instant = turning.at(t);
    const auto [long_axis, short_axis, tilt] = exact::outline_of(instant);
    for (double angle = 0; angle < 6.3; angle += 0.3) {
      const Eigen::Vector2d on_circle(std::cos(angle), std::sin(angle));
      const Eigen::Vector2d point = instant.deformation * on_circle;
      surface.add(instant.pressure(point.x(), point.y()) / instant.central_pressure);
      const Eigen::Vector2d of_axes =
          Eigen::Rotation2Dd(tilt) * on_circle.cwiseProduct(Eigen::Vector2d(long_axis, short_axis));
      outline.add((instant.deformation.inverse() * of_axes).squaredNorm() - 1);
    }
  }
  check.that("surface", "The pressure vanishes on the surface.", "pressure there over the pressure in the centre",
             {surface.value()},
             Roundoff{16, 16, "two products with A and its inverse; condition number of A up to 16"});
  check.that(
      "outline", "The ellipse of the stated axes and tilt is the surface.", "|X|^2 - 1 of its points",
      {outline.value()},
      Roundoff{
          40, 16,
          "singular values and vectors, a rotation and the inverse map, 40 roundings; condition number of A up to 16"});
  const StretchingDrop strained(3, 0.2, -2.5, 1000);
  const AffineDrop same(Eigen::Vector2d(3, 0.2).asDiagonal(), Eigen::Vector2d(-2.5, 2.5).asDiagonal(), 1000);
  Worst pressure;
  for (const double t : {0.0, 0.2, 0.5, 1.0}) {
    pressure.add(strained.at(t).central_pressure / same.at(t).central_pressure - 1);
  }
  check.that(
      "pressure",
      "The pressure in the centre of the symmetric drop agrees with the integrated equation of motion within 6e-11.",
      "largest relative difference of the pressure in the centre", {pressure.value()},
      Bound{6e-11,
            "four factors A^-1 or A' in the pressure, each good to the stated uncertainty 1e-12 times the "
            "condition number of A, 15"});
}

TEST_CASE("points outside the drop and impossible drops are rejected", "[exact]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const DropInstant ellipse = StretchingDrop(2, 0.5, 1).at(0);
  CHECK_NOTHROW(ellipse.velocity(2, 0));
  CHECK_THROWS_AS(ellipse.velocity(2.01, 0), OutsideFluid);
  CHECK_THROWS_WITH(ellipse.pressure(0, 0.75), Catch::Contains("y = 0.75"));
  CHECK_THROWS_WITH(ellipse.pressure(nan, 0), Catch::Contains("x = nan"));
  CHECK_THROWS_WITH(ellipse.pressure(0, nan), Catch::Contains("y = nan"));
  CHECK_THROWS_AS(StretchingDrop(2, 0.5, 1).carried(0, 0.6, 1), OutsideFluid);
  CHECK_THROWS_AS(StretchingDrop(1, 1, 1).time_of(-1), std::invalid_argument);
  Eigen::Matrix2d growing = Eigen::Matrix2d::Identity();
  CHECK_THROWS_AS(AffineDrop(Eigen::Matrix2d::Identity(), growing), std::invalid_argument);
  CHECK_THROWS_AS(AffineDrop(Eigen::Vector2d(1, -1).asDiagonal(), Eigen::Matrix2d::Zero()), std::invalid_argument);
}

}  // namespace seiche::verification::affine_drop_test
