// A solitary wave on coarse cells of the plan model keeps its amplitude, energy and speed.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "validation/case/reference_table.hpp"
#include "validation/instruments/plan/plan_soliton.hpp"
#include "verification/check.hpp"

namespace dispersive_plan_soliton_test {

using namespace seiche;
using namespace seiche::validation;
using namespace seiche::verification;

const std::string frank = "Frank, Discrete models of incompressible fluid (1994), section 4.3";

TEST_CASE("a solitary wave on coarse cells in plan keeps amplitude, energy and speed", "[dispersion]") {
  Check check(
      "dispersive_plan_soliton", "Solitary wave on coarse cells in plan",
      "The solitary wave of the Green-Naghdi equations, amplitude 0.3, starts on columns of equal volume up to a depth "
      "wide, and runs to t = 100, over a hundred depths, steps of 0.4 of a cell. It becomes the lattice's own "
      "solitary wave, little lower, and goes on unchanged. Height, its band and speed from $t = 20$ on; the speed is "
      "compared with that of the equations for the mean height, $\\sqrt{1 + a}$.");
  auto& figure = check.figure("crest", "Crest of a solitary wave on coarse cells", "Elevation of the crest in time.");
  auto& panel = figure.panel({.x = "t sqrt(g/H)", .y = "crest / H"});
  std::vector<double> spacings, losses;
  const io::Table known = reference_table("regression_plan_soliton", check.record().reference_data);
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
                      "what the choice of the curve through the crest makes of nodes that pass under it, one "
                      "part in 250 with cells of a depth"});
    check.holds(
        id + "-energy: No energy is lost.", {found.energy_defect},
        Bound{1e-3,
              "a part in a thousand of the wave's own energy: less than the height it loses at first, a part in "
              "a hundred"});
    const auto& spacings_known = known.column("spacing");
    const auto found_row = std::find(spacings_known.begin(), spacings_known.end(), spacing);
    if (found_row == spacings_known.end()) continue;  // the finest serves the order alone
    const auto row = static_cast<std::size_t>(found_row - spacings_known.begin());
    check.holds(id + "-height: The mean height is that of an earlier program.", {found.mean_height()},
                Bound{1e-4, "means over other parts of the run: a tenth of the band with cells of a depth",
                      known.column("height")[row]});
    check.holds(
        id + "-speed: So is the speed.", {found.speed()},
        Bound{1e-4, "the place of the crest, a hundredth of a cell over 90 depths of way", known.column("speed")[row]});
  }
  check.that({.id = "order",
              .text = "The loss of height at the start is of second order.",
              .quantity = "observed order",
              .source = frank},
             observed_order(spacings, losses),
             Order{2, 0.5, "second order in h and tau; with cells of a depth higher orders are seen"});
}

}  // namespace dispersive_plan_soliton_test
