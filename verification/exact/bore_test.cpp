#include <cmath>

#include "seiche/exact/shallow_water/riemann.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/exact/dam_break.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"
#include "verification/check.hpp"

namespace seiche::verification::bore_test {

using namespace exact;

constexpr double g = 9.81;
const std::string source =
    "Bogomolov, Zakharov and Zerkal, Modelling of shallow-water waves by the particle method, formula (11)";

TEST_CASE("bore and stationary jump satisfy the jump conditions", "[exact]") {
  Check check(
      "exact_bore", "Bore and stationary hydraulic jump",
      "The jump conditions, the mass flux and the energy loss, "
      "computed as the difference of energy fluxes and compared with the closed form $g a (h_1 - h_0)^3/(4 h_1)$.",
      source);
  const Bore bore(g, 1, 2);
  const double a = bore.speed(), u = bore.behind_velocity();
  const Roundoff limit{.operations = 20, .scale = 60, .reason = "20 rounded operations, terms up to 60"};
  check.that("mass", "Mass is conserved across the bore to round-off.", "h1 (u1 - a) + h0 a [m^2/s]", {2 * (u - a) + a},
             limit);
  check.that(
      "momentum", "Momentum is conserved across the bore to round-off.", "residual of the momentum condition [m^3/s^2]",
      {2 * (u - a) * u - 0.5 * g * (1 - 4)},
      Roundoff{
          20, 15,
          "20 roundings, including the roundings of the speed and velocity, of g (h1^2 - h0^2)/2 = 15 on each side"});
  const auto energy_flux = [&](double h, double v) {
    return (v - a) * (0.5 * h * v * v + 0.5 * g * h * h) + 0.5 * g * h * h * v;
  };
  check.that("energy", "Energy lost is the difference of the energy fluxes.", "energy loss rate [m^4/s^3]",
             {bore.energy_loss_rate()},
             Roundoff{20, 100, "20 rounded operations, terms up to 100", energy_flux(2, u) - energy_flux(1, 0)});
  const StationaryJump jump(g, 1, 2, 100);
  CHECK(jump.at(110).depth == 2);
  CHECK(jump.at(90).velocity == jump.upstream().velocity);
}

TEST_CASE("a bore reflected from a wall leaves water at rest", "[exact]") {
  Check check("exact_bore_reflection", "Reflection of a bore from a wall",
              "$h_1 = 1$ m, $u_1 = 1.3$ m/s: depth ahead, speeds, depth at the wall; $a_- = -u_1 h_1/(h_2-h_1)$ in the "
              "form that loses digits; mass through the reflection.",
              source);
  const auto reflection = BoreReflection::from_velocity(g, 1, 1.3, 5, 10);
  check.that("speed-from-depths", "The reflected jump stops the flow.", "a- [m/s]", {reflection.reflected_speed()},
             Roundoff{30, 7, "30 roundings; h2 - h1 = 0.45 amplifies by 2", -1.3 / (reflection.reflected_depth() - 1)});
  CHECK(std::abs(reflection.incident().behind_velocity() - 1.3) < 1e-15 * 4);
  Worst defect;
  for (const double t : {0.0, 1.0, 1.5, 2.6}) {
    const auto mean = validation::cell_average(reflection, 0, 10, t);
    defect.add(10 * mean.depth - 5 - 5 * reflection.incident().ahead().depth - 1.3 * t);
  }
  check.that("mass", "Mass grows by the inflow, before and after the reflection.", "mass error [m^2]", {defect.value()},
             Roundoff{60, 15, "sums of 20 points up to 15 m^2"});
  const BoreReflection same(Bore(g, reflection.incident().ahead().depth, 1, 0, 5), 10);
  CHECK(std::abs(same.reflected_depth() - reflection.reflected_depth()) < 1e-14);
}

}  // namespace seiche::verification::bore_test
