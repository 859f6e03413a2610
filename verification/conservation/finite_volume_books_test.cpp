// Mass and momentum of the finite-volume schemes; and a step goes through the channel strip by strip: the seams leave
// no trace.
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "verification/check.hpp"
#include "verification/conservation/long_rows.hpp"

namespace seiche::verification::finite_volume_books_test {

using shallow_water_finite_volume::End, shallow_water_finite_volume::FiniteVolumeFlow;
using shallow_water_finite_volume::Scheme;

FiniteVolumeFlow dam_break(Scheme scheme, std::size_t cells, End left, End right) {
  std::vector<double> depth(cells, 1.0);
  std::fill_n(depth.begin(), cells / 2, 2);
  return {{.scheme = scheme, .left = left, .right = right}, 0, 100, depth, std::vector<double>(cells, 0.0)};
}

TEST_CASE("finite-volume schemes conserve mass and momentum to round-off", "[conservation]") {
  Check check("finite_volume_closed_basin", "Finite volumes: mass and momentum of a dam break",
              "A dam break 2 | 1 in 100 m, 200 cells, 10 000 steps: the waves hit the walls of a closed basin many "
              "times, or leave through open ends. What the ledger of end fluxes does not explain is round-off: each "
              "step rounds every cell once, relative to its content.");
  constexpr std::size_t cells = 200;
  constexpr long steps = 10000;
  const auto walking = [](double scale, const std::string& of) {
    return Roundoff{3.0 * cells * steps, scale * 100.0 / cells, "three roundings per cell and step of " + of};
  };
  // Between open ends the flow turns steady: every step then repeats the roundings of the one before, which add up
  // (steps) instead of walking (sqrt(steps)).
  const auto repeated = [](double scale, const std::string& of) {
    return Roundoff{3.0 * cells * steps * steps, scale * 100.0 / cells,
                    "three roundings per cell of " + of + ", repeated by every step of the steady flow"};
  };
  const std::string content = "a content up to h dx = 1 m^2", thrust = "numbers up to g h^2/2 dx/2 = 10 m^3/s^2";
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
    check.holds(id + "-mass: The mass in the closed basin is conserved to round-off.", {basin.mass_defect()},
                walking(2, content));
    check.holds(id + "-momentum: The momentum change equals the impulses of the walls to round-off.",
                {basin.momentum_defect()}, walking(20, thrust));
    check.holds(id + "-open-mass: The mass change equals the flux through the open ends to round-off.",
                {open.mass_defect()}, repeated(2, content));
    check.holds(id + "-open-momentum: The momentum change equals the flux through the open ends to round-off.",
                {open.momentum_defect()}, repeated(20, thrust));
  }
}

constexpr double tau = 0.05;

/// Of the cells that no end of the short channel has reached.
double differing_cells(Scheme scheme) {
  constexpr long steps = 60;
  constexpr std::size_t out_of_reach = 4 * steps;  // two cells in each of two stages
  constexpr std::size_t begin = 2000, cells = 1000;
  FiniteVolumeFlow longer = long_channel(scheme, 0, 5000), shorter = long_channel(scheme, begin, begin + cells);
  for (long k = 0; k < steps; ++k) {
    longer.advance(tau);
    shorter.advance(tau);
  }
  double differing = 0;
  for (std::size_t i = out_of_reach; i < cells - out_of_reach; ++i) {
    const bool same = longer.depth()[begin + i] == shorter.depth()[i] &&
                      longer.discharge()[begin + i] == shorter.discharge()[i] &&
                      longer.velocity()[begin + i] == shorter.velocity()[i];
    differing += same ? 0 : 1;
  }
  return differing;
}

TEST_CASE("results of a finite-volume channel do not depend on its blocks", "[conservation]") {
  Check check("finite_volume_blocks", "Finite volumes: block by block",
              "A channel of 5000 cells, which a step goes through in several blocks, and a piece of it of 1000 cells, "
              "which is one block and lies across a seam with a discontinuity on it: outside the influence of the "
              "piece's ends all cells are bitwise identical after 60 steps. Over a slope, with friction, changes of "
              "mass and momentum equal the fluxes that the blocks record.");
  for (const Scheme scheme : {Scheme::lax_friedrichs, Scheme::mac_cormack, Scheme::roe, Scheme::muscl_hll}) {
    const std::string id(shallow_water_finite_volume::name(scheme));
    check.holds(id + "-seams: A piece of the channel moves like the whole.", {differing_cells(scheme)},
                Bound{0, "equality of bits"});
  }
  constexpr std::size_t cells = 5000;
  constexpr long steps = 2000;
  FiniteVolumeFlow flow = long_channel(Scheme::muscl_hll, 0, cells);
  for (long k = 0; k < steps; ++k) flow.advance(tau);
  const auto roundoff = [&](double scale, const std::string& reason) {
    return Roundoff{6.0 * cells * steps, scale, reason};
  };
  check.holds("Mass of the water in the channel is conserved to round-off.", {flow.mass_defect()},
              roundoff(2, "three roundings per cell and stage of contents up to 2 m^2"));
  check.holds("The momentum change equals the impulses of walls, bed and friction to round-off.",
              {flow.momentum_defect()},
              roundoff(2, "three roundings per cell and stage of discharges and of tau g h^2/2, up to 2 m^3/s a cell"));
}

}  // namespace seiche::verification::finite_volume_books_test
