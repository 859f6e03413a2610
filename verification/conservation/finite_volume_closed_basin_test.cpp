#include <vector>

#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "verification/check.hpp"

namespace seiche::verification::finite_volume_closed_basin_test {

using shallow_water_finite_volume::End;
using shallow_water_finite_volume::FiniteVolumeFlow;
using shallow_water_finite_volume::Scheme;

FiniteVolumeFlow dam_break(Scheme scheme, std::size_t cells, End left, End right) {
  std::vector<double> depth(cells, 1.0);
  for (std::size_t i = 0; i < cells / 2; ++i) depth[i] = 2;
  FiniteVolumeFlow::Settings settings;
  settings.scheme = scheme;
  settings.left = left;
  settings.right = right;
  return {settings, 0, 100, depth, std::vector<double>(cells, 0.0)};
}

TEST_CASE("finite-volume schemes conserve mass and momentum to round-off", "[conservation]") {
  Check check("finite_volume_closed_basin", "Finite volumes: mass and momentum of a dam break",
              "A dam break 2 | 1 in 100 m, 200 cells, 10 000 steps: the waves hit the walls of a closed basin many "
              "times, or leave through open ends. What the ledger of end fluxes does not explain is round-off: each "
              "step rounds every cell once, relative to its content.");
  constexpr std::size_t cells = 200;
  constexpr long steps = 10000;
  const Roundoff mass_limit{.operations = 3.0 * cells * steps,
                            .scale = 2 * 100.0 / cells,
                            .reason = "three roundings per cell and step of a content up to h dx = 1 m^2"};
  const Roundoff momentum_limit{
      .operations = 3.0 * cells * steps,
      .scale = 20 * 100.0 / cells,
      .reason = "three roundings per cell and step of numbers up to g h^2/2 dx/2 = 10 m^3/s^2"};
  // Between open ends the flow turns steady: every step then repeats the roundings of the one before, which add up
  // (steps) instead of walking (sqrt(steps)).
  const std::string repeated = ", repeated by every step of the steady flow";
  const Roundoff open_mass_limit{.operations = mass_limit.operations.value() * steps,
                                 .scale = mass_limit.scale,
                                 .reason = "three roundings per cell of a content up to h dx = 1 m^2" + repeated};
  const Roundoff open_momentum_limit{
      .operations = momentum_limit.operations.value() * steps,
      .scale = momentum_limit.scale,
      .reason = "three roundings per cell of numbers up to g h^2/2 dx/2 = 10 m^3/s^2" + repeated};
  for (const Scheme scheme : {Scheme::lax_friedrichs, Scheme::mac_cormack, Scheme::roe, Scheme::muscl_hll}) {
    const std::string id(shallow_water_finite_volume::name(scheme));
    auto basin = dam_break(scheme, cells, End::wall(), End::wall());
    auto open = dam_break(scheme, cells, End::free(), End::inflow({1, 0}));
    for (long k = 0; k < steps; ++k) {
      basin.advance(0.04);
      open.advance(0.04);
    }
    CHECK(basin.ledger().mass_left == 0);
    CHECK(basin.ledger().mass_right == 0);
    check.holds(id + "-mass: The closed basin keeps its mass.", {basin.mass_defect()}, mass_limit);
    check.holds(id + "-momentum: Momentum changes by the impulses of the walls only.", {basin.momentum_defect()},
                momentum_limit);
    check.holds(id + "-open-mass: Mass changes by what passes the open ends only.", {open.mass_defect()},
                open_mass_limit);
    check.holds(id + "-open-momentum: Momentum changes by what passes the open ends only.", {open.momentum_defect()},
                open_momentum_limit);
  }
}

}  // namespace seiche::verification::finite_volume_closed_basin_test
