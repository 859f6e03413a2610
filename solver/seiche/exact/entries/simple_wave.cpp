#include "seiche/exact/simple_wave.hpp"

#include "seiche/exact/entries/entries.hpp"
#include "seiche/exact/entries/entry_parts.hpp"

namespace seiche::exact {

ExactSolution simple_wave_entry() {
  return {
      .name = "simple_wave",
      .title = "A smooth hump cos^6 runs to the right and steepens until it breaks",
      .citation = SimpleWave::provenance().citation,
      .formula = SimpleWave::provenance().formula,
      .parameters = {{"still_depth", "m", 1, 1e-9, 1e6, "depth of the still water"},
                     {"amplitude", "m", 0.2, -1e6, 1e6, "height of the hump, above -still_depth"},
                     {"centre", "m", 6, -1e9, 1e9, "middle of the hump at t = 0"},
                     {"length", "m", 6, 1e-9, 1e9, "length of the hump"},
                     gravity_parameter(9.81)},
      .inputs = {position_x, time_t},
      .outputs = {{"h", "m", "depth"}, {"u", "m/s", "velocity"}},
      .scalars = {{"breaking_time", "s", "when the wave becomes vertical; no solution from then on"},
                  {"breaking_place", "m", "where it does"}},
      .factory =
          [](const Values& p) {
            return evaluator_of(
                SimpleWave::hump(p.at("gravity"), p.at("still_depth"), p.at("amplitude"), p.at("centre"),
                                 p.at("length")),
                [](const SimpleWave& solution, std::span<const double> at) {
                  const auto state = solution.at(at[0], at[1]);
                  return Evaluator::Row{state.depth, state.velocity};
                },
                [](const SimpleWave& solution) {
                  return Evaluator::Row{solution.breaking_time(), solution.breaking_place()};
                });
          },
  };
}

}  // namespace seiche::exact
