#include "validation/breaking/breaking_comparison.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "validation/case/claims.hpp"

namespace seiche::validation::breaking {
namespace {

/// Below it an outline is the bottom's.
constexpr double below_waves = -1;

}  // namespace

void compare(BreakingFrame& frame, const exact::PressureForcedWave& exact, const gauss_particles::Flow& flow,
             double cell, double spacing) {
  frame.limit = largest_distance(exact, frame.time, cell);
  if (frame.time > exact.vertical_tangent_time().value_or(nan)) {
    frame.outline = water_outline(flow, spacing, below_waves);
  }
  frame.distance = polyline_distance(frame.outline.empty() ? Polylines{marker_line(flow)} : frame.outline,
                                     {exact_wave(exact, frame.time)}, forced_length);
}

void claim_potential_flow(const Claims<BreakingRuns>& all, const std::vector<double>& times, std::size_t steepest,
                          BreakingLattice finest, double speed) {
  const auto claims = all.from(cauchy);
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    claims.check(
        fmt::format("potential-flow-{:.0f}", 10 * times[frame]),
        fmt::format("The surface at t = {:g} agrees with potential flow within half a cell and the parts of a jet "
                    "thinner than a cell.",
                    times[frame]),
        "largest distance of the two surfaces [1/k]",
        [frame](const BreakingRuns& c) -> Measurement {
          const BreakingFrame& surface = c.finest().frames.at(frame);
          return {.value = surface.distance.largest, .told = {.limit = surface.limit}};
        },
        near_surface(finest.cell));
  }
  claim_vertical_front(
      claims, [](const BreakingRuns& c) { return c.finest().overturned - c.vertical_tangent; },
      finest.cell / (2 * speed) + finest.tau);
  claims.check(
      "convergence",
      fmt::format("The surface at t = {:g} on cells half as wide is nearer to potential flow.", times.at(steepest)),
      "rms distance, finest grid over coarsest",
      [steepest](const BreakingRuns& c) {
        return c.finest().frames.at(steepest).distance.rms / c.lattices.front().frames.at(steepest).distance.rms;
      },
      nearer_on_half_cells());
  const double phase = finest.tau * finest.tau / 24;
  const double interpolation = std::pow(finest.cell, 3) / 24;
  claims.check(
      "exact-work",
      "The work of the pressure agrees with its work on potential flow within (omega tau)^2/24 for the step and (k "
      "h)^3/24 for the splines.",
      "work, relative difference", [](const BreakingRuns& c) { return c.finest().work / c.exact_work - 1; },
      Bound{.limit = phase + interpolation,
            .reason =
                "the phase lead (omega tau)^2/24 of the steps, and (k h)^3/24, the velocity error of cubic splines"});
}

void tabulate(evidence::Exhibit& exhibit, const BreakingRuns& runs) {
  evidence::Table& table =
      add_table(exhibit, "potential-flow", "Distance from potential flow",
                "Markers until the exact front is vertical, then the outline of the particles.", {"t [(g k)^(-1/2)]"});
  for (const BreakingRun& lattice : runs.lattices) {
    const std::string cells = fmt::format("{:.0f} cells", forced_length / lattice.cell);
    table.columns.emplace_back("rms, " + cells, "1/k");
    table.columns.emplace_back("largest, " + cells, "1/k");
  }
  for (std::size_t frame = 0; frame < runs.finest().frames.size(); ++frame) {
    std::vector<Cell>& row = table.rows.emplace_back(1, runs.finest().frames[frame].time);
    for (const BreakingRun& lattice : runs.lattices) {
      row.emplace_back(lattice.frames.at(frame).distance.rms);
      row.emplace_back(lattice.frames.at(frame).distance.largest);
    }
  }
}

}  // namespace seiche::validation::breaking
