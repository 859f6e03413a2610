#include "seiche/exact/overturning/slope_runup.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include <fmt/format.h>

#include "seiche/exact/overturning/slope_climb.hpp"
#include "seiche/exact/overturning/wall_runup.hpp"
#include "seiche/samples.hpp"
#include "validation/case/reference_table.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::slope_runup_test {

using exact::SlopeRunup;
using exact::slope_climb::WedgeFlow;
using Complex = std::complex<double>;

/// Poles of sixth order above the surface and, mirrored, below the bottom, in the plane where bottom and slope are one
/// line: no water crosses them.
class MirroredPoles {
 public:
  MirroredPoles(double slope, Complex place)
      : slope_(slope), power_(std::numbers::pi / (std::numbers::pi - slope)), pole_(zeta(place)) {}

  [[nodiscard]] Complex zeta(Complex z) const {
    const Complex turned = z * std::polar(1.0, -slope_);
    return std::polar(std::pow(std::abs(turned), power_), power_ * std::arg(turned));
  }
  [[nodiscard]] Complex potential(Complex z) const { return part(z, pole_) + part(z, std::conj(pole_)); }
  [[nodiscard]] Complex velocity(Complex z) const {
    const Complex at = zeta(z);
    const auto of = [&](Complex pole) { return -6.0 * part(z, pole) / (at - pole); };
    return (of(pole_) + of(std::conj(pole_))) * power_ * at / z;
  }

 private:
  [[nodiscard]] Complex part(Complex z, Complex pole) const { return std::pow(pole_.imag() / (zeta(z) - pole), 6); }

  double slope_, power_;
  Complex pole_;
};

/// Largest error of the velocity over the largest velocity.
double error_of_velocity(std::size_t intervals, double cotangent) {
  const double slope = std::atan2(1, cotangent);
  const MirroredPoles poles(slope, {-2, 3});
  WedgeFlow flow(intervals, slope);
  constexpr double far = -60;
  const Eigen::VectorXd& nodes = flow.line().nodes;
  const auto n = nodes.size();
  Eigen::VectorXcd z(n);
  Eigen::VectorXd phi(n);
  const double shore = 1.2;  // above the bottom
  const Complex rest = poles.potential({far, 1});
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = far + (1 + nodes[i]) / 2 * (shore * cotangent - far);
    const double from_shore = x - shore * cotangent;
    z[i] = {x, 1 + (shore - 1) * std::exp(-from_shore * from_shore / 2)};
    phi[i] = (poles.potential(z[i]) - rest).real();
  }
  flow.solve(z, phi);
  Worst error, largest;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Complex expected = poles.velocity(z[i]);
    error.add(std::abs(flow.velocity()[i] - expected), z[i].real());
    largest.add(std::abs(expected));
  }
  return error.value() / largest.value();
}

TEST_CASE("velocities of water over a slope agree with a potential with poles outside of it", "[exact]") {
  Check check("exact_slope_velocity", "Velocities of water that ends on a slope",
              "Cauchy's integral in a plane where bottom and slope are one straight line. The velocities at a curved "
              "surface are compared with a potential with poles above the water, mirrored in the line.");
  for (const double cotangent : {0.0, 1.0, 3.0}) {
    const double coarse = error_of_velocity(140, cotangent), fine = error_of_velocity(280, cotangent);
    check.holds(
        fmt::format("velocity-{:g}", cotangent) + ": The surface velocities agree with the potential.", {fine},
        Bound{1e-6, "two nodes to the distance of the poles, whose sixth power multiplies the error of the nodes"});
    check.holds(fmt::format("faster-{:g}", cotangent) +
                    ": The error falls faster than any power of the spacing with twice the nodes.",
                {fine / coarse}, Bound{1.0 / 256, "order eight; Chebyshev nodes have no order"});
  }
}

const std::string source =
    "Grilli, Svendsen & Subramanya, J. Waterway, Port, Coastal, Ocean Eng. 123 (1997) 102; regression: table "
    "reference_data/slope_runup_exact";

Check runup_check() {
  return {"exact_slope_runup", "Run-up of solitary waves on slopes",
          "A solitary wave of the Euler equations is moved by Cauchy's integral in a plane where bottom and slope are "
          "one straight line. The run-up on a vertical wall is compared with the head-on collision of two waves, "
          "another method; on slopes with values of finer computations.",
          source};
}

/// The run-up with the fewest markers beside that of the table.
SlopeRunup judged(Check& check, const io::Table& table, std::size_t row) {
  const double a = table.column("A")[row], cotangent = table.column("cot_slope")[row];
  SlopeRunup slope(a, cotangent, 1, 160);
  check.holds(
      fmt::format("The run-up of a wave of H/h = {} on a slope 1:{:g} agrees with the reference.", a, cotangent),
      {slope.runup()},
      Bound{5e-5 * a, "half a unit of the fourth decimal of the amplitude: the fewest nodes that are accepted",
            table.column("R")[row]});
  if (a == 0.29) self_test_holds(check, fmt::format("slope-{:g}", cotangent), slope);
  return slope;
}

TEST_CASE("the run-up of a solitary wave on a slope agrees with the reference", "[exact]") {
  Check check = runup_check();
  const auto table = validation::reference_table("slope_runup_exact", check.record().reference_data);
  const SlopeRunup slope = judged(check, table, 2);
  CHECK(std::abs(slope.level(slope.runup_time()) - slope.runup()) < 1e-14);
  const auto& moment = slope.history()[slope.history().size() / 2];
  CHECK(std::abs(slope.level(moment.time) - moment.level) < 1e-14);
  CHECK_THROWS_AS(slope.level(slope.runup_time() + 1), std::out_of_range);
}

TEST_CASE("the run-up of solitary waves on walls and slopes agrees with the references", "[exact][full]") {
  Check check = runup_check();
  const SlopeRunup wall(0.3, 0);
  check.that("wall", "The run-up on a vertical slope agrees with the collision of two waves.",
             "run-up of a wave of H/h = 0.3 [depth]",
             {.value = wall.runup(), .uncertainty = wall.uncertainty() * wall.runup()},
             evidence::Uncertainty{.expected = exact::WallRunup(0.3, 1, 256).runup(),
                                   .data = 1e-9,
                                   .useful = 1e-5,
                                   .reason = "of the collision, 256 nodes; our own from fewer nodes and longer steps, "
                                             "of use up to a unit of the fifth decimal"});
  self_test_holds(check, "wall", wall);
  const auto table = validation::reference_table("slope_runup_exact", check.record().reference_data);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double a = table.column("A")[row];
    if (a == 0.29 || a == 0.5) judged(check, table, row);
  }
  CHECK(std::abs(SlopeRunup(0.4, 1, 2, 160).runup() - 2 * SlopeRunup(0.2, 1, 1, 160).runup()) < 1e-12);
}

}  // namespace seiche::verification::slope_runup_test
