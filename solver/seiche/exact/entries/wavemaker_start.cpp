#include <numbers>

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/exact/wavemaker_transient.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

ExactSolution wavemaker_start_entry() {
  return {
      .name = "wavemaker_start",
      .title = "A piston or a flap starts from rest: the transient of linear theory",
      .citation = WavemakerTransient::provenance().citation,
      .formula = WavemakerTransient::provenance().formula,
      .parameters = {{"kind", "1", 1, 0, 1, "paddle", {"piston", "flap"}},
                     depth_parameter(1, 1e6),
                     gravity_parameter(1),
                     {"period", "s", 2 * std::numbers::pi, 1e-9, 1e6, "period"},
                     {"stroke", "m", 1, 1e-12, 1e6, "stroke at the still-water level"}},
      .inputs = {{"x", "m", 1, "distance from the paddle"}, time_t},
      .outputs = {{"eta", "m", "surface elevation"}, {"settled", "m", "what it tends to"}},
      .scalars = {{"wave_height", "m", "height of the settled progressive wave"},
                  {"wavenumber", "1/m", "of the settled progressive wave"}},
      .factory =
          [](const Values& p) {
            // Waves of 600 depths: the panels of the quadrature over a period grow with the period.
            require_within("period sqrt(gravity/depth)", p.at("period") * std::sqrt(p.at("gravity") / p.at("depth")), 0,
                           600);
            return evaluator_of(
                WavemakerTransient::with_period(p.at("kind") == 0 ? Paddle::piston : Paddle::flap, p.at("gravity"),
                                                p.at("depth"), p.at("period"), p.at("stroke")),
                [](const WavemakerTransient& start, std::span<const double> at) {
                  return Evaluator::Row{start.elevation(at[0], at[1]), start.steady().elevation(at[0], at[1])};
                },
                [](const WavemakerTransient& start) {
                  return Evaluator::Row{start.steady().wave_height(), start.steady().wavenumber()};
                });
          },
  };
}

}  // namespace seiche::exact
