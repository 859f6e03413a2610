#include "seiche/exact/steady_bump.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution steady_bump_entry() {
  return {
      .name = "steady_bump",
      .title = "Steady flow over a parabolic bump: subcritical, transcritical, with a hydraulic jump",
      .citation = SteadyBump::provenance().citation,
      .formula = SteadyBump::provenance().formula,
      .parameters = {{"discharge", "m^2/s", 0.18, 1e-9, 1e6, "discharge per unit width"},
                     {"outflow_depth", "m", 0.33, 0, 1e6, "depth at the outflow; 0: supercritical outflow, no jump"},
                     gravity_parameter(9.81),
                     {"height", "m", 0.2, 1e-9, 1e6, "height of the bump"},
                     {"crest", "m", 10, 0, 1e9, "position of the crest"},
                     {"half_width", "m", 2, 1e-9, 1e9, "half-width of the bump"},
                     {"length", "m", 25, 1e-9, 1e9, "length of the channel [0, length]"}},
      .inputs = {position_x},
      .outputs = {{"h", "m", "depth"}, {"u", "m/s", "velocity"}, {"z", "m", "bed elevation"}},
      .scalars = {{"critical_depth", "m", "(q^2/g)^(1/3)"},
                  {"jump", "m", "place of the hydraulic jump, NaN without one"},
                  {"depth_before_jump", "m", "depth just upstream of it, NaN without one"},
                  {"depth_after_jump", "m", "depth just downstream of it, NaN without one"}},
      .factory =
          [](const Values& p) {
            const SteadyBump::Bump bump{p.at("height"), p.at("crest"), p.at("half_width"), p.at("length")};
            const double outflow = p.at("outflow_depth");
            return evaluator_of(
                outflow > 0 ? SteadyBump(p.at("gravity"), p.at("discharge"), outflow, bump)
                            : SteadyBump::transcritical(p.at("gravity"), p.at("discharge"), bump),
                [](const SteadyBump& solution, std::span<const double> at) {
                  const auto state = solution.at(at[0]);
                  return Evaluator::Row{state.depth, state.velocity, solution.elevation(at[0])};
                },
                [](const SteadyBump& solution) {
                  return Evaluator::Row{solution.critical_depth(), solution.jump(), solution.depth_before_jump(),
                                        solution.depth_after_jump()};
                });
          },
  };
}

}  // namespace seiche::exact
