#include "seiche/exact/overturning/wall_runup.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "validation/case/reference_table.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::wall_load_test {

using exact::WallLoad;

const std::string source =
    "Bernoulli's equation at the wall; Su & Mirie, J. Fluid Mech. 98 (1980) 509; Cooker, Weidman & Bale, J. Fluid "
    "Mech. 342 (1997) 141; regression: table reference_data/wall_load_exact";

struct Quantity {
  std::string id, column, name, unit;
  WallLoad::Peak (WallLoad::*largest)() const;
};
const std::vector<Quantity> quantities{
    {"still", "p_still", "pressure at the still-water level", "rho g depth", &WallLoad::largest_still},
    {"bottom", "p_bottom", "pressure at the foot", "rho g depth", &WallLoad::largest_bottom},
    {"force", "F", "force", "rho g depth^2", &WallLoad::largest_force}};

void claim_tabled(Check& check, const io::Table& table, const WallLoad& load, std::size_t markers) {
  const double a = load.wave_amplitude();
  std::size_t row = 0;
  while (std::abs(table.column("A").at(row) - a) > 1e-9) ++row;
  const WallLoad coarser(a, 1, markers / 4 * 3, 1e-10);
  for (const Quantity& quantity : quantities) {
    const double value = (load.*quantity.largest)().value;
    check.that(fmt::format("{}-{:.0f}", quantity.id, 100 * a),
               fmt::format("The largest {} of a wave of H/h = {} agrees with the reference.", quantity.name, a),
               fmt::format("{}, a = {}", quantity.name, a) + " [" + quantity.unit + "]",
               {.value = value,
                .uncertainty = std::abs((coarser.*quantity.largest)().value - value),
                .resolution = fmt::format("{} nodes, tolerance 1e-11", markers)},
               evidence::Uncertainty{.expected = table.column(quantity.column)[row],
                                     .data = table.column("u")[row],
                                     .useful = 1e-8,
                                     .reason = "column u of the reference: nodes, time steps, length of the channel; "
                                               "our own from three quarters of the nodes and a tolerance of 1e-10"});
  }
}

/// What the series leave of waves of 0.05 and 0.1 depths.
void claim_series(Check& check) {
  const WallLoad small(0.05, 1, 192);
  const WallLoad twice(0.1, 1, 192);
  const auto order = [](double half, double whole) { return std::log2(std::abs(whole / half)); };
  const auto third = [&](const std::string& name, double half, double whole) {
    check.holds(fmt::format("The {} converges to its second-order series for small waves.", name), {order(half, whole)},
                Bound{0.3, "the next term, with a coefficient up to four times the third's: 4 x 0.05/ln 2", 3});
  };
  // Over the depth 1 and its square.
  const auto bottom = [](double a) { return 1 + 2 * a - a * a; };
  const auto force = [](double a) { return 0.5 + 2 * a + 1.5 * a * a; };
  third("pressure at the foot", small.largest_bottom().value - bottom(0.05),
        twice.largest_bottom().value - bottom(0.1));
  third("force", small.largest_force().value - force(0.05), twice.largest_force().value - force(0.1));
  check.that("series-still",
             "The pressure at the still-water level converges to its third-order series for small waves.",
             "maximum pressure of a wave of H/h = 0.05 [rho g depth]", {small.largest_still().value},
             Bound{5.25 * std::pow(0.05, 4),
                   "a fourth-order term with a coefficient no larger than the third-order coefficient, 21/4",
                   WallLoad::still_series(0.05)});
}

Check load_check() {
  return {"exact_wall_load", "Pressure and force of solitary waves on a vertical wall",
          "Two mirrored solitary waves of the Euler equations collide head-on; the pressure along the wall follows "
          "from Bernoulli's equation. The maximum loads are compared with values of finer computations; the force with "
          "the change of momentum, the pressure at the foot with the change of the potential; small waves with series.",
          source};
}

TEST_CASE("the load of solitary waves on a vertical wall agrees with the reference", "[exact]") {
  Check check = load_check();
  const auto table = validation::reference_table("wall_load_exact", check.record().reference_data);
  claim_tabled(check, table, WallLoad(0.1, 1, 192), 192);
  const WallLoad high(0.5);
  claim_tabled(check, table, high, 384);
  self_test_holds(check, "half", high);
  claim_series(check);
}

TEST_CASE("the load of waves of H/h = 0.3 on a vertical wall agrees with the reference", "[exact][full]") {
  Check check = load_check();
  claim_tabled(check, validation::reference_table("wall_load_exact", check.record().reference_data),
               WallLoad(0.3, 1, 256), 256);
}

TEST_CASE("loads scale with the depth, and waves beyond the method are rejected", "[exact]") {
  const WallLoad one(0.1, 1, 128);
  const WallLoad two(0.2, 2, 128);
  CHECK(std::abs(two.largest_bottom().value - 2 * one.largest_bottom().value) < 1e-11);
  CHECK(std::abs(two.largest_force().value - 4 * one.largest_force().value) < 1e-11);
  CHECK(std::abs(two.separation() - 2 * one.separation()) < 1e-11);
  const WallLoad::Load start = one.at(0);
  CHECK(std::abs(start.force - 0.5) < 1e-6);
  CHECK(std::abs(start.bottom - 1) < 1e-6);
  CHECK_THROWS_AS(one.at(-1), std::out_of_range);
  CHECK_THROWS_WITH(one.at(1000), Catch::StartsWith("t = 1000 is outside [0, "));
  CHECK_THROWS_AS(WallLoad(0.2, 1, 128, 0), std::invalid_argument);
}

}  // namespace seiche::verification::wall_load_test
