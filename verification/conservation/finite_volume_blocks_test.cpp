// A step of the finite-volume schemes goes through the channel strip by strip: the seams leave no trace.
#include <omp.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "verification/check.hpp"

namespace finite_volume_blocks_test {

using namespace seiche;
using shallow_water_finite_volume::FiniteVolumeFlow;
using shallow_water_finite_volume::Scheme;

constexpr double tau = 0.05;
const std::string source = "what a step makes of a cell depends on its neighbours alone";

/// Water over [begin, end) of a longer channel, in cells of one metre: waves, and a jump at x = 2500.
FiniteVolumeFlow water(Scheme scheme, std::size_t begin, std::size_t end) {
  std::optional<Bed> bed;
  if (scheme == Scheme::muscl_hll) {
    constexpr double slope = 1.0 / 4096;
    bed = Bed{[](double x) { return slope * x; }, [](double x) { return slope * x * x / 2; }};
  }
  std::vector<double> depth;
  std::vector<double> discharge;
  for (std::size_t i = begin; i < end; ++i) {
    const auto x = static_cast<double>(i);
    depth.push_back(1.5 + 0.2 * std::sin(x / 7) + (i < 2500 ? 0.5 : 0));
    discharge.push_back(0.3 * std::cos(x / 5));
  }
  return {
      {.scheme = scheme, .manning = 0.02}, static_cast<double>(begin), static_cast<double>(end), depth, discharge, bed};
}

std::vector<double> after(FiniteVolumeFlow flow, long steps) {
  for (long k = 0; k < steps; ++k) flow.step(tau);
  std::vector<double> all(flow.depth().begin(), flow.depth().end());
  all.insert(all.end(), flow.discharge().begin(), flow.discharge().end());
  const auto ledger = flow.ledger();
  for (const double entry : {ledger.mass_left, ledger.mass_right, ledger.impulse_left, ledger.impulse_right,
                             ledger.impulse_bed, ledger.impulse_friction, flow.largest_courant()}) {
    all.push_back(entry);
  }
  return all;
}

/// Of the cells that no end of the short channel has reached.
double differing_cells(Scheme scheme) {
  constexpr long steps = 60;
  constexpr std::size_t out_of_reach = 4 * steps;  // two cells in each of two stages
  constexpr std::size_t begin = 2000;
  constexpr std::size_t cells = 1000;
  FiniteVolumeFlow longer = water(scheme, 0, 5000);
  FiniteVolumeFlow shorter = water(scheme, begin, begin + cells);
  for (long k = 0; k < steps; ++k) {
    longer.step(tau);
    shorter.step(tau);
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

TEST_CASE("the seams between blocks of a finite-volume channel leave no trace", "[conservation]") {
  verification::Check check(
      "finite_volume_blocks", "Finite volumes: block by block",
      "A channel of 5000 cells, which a step goes through in several blocks, and a piece of it of 1000 cells, which is "
      "one "
      "block and lies across a seam with a jump on it: where the ends of the piece have not been felt, all cells are "
      "equal to the last bit after 60 steps. A channel that is worth threads gives the same bits with one, two and "
      "three of them. Over a slope, with friction, mass and momentum are explained by what the blocks book.");
  const int threads = omp_get_max_threads();
  for (const Scheme scheme : {Scheme::lax_friedrichs, Scheme::mac_cormack, Scheme::roe, Scheme::muscl_hll}) {
    const std::string id(shallow_water_finite_volume::name(scheme));
    check.that({.id = id + "-seams",
                .text = "A piece of the channel moves like the whole.",
                .quantity = "cells that differ",
                .source = source},
               {.value = differing_cells(scheme), .resolution = "5000 and 1000 cells, 60 steps"},
               evidence::Bound{.limit = 0, .reason = "equality of bits"});
    std::vector<std::vector<double>> results;
    for (const int count : {1, 2, 3}) {
      omp_set_num_threads(count);
      results.push_back(after(water(scheme, 0, 140000), 5));
    }
    omp_set_num_threads(threads);
    check.that({.id = id + "-threads",
                .text = "Results of one, two and three threads are bitwise identical.",
                .quantity = "same bits",
                .source = source},
               {.value = results[0] == results[1] && results[0] == results[2] ? 1.0 : 0.0,
                .resolution = "140 000 cells, 5 steps"},
               evidence::Qualitative{"equal depths, discharges and booked impulses",
                                     "results must not depend on the machine's load"});
  }
  constexpr std::size_t cells = 5000;
  constexpr long steps = 2000;
  FiniteVolumeFlow flow = water(Scheme::muscl_hll, 0, cells);
  for (long k = 0; k < steps; ++k) flow.step(tau);
  const std::string resolution = "5000 cells, 2000 steps";
  const auto roundoff = [&](double scale, const std::string& reason) {
    return evidence::Roundoff{.operations = 6.0 * cells * steps, .scale = scale, .reason = reason};
  };
  check.that({.id = "mass",
              .text = "Mass of the water in the channel is conserved to round-off.",
              .quantity = "mass defect",
              .unit = "m^2",
              .source = "finite-volume form: what leaves a cell enters its neighbour"},
             {.value = flow.mass_defect(), .resolution = resolution},
             roundoff(2, "three roundings per cell and stage of contents up to 2 m^2"));
  check.that({.id = "momentum",
              .text = "What the impulses of walls, bed and friction do not explain of the momentum is round-off.",
              .quantity = "momentum defect",
              .unit = "m^3/s",
              .source = "finite-volume form: what leaves a cell enters its neighbour or the bed"},
             {.value = flow.momentum_defect(), .resolution = resolution},
             roundoff(2, "three roundings per cell and stage of discharges and of tau g h^2/2, up to 2 m^3/s a cell"));
}

}  // namespace finite_volume_blocks_test
