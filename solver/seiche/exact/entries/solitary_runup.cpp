#include "seiche/exact/solitary_runup.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"
#include "seiche/require.hpp"

namespace seiche::exact {

ExactSolution solitary_runup_entry() {
  return {
      .name = "solitary_runup",
      .title = "Run-up of a solitary wave on a plane beach: the integral of Carrier, Greenspan and Synolakis",
      .citation = SolitaryRunup::provenance().citation,
      .formula = SolitaryRunup::provenance().formula,
      .parameters = {{"amplitude", "m", 0.019, 1e-9, 1e6, "crest height of the incident wave"},
                     depth_parameter(1, 1e6),
                     {"cot_slope", "1", 19.85, 0.1, 1e3, "cotangent of the beach's angle"},
                     gravity_parameter(1)},
      .inputs = {{"t", "s", 0, "time, 0 when the crest is at the toe of the beach"}},
      .outputs = {{"eta", "m", "elevation at the initial shoreline, linear theory"}},
      .scalars = {{"runup", "m", "highest shoreline, of linear and nonlinear theory alike"},
                  {"runup_time", "s", "when"},
                  {"rundown", "m", "lowest shoreline, negative; NaN on a beach too short for one"},
                  {"rundown_time", "s", "when"},
                  {"law", "m", "run-up law 2.831 sqrt(cot) a^(5/4), the leading term of runup"},
                  {"breaking_amplitude", "m", "amplitude from which the wave breaks during run-up"}},
      .factory =
          [](const Values& p) {
            // Beaches so gentle that waves of this height break far out, and that the quadrature takes minutes.
            require_within("cot_slope sqrt(amplitude/depth)",
                           p.at("cot_slope") * std::sqrt(p.at("amplitude") / p.at("depth")), 0, 30);
            return evaluator_of(
                SolitaryRunup(p.at("gravity"), p.at("depth"), p.at("amplitude"), p.at("cot_slope")),
                [](const SolitaryRunup& wave, std::span<const double> at) {
                  return Evaluator::Row{wave.linear_elevation(at[0])};
                },
                [](const SolitaryRunup& wave) {
                  constexpr double none = std::numeric_limits<double>::quiet_NaN();
                  const auto lowest = wave.lowest().value_or(SolitaryRunup::Extreme{none, none});
                  return Evaluator::Row{
                      wave.highest().elevation, wave.highest().time, lowest.elevation, lowest.time, wave.law(),
                      wave.breaking_amplitude()};
                });
          },
  };
}

}  // namespace seiche::exact
