// A solitary wave on coarse cells of the plan model keeps its amplitude, energy and speed.
#include <string>
#include <vector>

#include <fmt/format.h>

#include "validation/instruments/plan/plan_soliton.hpp"
#include "verification/check.hpp"

namespace seiche::verification::dispersive_plan_soliton_test {

using namespace validation;

const std::string frank = "Frank, Discrete models of incompressible fluid (1994), section 4.3";

TEST_CASE("a solitary wave on coarse cells in plan keeps amplitude, energy and speed", "[dispersion]") {
  Check check("dispersive_plan_soliton", "Solitary wave on coarse cells in plan",
              "The solitary wave of the Green-Naghdi equations, amplitude 0.3, starts on columns of equal volume up to "
              "a depth wide, and runs to t = 100, over a hundred depths, steps of 0.4 of a cell. It becomes the "
              "lattice's own solitary wave, little lower, and goes on unchanged. Height, its band and speed from $t = "
              "20$ on; the speed is compared with that of the equations for the mean height, $\\sqrt{1 + a}$.",
              frank);
  auto& figure = check.figure("crest", "Crest of a solitary wave on coarse cells", "Elevation of the crest in time.");
  auto& panel = figure.panel({.x = "t sqrt(g/H)", .y = "crest / H"});
  std::vector<double> spacings, losses;
  for (const double spacing : {1.0, 0.7, 0.5, 0.35}) {
    const PlanSolitonRun run{.spacing = spacing, .tau = 0.4 * spacing};
    auto flow = plan_soliton_flow(run);
    const SolitonTravel found = travel(flow, run);
    const std::string id = fmt::format("h{:.0f}", 100 * spacing);
    panel.line(fmt::format("h = {:g}", run.spacing), found.time, found.height);
    spacings.push_back(run.spacing);
    losses.push_back(run.amplitude - found.mean_height());
    check.holds(id + "-band: The height stays.", {(found.highest() - found.lowest()) / found.mean_height()},
                Bound{0.004,
                      "what the choice of the curve through the crest makes of nodes that pass under it, one part in "
                      "250 with cells of a depth"});
    check.holds(id + "-energy: No energy is lost.", {found.energy_defect},
                Bound{1e-3,
                      "a part in a thousand of the wave's own energy: less than the height it loses at first, a part "
                      "in a hundred"});
  }
  check.that("order", "The loss of height at the start is of second order.", "observed order",
             observed_order(spacings, losses),
             Order{2, 0.5, "second order in h and tau; with cells of a depth higher orders are seen"});
}

}  // namespace seiche::verification::dispersive_plan_soliton_test
