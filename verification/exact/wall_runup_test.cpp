#include "seiche/exact/overturning/wall_runup.hpp"

#include <cmath>

#include <fmt/format.h>

#include "seiche/samples.hpp"
#include "validation/case/reference_table.hpp"
#include "verification/self_test_claims.hpp"

namespace seiche::verification::wall_runup_test {

using exact::WallRunup;

const std::string source =
    "Su & Mirie, J. Fluid Mech. 98 (1980) 509; Cooker, Weidman & Bale, J. Fluid Mech. 342 (1997) 141; regression: "
    "table reference_data/wall_runup_exact";

Check runup_check() {
  return {"exact_wall_runup", "Run-up of solitary waves on a vertical wall",
          "Two mirrored solitary waves of the Euler equations collide head-on. The run-up is compared with values of "
          "finer computations, whose uncertainty comes from nodes, time steps and the length of the channel, and with "
          "an independent implementation; the series of Su & Mirie and of Byatt-Smith depart from it by 1 % at H/h = "
          "0.5 and 0.2. A second number of nodes and a second tolerance give the numerical error.",
          source};
}

/// The run-up of a row of the table, with what fewer markers and a coarser tolerance make of it.
WallRunup judged(Check& check, const io::Table& table, std::size_t row) {
  const double a = table.column("a")[row], expected = table.column("R")[row];
  const bool jet = a > 0.55, steep = a > 0.45;
  const std::size_t markers = steep ? 384 : 256, fewer = steep ? 256 : 192;
  const WallRunup runup(a, 1, markers);
  const double coarser = WallRunup(a, 1, fewer, 1e-10).runup();
  check.that(fmt::format("runup-{:.0f}", 100 * a),
             fmt::format("The run-up of a wave of H/h = {} on a vertical wall agrees with the reference.", a),
             fmt::format("run-up, a = {}", a) + " [depth]",
             {.value = runup.runup(),
              .uncertainty = std::abs(coarser - runup.runup()),
              .resolution = fmt::format("{} nodes, tolerance 1e-11", markers)},
             evidence::Uncertainty{.expected = expected,
                                   .data = table.column("u")[row],
                                   .useful = jet ? 2e-7 : 1e-8,
                                   .reason = fmt::format("column u of the reference: nodes, time steps, length of the "
                                                         "channel; our own from {} nodes and a tolerance of 1e-10",
                                                         fewer)});
  return runup;
}

TEST_CASE("the run-up of solitary waves on a vertical wall agrees with the reference", "[exact]") {
  Check check = runup_check();
  const auto table = validation::reference_table("wall_runup_exact", check.record().reference_data);
  Worst earlier;
  for (std::size_t row = 0; row < table.rows(); row += 2) {
    const double a = table.column("a")[row];
    const WallRunup runup = judged(check, table, row);
    earlier.add((table.column("R_earlier")[row] - runup.runup()) / table.column("u_earlier")[row], a);
    if (std::abs(a - 0.3) < 1e-9) self_test_holds(check, "third", runup);
  }
  check.that("independent",
             "The run-up agrees with a spectral Cauchy-integral method of 256 and 384 nodes within its uncertainty.",
             "largest difference over its uncertainty",
             {.value = earlier.value(), .where = fmt::format("a = {:g}", earlier.where())},
             Bound{1,
                   "column u_earlier of the reference: its two numbers of nodes, and 2e-9 for its time steps, the "
                   "remainder of a tolerance of 1e-9"});
  const WallRunup small(0.05, 1, 192);
  check.that("series", "The run-up converges to its third-order series for small waves.",
             "run-up of a wave of H/h = 0.05 minus the series [depth]", {small.runup()},
             Bound{3 * std::pow(0.05, 4),
                   "a fourth-order term with a coefficient no larger than the coefficient of the series times 4",
                   WallRunup::su_mirie(0.05)});
  CHECK(std::abs(WallRunup(0.1, 2, 192).runup() - 2 * small.runup()) < 1e-12);
}

TEST_CASE("the run-up of solitary waves of other heights on a vertical wall agrees with the reference",
          "[exact][full]") {
  Check check = runup_check();
  const auto table = validation::reference_table("wall_runup_exact", check.record().reference_data);
  for (std::size_t row = 1; row < table.rows(); row += 2) judged(check, table, row);
}

}  // namespace seiche::verification::wall_runup_test
