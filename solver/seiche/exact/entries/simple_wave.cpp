#include "seiche/exact/simple_wave.hpp"

#include "seiche/exact/entries/entries.hpp"

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
                     {"gravity", "m/s^2", 9.81, 1e-6, 1e6, "acceleration of gravity"}},
      .inputs = {"x", "t"},
      .outputs = {{"h", "m", "depth"}, {"u", "m/s", "velocity"}},
      .scalars = {{"breaking_time", "s", "when the wave becomes vertical; no solution from then on"},
                  {"breaking_place", "m", "where it does"}},
      .factory =
          [](const std::map<std::string, double>& p) {
            const auto solution = SimpleWave::hump(p.at("gravity"), p.at("still_depth"), p.at("amplitude"),
                                                   p.at("centre"), p.at("length"));
            return Evaluator{[solution](double x, double, double t) {
                               const auto state = solution.at(x, t);
                               return std::vector<double>{state.depth, state.velocity};
                             },
                             [solution] {
                               return std::vector<double>{solution.breaking_time(), solution.breaking_place()};
                             }};
          },
  };
}

}  // namespace seiche::exact
