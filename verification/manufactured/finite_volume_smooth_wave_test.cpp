#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "seiche/exact/shallow_water/simple_wave.hpp"
#include "seiche/models/shallow_water_finite_volume/finite_volume_flow.hpp"
#include "seiche/samples.hpp"
#include "validation/instruments/manufactured/cell_average.hpp"
#include "verification/check.hpp"
#include "verification/refinement.hpp"

namespace seiche::verification::finite_volume_smooth_wave_test {

using shallow_water_finite_volume::FiniteVolumeFlow;
using shallow_water_finite_volume::Scheme;

constexpr double length = 20;

double mean_depth_error(const exact::SimpleWave& wave, Scheme scheme, std::size_t cells) {
  std::vector<double> edges(cells + 1);
  for (std::size_t k = 0; k <= cells; ++k) edges[k] = length * static_cast<double>(k) / static_cast<double>(cells);
  std::vector<double> depth, discharge;
  for (const auto& mean : validation::cell_averages(wave, edges, 0)) {
    depth.push_back(mean.depth);
    discharge.push_back(mean.discharge);
  }
  FiniteVolumeFlow flow({.scheme = scheme, .theta = 2}, 0, length, depth, discharge);
  march(flow, 0.9);
  const auto reference = validation::cell_averages(wave, edges, 0.9);
  Mean error;
  for (std::size_t i = 0; i < cells; ++i) error.add(std::abs(flow.depth()[i] - reference[i].depth));
  return error.value();
}

TEST_CASE("finite-volume schemes converge with their orders on a smooth simple wave", "[manufactured]") {
  Check check(
      "finite_volume_smooth_wave", "Smooth simple wave: orders of the finite-volume schemes",
      "A hump $h = 1 + 0.2 \\cos^6(\\pi (x-6)/6)$ runs to the right until $t = 0.9$ s, two thirds of its breaking "
      "time. Error: mean over the cells of the difference of mean depths, Courant number 0.4. The first-order schemes "
      "approach their order from below (their viscosity flattens the crest), so their order is fitted on finer grids "
      "than the order of the second-order schemes, whose limiter adds a small error at the crest.",
      "Toro, Shock-capturing methods for free-surface shallow flows (2001)");
  const auto wave = exact::SimpleWave::hump(9.81, 1, 0.2, 6, 6);
  /// n: of the coarsest of the four grids that the order is fitted on.
  for (const auto& [scheme, order, n] : {std::tuple{Scheme::lax_friedrichs, 1.0, 1600},
                                         {Scheme::roe, 1.0, 800},
                                         {Scheme::mac_cormack, 2.0, 400},
                                         {Scheme::muscl_hll, 2.0, 400}}) {
    const std::string id(shallow_water_finite_volume::name(scheme));
    refine(check, {"cell width [m]", widths(length, {n, 2 * n, 4 * n, 8 * n}), id, id},
           {{id + "-order", fmt::format("Scheme {} converges with order {:g}.", id, order),
             Order{order, 0.15, "approached from below: next term of the error on the four finest grids"}}},
           [&, scheme = scheme](double width) { return mean_depth_error(wave, scheme, cells_of(length, width)); });
  }
}

}  // namespace seiche::verification::finite_volume_smooth_wave_test
